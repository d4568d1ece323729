#pragma once
// What planes, sides of boxes and facets share: landing on n . (x - at) = level.

#include "tracer/shapes/newton.hpp"

namespace lancer::tracer {

struct Planar {
  Triple2 n;     // of any length
  Vec3 n_terms;  // what its components' errors, a few u^2, are multiples of
  double level = 0;
  Vec3 at;
};

inline Planar planar(Vec3 n, double level, Vec3 at) {
  return {{DoubleDouble{n.x, 0}, DoubleDouble{n.y, 0}, DoubleDouble{n.z, 0}}, abs(n), level, at};
}

/// Do all points of the plane share their coordinate on this axis?
LANCER_INLINE bool is_across(const Planar& plane, int axis) {
  return plane.n_terms[(axis + 1) % 3] == 0 && plane.n_terms[(axis + 2) % 3] == 0;
}

/// That coordinate is what the plane says, and needs no ray.
inline void snap(const Planar& plane, Vec3& point) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!is_across(plane, axis)) continue;
    const DoubleDouble n = plane.n[static_cast<std::size_t>(axis)];
    point[axis] = plane.level == 0 ? plane.at[axis] : (plane.at[axis] + DoubleDouble{plane.level, 0} / n).hi;
  }
}

/// What the equation leaves at a distance along the ray: level - n . (origin + t direction - at).
template <class P>
LANCER_INLINE double residual(const Planar& plane, const Triple2& from, Vec3 direction, DoubleDouble t) {
  Total<P> sum{plane.level, 0};
  const Triple2 w = advance<P>(from, direction, t);
  for (std::size_t i = 0; i < 3; ++i) {
    sum.add_product(-plane.n[i].hi, w[i].hi);
    sum.low -= plane.n[i].hi * w[i].lo + plane.n[i].lo * w[i].hi;
  }
  return sum.value();
}

/// The distance near t at which the plane is met.
template <class P>
LANCER_INLINE Distance meet(const Planar& plane, const Triple2& from, Vec3 direction, double t) {
  const double terms = dot(plane.n_terms, abs(direction));
  const double inverse = 1 / dot(rounded(plane.n), direction);
  const double steep = std::fabs(inverse);
  const double doubt = 8 * k_u * terms * steep + 2 * k_u;  // relative, of a correction
  const double fixed = std::fabs(plane.level) + dot(plane.n_terms, abs(rounded(from)));
  Distance at{{t, 0}, 0};
  for (int step = 0; step < 3; ++step) {
    const double correction = residual<P>(plane, from, direction, at.t) * inverse;
    at.t = two_sum(at.t.hi, at.t.lo + correction);
    const double unknown =
        32 * k_u * k_u * steep * (fixed + terms * (std::fabs(at.t.hi) + std::fabs(correction)));
    const double left = std::fabs(correction) * doubt;
    at.error = unknown + left;
    if (left <= 16 * unknown) break;
  }
  return at;
}

/// Fills the distance and the point; false where twice the precision is not enough.
template <class P>
LANCER_INLINE bool land_by(const Planar& plane, Vec3 origin, Vec3 direction, Landing& landing) {
  const Distance distance = meet<P>(plane, exact_difference(origin, plane.at), direction, landing.root.t);
  if (!settles(distance.t.hi, distance.error)) return false;
  const Triple2 start{DoubleDouble{origin.x, 0}, DoubleDouble{origin.y, 0}, DoubleDouble{origin.z, 0}};
  landing.root.t = distance.t.hi;
  landing.point = rounded(advance<P>(start, direction, distance.t));
  Vec3 error = advance_error(origin, direction, distance);
  for (int axis = 0; axis < 3; ++axis) {
    if (is_across(plane, axis)) error[axis] = 0;
  }
  if (!settles(landing.point, error)) return false;
  snap(plane, landing.point);
  return true;
}

}  // namespace lancer::tracer
