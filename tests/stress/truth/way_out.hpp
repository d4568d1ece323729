#pragma once
// Where a ray that starts on a solid, but for rounding, and goes into it truly leaves it.

#include "stress/truth/number.hpp"
#include "tracer/world.hpp"

namespace lancer::stress::flat {

/// Not judged: the rounding of the start decides.
struct WayOut {
  bool judged = false;
  Real t;
};

/// The farthest facet of the world, whose facets enclose something convex, ahead on the ray.
WayOut farthest_facet(const tracer::World& world, Vec3 origin, Vec3 direction);

/// Of the solid that the primitive bounds, which is convex; a plane's is never judged.
WayOut way_out(const tracer::World& world, std::uint32_t primitive, Vec3 origin, Vec3 direction);

}  // namespace lancer::stress::flat
