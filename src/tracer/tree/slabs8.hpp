#pragma once
// Where a ray meets the boxes of a node's children, all eight at once, in floats: never less than what
// interval() tells of the boxes in doubles. Compiled in the namespace LANCER_TARGET; see floats.hpp.

#include "tracer/ray.hpp"
#include "tracer/tree/slab_frame.hpp"

namespace lancer::tracer::LANCER_TARGET {

/// A ray in a frame, as far as boxes go.
///
/// With v = 2^-24, i the rounded inverse of a component d of the direction, o the origin's and s a side's
/// coordinate, |s| <= 1/2, the distance s i + (-o i) is off from (s - o) / d by no more than
/// v |i| (|s| + |o| + 2 |s - o|) <= 3 v |i| (1/2 + |o|): a rounding each for s i, for -o i, for i and for the
/// sum. k_slack is 4 v; what is left is ample for the roundings in doubles, of interval() too, and for
/// components that are taken to be larger than they are.
class Slabs8 : public SlabFrame {
 public:
  LANCER_INLINE Slabs8(const Frame& frame, const Probe& probe) {
    Vec3 origin = (probe.origin - frame.origin) * frame.inverse_scale;
    const double reach = std::max(std::fabs(origin.x), std::max(std::fabs(origin.y), std::fabs(origin.z)));
    double far = 0;
    if (!(reach <= 4)) far = approach(origin, probe.direction, reach);
    set_frame(frame);
    set_far(far);
    // The three axes at once; the fourth number is of no matter.
    const Doubles o{origin.x, origin.y, origin.z, 0};
    Doubles inverse{probe.inverse.x, probe.inverse.y, probe.inverse.z, 1};
    inverse = inverse < -k_steepest ? all(-k_steepest) : inverse;
    const Quad i = __builtin_convertvector(inverse > k_steepest ? all(k_steepest) : inverse, Quad);
    const Doubles wide = __builtin_convertvector(i, Doubles);
    const Doubles at = -o * wide;
    const Doubles slack = ((0.5 + abs(o)) * k_slack + far) * abs(wide);
    const Doubles nearest = at - slack, farthest = at + slack;
    const Quad near_side = __builtin_convertvector(nearest < -k_huge ? all(-k_huge) : nearest, Quad);
    const Quad far_side = __builtin_convertvector(farthest > k_huge ? all(k_huge) : farthest, Quad);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      set_sides(axis, std::signbit(i[axis]));
      inverse_[axis] = splat(i[axis]);
      near_[axis] = splat(near_side[axis]);
      far_[axis] = splat(far_side[axis]);
    }
  }

  /// A bit for each child that the ray may meet up to the limit; `enter` is where.
  LANCER_INLINE unsigned meets(const Node& node, float limit, float* enter) const {
    Floats first = start(), last = splat(limit);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      first = greater(times_plus(near(node, axis), inverse_[axis], near_[axis]), first);
      last = lesser(times_plus(far(node, axis), inverse_[axis], far_[axis]), last);
    }
    store(enter, first);
    return at_most(first, last);
  }

 private:
  using Doubles [[gnu::vector_size(32)]] = double;
  using Quad [[gnu::vector_size(16)]] = float;

  LANCER_INLINE static Doubles all(double v) { return Doubles{v, v, v, v}; }
  LANCER_INLINE static Doubles abs(Doubles v) {
    return Doubles{std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2]), std::fabs(v[3])};
  }

  /// Moves the origin along the ray to where it comes near the boxes, all of which lie within a distance of
  /// 1 from the frame's origin; returns how far rounding may move what is there.
  [[gnu::noinline]] double approach(Vec3& origin, Vec3 direction, double reach) {
    const double far = leave_out(-dot(origin, direction) / dot(direction, direction) - 2, reach);
    origin = far == k_everywhere ? Vec3{} : origin + direction * before();
    return far;
  }

  std::array<Floats, 3> inverse_, near_, far_;
};

}  // namespace lancer::tracer::LANCER_TARGET
