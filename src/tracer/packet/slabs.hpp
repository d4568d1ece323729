#pragma once
// Where any ray of a group may meet the boxes of a node's children, all eight at once, in floats. Per axis
// the group is an interval of origins and one of inverse directions, and what a box's side is away from it is
// between those of their ends (Wald, Boulos, Shirley, Ray Tracing Deformable Scenes Using Dynamic Bounding
// Volume Hierarchies, 2007); each end has the bounds of a single ray, see Slabs8. Compiled in the namespace
// LANCER_TARGET.

#include "tracer/packet/surfaces.hpp"
#include "tracer/tree/slab_frame.hpp"

namespace lancer::tracer::LANCER_TARGET {

inline constexpr std::size_t k_vectors = k_group / 4;

/// The least and the largest of numbers.
struct Range {
  double lo = k_infinity, hi = -k_infinity;
};

/// Of those of the active lanes.
struct Ranges {
  Lanes lo = lanes(k_infinity), hi = lanes(-k_infinity);

  LANCER_INLINE void add(Lanes values, Mask active) {
    lo = lesser(lo, select(active, values, lanes(k_infinity)));
    hi = greater(hi, select(active, values, lanes(-k_infinity)));
  }
  LANCER_INLINE Range all() const {
    return {std::min(std::min(lo[0], lo[1]), std::min(lo[2], lo[3])),
            std::max(std::max(hi[0], hi[1]), std::max(hi[2], hi[3]))};
  }
};

class GroupSlabs : public SlabFrame {
 public:
  LANCER_INLINE GroupSlabs(const Frame& frame, const Probes* probes) {
    set_frame(frame);
    std::array<Range, 3> origins;
    double reach = 0;
    for (int axis = 0; axis < 3; ++axis) {
      Ranges all;
      for (std::size_t k = 0; k < k_vectors; ++k) all.add(probes[k].origin[axis], probes[k].active);
      Range& range = origins[static_cast<std::size_t>(axis)];
      range = all.all();
      range.lo = (range.lo - frame.origin[axis]) * scale();
      range.hi = (range.hi - frame.origin[axis]) * scale();
      reach = std::max(reach, std::max(std::fabs(range.lo), std::fabs(range.hi)));
    }
    double far = 0;
    if (!(reach <= 4)) far = approach(frame, probes, origins, reach);
    set_far(far);
    for (int axis = 0; axis < 3; ++axis) set_axis(axis, probes, origins[static_cast<std::size_t>(axis)], far);
  }

  /// A bit for each child that a ray may meet up to the limit; `enter` is where.
  LANCER_INLINE unsigned meets(const Node& node, float limit, float* enter) const {
    Floats first = start(), last = splat(limit);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Floats nearer = near(node, axis), farther = far(node, axis);
      const End &a = ends_[axis][0], &b = ends_[axis][1];
      first = greater(lesser(times_plus(nearer, a.inverse, a.near), times_plus(nearer, b.inverse, b.near)),
                      first);
      last =
          lesser(greater(times_plus(farther, a.inverse, a.far), times_plus(farther, b.inverse, b.far)), last);
    }
    store(enter, first);
    return at_most(first, last);
  }

 private:
  /// For one end of the inverse directions.
  struct End {
    Floats inverse, near, far;
  };

  LANCER_INLINE void set_axis(int axis, const Probes* probes, const Range& origin, double far) {
    const auto a = static_cast<std::size_t>(axis);
    Ranges inverses;
    unsigned forwards = 0, backwards = 0;
    for (std::size_t k = 0; k < k_vectors; ++k) {
      const unsigned active = bits(probes[k].active), negative = bits(is_negative(probes[k].inverse[axis]));
      backwards |= active & negative;
      forwards |= active & ~negative;
      inverses.add(probes[k].inverse[axis], probes[k].active);
    }
    const Range inverse = inverses.all();
    const bool both = forwards != 0 && backwards != 0;
    const bool upper = backwards != 0 && !both;
    set_sides(a, upper);
    if (both) {
      // This axis bounds nothing but places without a child, whose sides are infinite.
      const Floats none = splat(0x1p-100F);
      ends_[a] = {End{none, splat(static_cast<float>(-k_huge)), splat(static_cast<float>(k_huge))},
                  End{none, splat(static_cast<float>(-k_huge)), splat(static_cast<float>(k_huge))}};
      return;
    }
    const double behind = upper ? origin.lo : origin.hi;  // the sides are nearest from there
    const double ahead = upper ? origin.hi : origin.lo;
    for (std::size_t end = 0; end < 2; ++end) {
      const double steep = std::clamp(end == 0 ? inverse.lo : inverse.hi, -k_steepest, k_steepest);
      const auto i = static_cast<float>(steep);
      const double own = static_cast<double>(i), size = std::fabs(own);
      const double near = -behind * own - ((0.5 + std::fabs(behind)) * k_slack + far) * size;
      const double last = -ahead * own + ((0.5 + std::fabs(ahead)) * k_slack + far) * size;
      ends_[a][end] = {splat(i), splat(static_cast<float>(std::max(near, -k_huge))),
                       splat(static_cast<float>(std::min(last, k_huge)))};
    }
  }

  /// Moves the origins along the rays, all as far, to where the first of them comes near the boxes; see
  /// Slabs8.
  [[gnu::noinline]] double approach(const Frame& frame, const Probes* probes, std::array<Range, 3>& origins,
                                    double reach) {
    Ranges nearest;
    std::array<Vectors, k_vectors> own;
    for (std::size_t k = 0; k < k_vectors; ++k) {
      own[k] = (probes[k].origin - vectors(frame.origin)) * lanes(scale());
      const Vectors& d = probes[k].direction;
      nearest.add(-dot(own[k], d) / dot(d, d) - lanes(2.0), probes[k].active);
    }
    const double far = leave_out(nearest.all().lo, reach);
    if (far == k_everywhere) {
      origins = {Range{0, 0}, Range{0, 0}, Range{0, 0}};
      return far;
    }
    for (int axis = 0; axis < 3; ++axis) {
      Ranges moved;
      for (std::size_t k = 0; k < k_vectors; ++k)
        moved.add(own[k][axis] + probes[k].direction[axis] * lanes(before()), probes[k].active);
      origins[static_cast<std::size_t>(axis)] = moved.all();
    }
    return far;
  }

  std::array<std::array<End, 2>, 3> ends_;
};

}  // namespace lancer::tracer::LANCER_TARGET
