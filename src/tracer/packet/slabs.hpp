#pragma once
// Where any ray of a group may meet the boxes of a node's children, all eight at once, in floats. Per axis
// the group is an interval of origins and one of inverse directions, and what a box's side is away from it is
// between those of their ends (Wald, Boulos, Shirley, Ray Tracing Deformable Scenes Using Dynamic Bounding
// Volume Hierarchies, 2007); each end has the bounds of a single ray, see Slabs8. Compiled in the namespace
// LANCER_TARGET.

#include "tracer/packet/surfaces.hpp"
#include "tracer/tree/floats.hpp"

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

class GroupSlabs {
 public:
  LANCER_INLINE GroupSlabs(const Frame& frame, const Probes* probes) {
    scale_ = frame.inverse_scale;
    std::array<Range, 3> origins;
    double reach = 0;
    for (int axis = 0; axis < 3; ++axis) {
      Ranges all;
      for (std::size_t k = 0; k < k_vectors; ++k) all.add(probes[k].origin[axis], probes[k].active);
      Range& range = origins[static_cast<std::size_t>(axis)];
      range = all.all();
      range.lo = (range.lo - frame.origin[axis]) * scale_;
      range.hi = (range.hi - frame.origin[axis]) * scale_;
      reach = std::max(reach, std::max(std::fabs(range.lo), std::fabs(range.hi)));
    }
    double far = 0;
    if (!(reach <= 4)) far = approach(frame, probes, origins, reach);
    start_ = splat(static_cast<float>(-far));
    later_ = far;
    for (int axis = 0; axis < 3; ++axis) set_axis(axis, probes, origins[static_cast<std::size_t>(axis)], far);
  }

  /// The distance in the frame's unit, or somewhat more.
  LANCER_INLINE float limit(double distance) const {
    const double in_frame = distance * scale_ - before_;
    return static_cast<float>(std::min(in_frame + std::fabs(in_frame) * k_slack + later_, k_huge));
  }

  /// A bit for each child that a ray may meet up to the limit; `enter` is where.
  LANCER_INLINE unsigned meets(const Node& node, float limit, float* enter) const {
    Floats first = start_, last = splat(limit);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Floats near = load(node.sides[near_side_[axis]].data());
      const Floats far = load(node.sides[far_side_[axis]].data());
      const End &a = ends_[axis][0], &b = ends_[axis][1];
      first =
          greater(lesser(times_plus(near, a.inverse, a.near), times_plus(near, b.inverse, b.near)), first);
      last = lesser(greater(times_plus(far, a.inverse, a.far), times_plus(far, b.inverse, b.far)), last);
    }
    store(enter, first);
    return at_most(first, last);
  }

 private:
  static constexpr double k_slack = 0x1p-22;
  static constexpr double k_steepest = 0x1p60;
  static constexpr double k_huge = 0x1p120;

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
    const std::size_t upper = backwards != 0 && !both ? 1 : 0;
    near_side_[a] = 2 * a + upper;
    far_side_[a] = 2 * a + 1 - upper;
    if (both) {
      // This axis bounds nothing but places without a child, whose sides are infinite.
      const Floats none = splat(0x1p-100F);
      ends_[a] = {End{none, splat(static_cast<float>(-k_huge)), splat(static_cast<float>(k_huge))},
                  End{none, splat(static_cast<float>(-k_huge)), splat(static_cast<float>(k_huge))}};
      return;
    }
    const double behind = upper != 0 ? origin.lo : origin.hi;  // the sides are nearest from there
    const double ahead = upper != 0 ? origin.hi : origin.lo;
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
    Ranges before;
    std::array<Vectors, k_vectors> own;
    for (std::size_t k = 0; k < k_vectors; ++k) {
      own[k] = (probes[k].origin - vectors(frame.origin)) * lanes(scale_);
      const Vectors& d = probes[k].direction;
      before.add(-dot(own[k], d) / dot(d, d) - lanes(2.0), probes[k].active);
    }
    before_ = std::max(0.0, before.all().lo);
    const double rounding = (reach + before_) * 0x1p-44;
    // As far away as this everything is met.
    if (!(rounding < 1)) {
      before_ = 0;
      origins = {Range{0, 0}, Range{0, 0}, Range{0, 0}};
      return 0x1p62;
    }
    for (int axis = 0; axis < 3; ++axis) {
      Ranges moved;
      for (std::size_t k = 0; k < k_vectors; ++k)
        moved.add(own[k][axis] + probes[k].direction[axis] * lanes(before_), probes[k].active);
      origins[static_cast<std::size_t>(axis)] = moved.all();
    }
    return rounding;
  }

  std::array<std::array<End, 2>, 3> ends_;
  Floats start_;
  std::array<std::size_t, 3> near_side_, far_side_;
  double scale_ = 1;
  double before_ = 0;  // the distance left out
  double later_ = 0;
};

}  // namespace lancer::tracer::LANCER_TARGET
