#pragma once
// A world as packets of rays read it.

#include <vector>

#include "tracer/intersect.hpp"
#include "tracer/packet/looks.hpp"
#include "tracer/packet/wave.hpp"
#include "tracer/plan.hpp"

namespace lancer::tracer {

/// What kernels read, and who owns it. The world must outlive it.
class PacketWorld {
 public:
  PacketWorld(const World& world, const Plan& plan);
  PacketWorld(const PacketWorld&) = delete;
  PacketWorld& operator=(const PacketWorld&) = delete;

  const Scenery& scenery() const { return scenery_; }
  const Looks& looks() const { return looks_; }

 private:
  Looks looks_;
  Scenery scenery_;
  std::vector<std::uint32_t> listed_;
  std::vector<Shade> shade_;
};

/// Finishes a hit on a surface without a kernel, the only candidate of the ray: as closest() does. `exits`:
/// it is the way out of the solid that the ray starts on. False where there is more to it.
bool land_alone(const World& world, const Ray& ray, std::uint32_t primitive, bool exits, Hit& hit);

}  // namespace lancer::tracer
