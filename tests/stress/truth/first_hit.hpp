#pragma once
// What a ray truly meets: the surfaces are what the numbers of the prepared primitives say, taken exactly,
// the ray is origin + t direction with its own numbers taken exactly, and t counts in units of the direction.
// All signs are decided exactly; nothing is shared with the tracer's arithmetic.

#include "stress/truth/number.hpp"
#include "tracer/shapes/ellipsoid.hpp"
#include "tracer/shapes/plane.hpp"
#include "tracer/shapes/sphere.hpp"

namespace lancer::stress {

struct Truth {
  bool hit = false;
  bool entering = true;
  Real t;
  Real3 point, normal;   // the normal is outward and of unit length
  bool in_band = false;  // a change of the ray's or the surface's numbers within 4 ulp changes what is met
  // The start, which is on the surface but for rounding, lies outside, and the line misses: both a miss and
  // an exit within t are right.
  bool open = false;
};

/// A straight way to look along.
struct Sight {
  Vec3 origin, direction;
  bool from_surface = false;  // starts on the surface and leaves it, to the side that the direction points to
};

/// A line that touches the surface hits it.
Truth first_hit(const tracer::SpherePrimitive& sphere, const Sight& sight);
Truth first_hit(const tracer::EllipsoidPrimitive& ellipsoid, const Sight& sight);
/// A line that lies in the plane, or meets it where no double reaches, misses it.
Truth first_hit(const tracer::PlanePrimitive& plane, const Sight& sight);

}  // namespace lancer::stress
