#pragma once
// Where a ray lands, to the last bit. The tests of many surfaces are made in plain doubles; for the one that
// a ray ends at, the distance is corrected by what the surface's equation still leaves at it, computed in
// twice the precision (one step of Newton's iteration; the correction itself needs few bits). Where that is
// not enough - at a tangent, in the plane of a surface - exact arithmetic answers (careful.hpp).

#include <array>

#include "tracer/numeric.hpp"
#include "tracer/ray.hpp"

namespace lancer::tracer {

/// How far before and behind its distance a crossing may be.
struct Span {
  double before = 0, after = 0;
};

/// A crossing with its place. The distance, each coordinate of the point and each component of the normal are
/// within 1 ulp of those of the ray and the surface as their numbers say; a coordinate far below the point's
/// largest one, by more than 2^40, within 1 ulp of that many times less.
struct Landing {
  Root root;        // its error is that of the surface's own slack
  double rest = 0;  // what rounding took from the distance
  double tilt = 0;  // how far the surface's own rounding may turn it, as a part of its slope along the ray
  Vec3 point;
  Vec3 normal;  // outward, unit length

  /// Where the crossing may be for the surface's own rounding. For a ray that all but lies in a surface this
  /// is far wider than the error.
  Span span() const;
};

/// By how much a is farther than b, to more digits than their distances have.
inline double gap(const Landing& a, const Landing& b) { return (a.root.t - b.root.t) + (a.rest - b.rest); }

/// None, one or two, in ascending order of distance.
struct Landings {
  int count = 0;
  std::array<Landing, 2> at{};

  Roots roots() const { return {count, {at[0].root, at[1].root}}; }
};

/// Of these the one that enters, or leaves, where it lies ahead of the ray's start.
inline bool take(const Landings& found, bool entering, Landing& landing) {
  const Landing& one = found.at[found.count == 2 && !entering ? 1 : 0];
  if (found.count == 0 || !(one.root.t > 0)) return false;
  landing = one;
  return true;
}

using Triple2 = std::array<DoubleDouble, 3>;

/// a - b exactly.
inline Triple2 exact_difference(Vec3 a, Vec3 b) {
  return {two_sum(a.x, -b.x), two_sum(a.y, -b.y), two_sum(a.z, -b.z)};
}
inline Vec3 rounded(const Triple2& v) { return {v[0].hi, v[1].hi, v[2].hi}; }

/// v times the power of two that brings its largest component next to 1; 0 stays 0.
Triple2 near_one(const Triple2& v);

/// v / |v|, each component within 0.51 ulp.
Vec3 unit(const Triple2& v);
inline Vec3 unit(Vec3 v) {
  return unit(Triple2{DoubleDouble{v.x, 0}, DoubleDouble{v.y, 0}, DoubleDouble{v.z, 0}});
}

}  // namespace lancer::tracer
