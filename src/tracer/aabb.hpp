#pragma once
// Axis-aligned bounding boxes and the one test that the tree makes of them.

#include <algorithm>

#include "tracer/numeric.hpp"
#include "tracer/ray.hpp"

namespace lancer::tracer {

struct Aabb {
  Vec3 lo{k_infinity, k_infinity, k_infinity};
  Vec3 hi = -lo;

  void add(Vec3 p) {
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
  }
  void add(const Aabb& b) {
    add(b.lo);
    add(b.hi);
  }
  Vec3 center() const { return lo * 0.5 + hi * 0.5; }
  bool contains(Vec3 p) const {
    return p.x >= lo.x && p.x <= hi.x && p.y >= lo.y && p.y <= hi.y && p.z >= lo.z && p.z <= hi.z;
  }
  /// Larger on every side by `margin` and by the rounding of its own corners.
  Aabb padded(double margin) const {
    Aabb out;
    for (int axis = 0; axis < 3; ++axis) {
      const double pad = margin + 4 * k_u * std::max(std::fabs(lo[axis]), std::fabs(hi[axis]));
      out.lo[axis] = lo[axis] - pad;
      out.hi[axis] = hi[axis] + pad;
    }
    return out;
  }
};

/// Where a ray may be within a box; empty when enter > leave.
struct Interval {
  double enter = 0, leave = 0;
};

/// The part of [0, infinity) that the ray may spend in the box, never less than the truth (Ize 2013: the far
/// side is moved out by 2 gamma(3)). A larger box never gives a smaller interval, bit for bit, so that a tree
/// of boxes decides as each shape's own box does. A ray that lies in a side's plane (0 times infinity) is not
/// bounded by it: a comparison with NaN is false.
inline Interval interval(const Aabb& box, const Probe& probe) {
  constexpr double k_widen = 1 + 2 * gamma(3);
  Interval out{0, k_infinity};
  for (int axis = 0; axis < 3; ++axis) {
    const double inverse = probe.inverse[axis];
    const bool backwards = std::signbit(inverse);
    const double enter = ((backwards ? box.hi[axis] : box.lo[axis]) - probe.origin[axis]) * inverse;
    const double leave = ((backwards ? box.lo[axis] : box.hi[axis]) - probe.origin[axis]) * inverse * k_widen;
    if (enter > out.enter) out.enter = enter;
    if (leave < out.leave) out.leave = leave;
  }
  return out;
}

}  // namespace lancer::tracer
