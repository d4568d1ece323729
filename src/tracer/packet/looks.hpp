#pragma once
// What shapes look like, side by side for each primitive and material: what a wave would else ask the scene
// for, hit by hit.

#include <cstdint>
#include <vector>

#include "tracer/plan.hpp"
#include "tracer/world.hpp"

namespace lancer::tracer {

/// How hits land: by a kernel for all of a kind, or one by one.
enum class Ground : std::uint8_t {
  sphere,
  plane_x,
  plane_y,
  plane_z,
  tilted_plane,
  facet,
  box,
  turned_box,
  other
};
inline constexpr std::size_t k_grounds = 9;

/// A primitive.
struct Look {
  std::uint32_t shape = 0;
  std::uint32_t material = 0;
  Ground ground = Ground::other;
  bool is_plain = true;   // its normal is the surface's, and no colour depends on the point
  bool is_convex = true;  // a convex solid
};

/// A material without patterns.
struct Paint {
  Color own;  // the light of its own: ambient
  Color diffuse, specular, reflection, transmission;
  double shininess = 1;
  long long fresnel = 0, direct = 0, onward = 0;  // all bits, or none; see MaterialNeeds
};

struct Looks {
  std::vector<Look> primitives;
  std::vector<Paint> materials;

  static Looks of(const World& world, const Plan& plan);
  const Paint& paint(const Look& look) const { return materials[look.material]; }
};

}  // namespace lancer::tracer
