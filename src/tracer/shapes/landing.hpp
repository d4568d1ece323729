#pragma once
// Where a ray lands, to the last bit. The tests of many surfaces are made in plain doubles; for the one that
// a ray ends at, the distance is corrected by what the surface's equation still leaves at it, computed in
// twice the precision (one step of Newton's iteration; the correction itself needs few bits). Where that is
// not enough - at a tangent, in the plane of a surface - exact arithmetic answers (careful.hpp).

#include <array>

#include "tracer/numeric.hpp"
#include "tracer/ray.hpp"

namespace lancer::tracer {

/// A crossing with its place. The distance, each coordinate of the point and each component of the normal are
/// within 1 ulp of those of the ray and the surface as their numbers say; a coordinate far below the point's
/// largest one, by more than 2^40, within 1 ulp of that many times less.
struct Landing {
  Root root;  // its bounds are those of the surface's own rounding
  Vec3 point;
  Vec3 normal;  // outward, unit length
};

/// None, one or two, in ascending order of distance.
struct Landings {
  int count = 0;
  std::array<Landing, 2> at{};
};

/// A distance as an unevaluated sum, and how far it may be off.
struct Distance {
  DoubleDouble t;
  double error = 0;
};

using Triple2 = std::array<DoubleDouble, 3>;

/// a - b exactly.
inline Triple2 exact_difference(Vec3 a, Vec3 b) {
  return {two_sum(a.x, -b.x), two_sum(a.y, -b.y), two_sum(a.z, -b.z)};
}
inline Vec3 rounded(const Triple2& v) { return {v[0].hi, v[1].hi, v[2].hi}; }

/// from + t d, off by a few 2^-106 (|from| + |t d|).
inline DoubleDouble advance(DoubleDouble from, double d, DoubleDouble t) {
  const DoubleDouble way = two_product(t.hi, d);
  const DoubleDouble sum = two_sum(from.hi, way.hi);
  return two_sum(sum.hi, sum.lo + (way.lo + t.lo * d + from.lo));
}
inline Triple2 advance(const Triple2& from, Vec3 d, DoubleDouble t) {
  return {advance(from[0], d.x, t), advance(from[1], d.y, t), advance(from[2], d.z, t)};
}

/// What the coordinates of from + t d may be off.
inline Vec3 advance_error(Vec3 from, Vec3 d, const Distance& distance) {
  const Vec3 way = abs(d) * std::fabs(distance.t.hi);
  return (abs(from) + way) * (8 * k_u * k_u) + abs(d) * distance.error;
}

/// Do these errors leave every component the right double, or its neighbour?
bool settles(Vec3 value, Vec3 error);
inline bool settles(const Distance& distance) {
  return distance.error <= std::fabs(distance.t.hi) * (k_u / 16);
}

/// v / |v|, each component within 0.51 ulp.
Vec3 unit(const Triple2& v);

}  // namespace lancer::tracer
