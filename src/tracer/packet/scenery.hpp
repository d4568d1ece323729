#pragma once
// A world as packets of rays read it.

#include <vector>

#include "tracer/intersect.hpp"
#include "tracer/packet/wave.hpp"
#include "tracer/plan.hpp"

namespace lancer::tracer {

/// What kernels read, and who owns it. The world must outlive it.
class PacketWorld {
 public:
  PacketWorld(const World& world, ShadowWork shadows);
  PacketWorld(const PacketWorld&) = delete;
  PacketWorld& operator=(const PacketWorld&) = delete;

  const Scenery& scenery() const { return scenery_; }
  /// May light go on from the primitive in two ways?
  bool splits(std::uint32_t primitive) const { return splits_[primitive] != 0; }

 private:
  Scenery scenery_;
  std::vector<std::uint32_t> listed_;
  std::vector<Shade> shade_;
  std::vector<std::uint8_t> splits_;
};

/// Finishes a hit on a surface without a kernel, the only candidate of the ray: as closest() does. False
/// where there is more to it.
bool land_alone(const World& world, const Ray& ray, std::uint32_t primitive, Hit& hit);

}  // namespace lancer::tracer
