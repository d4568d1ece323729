#pragma once
// The crossings of a ray with a surface in exact arithmetic, for the rays of which the quick tests cannot
// tell: every answer is that of the numbers as they are. A thousand times slower than those; where a facet is
// met, without the place, some thirty times, so that meshes whose corners lie on the rays of a picture draw.

#include "tracer/shapes/box.hpp"
#include "tracer/shapes/ellipsoid.hpp"
#include "tracer/shapes/facet.hpp"
#include "tracer/shapes/landing.hpp"
#include "tracer/shapes/plane.hpp"
#include "tracer/shapes/sphere.hpp"

namespace lancer::tracer {

/// Which surface is crossed where in the order of the ray is exact in any case; `distances` leaves the points
/// rough and the normals out.
enum class Detail : std::uint8_t { distances, places };

Landings careful(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction, Detail detail);
Landings careful(const EllipsoidPrimitive& ellipsoid, Vec3 origin, Vec3 direction, Detail detail);
Landings careful(const PlanePrimitive& plane, Vec3 origin, Vec3 direction, Detail detail);
/// Of two sides that the ray crosses at the same distance, that of the lower axis.
Landings careful(const BoxPrimitive& box, Vec3 origin, Vec3 direction, Detail detail);
Landings careful(const FacetPrimitive& facet, Vec3 origin, Vec3 direction, Detail detail);

/// Are the corners not on a line?
bool careful_has_area(const FacetPrimitive& facet);

/// The sign of side(): -1 inside, 0 exactly on the surface, 1 outside.
int careful_side(const SpherePrimitive& sphere, Vec3 p);
int careful_side(const EllipsoidPrimitive& ellipsoid, Vec3 p);
int careful_side(const PlanePrimitive& plane, Vec3 p);
int careful_side(const BoxPrimitive& box, Vec3 p);

}  // namespace lancer::tracer
