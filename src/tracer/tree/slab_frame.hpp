#pragma once
// What slab tests in a frame have in common, for one ray or a group. Compiled in the namespace LANCER_TARGET;
// see floats.hpp.

#include <algorithm>
#include <array>
#include <cmath>

#include "tracer/tree/floats.hpp"
#include "tracer/tree/node.hpp"

namespace lancer::tracer::LANCER_TARGET {

/// Distances are in the frame's unit and begin where rays come near the frame's boxes, so that they are no
/// larger than those for all that floats can tell.
class SlabFrame {
 public:
  /// The distance in the frame's unit, or somewhat more.
  LANCER_INLINE float limit(double distance) const {
    const double in_frame = distance * scale_ - before_;
    return static_cast<float>(std::min(in_frame + std::fabs(in_frame) * k_slack + later_, k_huge));
  }

 protected:
  static constexpr double k_slack = 0x1p-22;  // see Slabs8
  static constexpr double k_steepest = 0x1p60;
  static constexpr double k_huge = 0x1p120;
  static constexpr double k_everywhere = 0x1p62;

  /// Begins distances `before` further on, for origins within `reach` of the frame's. Returns how far
  /// rounding may move what is there; k_everywhere: as far away as this everything is met.
  LANCER_INLINE double leave_out(double before, double reach) {
    before_ = std::max(0.0, before);
    const double rounding = (reach + before_) * 0x1p-44;
    if (rounding < 1) return rounding;
    before_ = 0;
    return k_everywhere;
  }
  LANCER_INLINE double before() const { return before_; }

  LANCER_INLINE void set_frame(const Frame& frame) { scale_ = frame.inverse_scale; }
  LANCER_INLINE double scale() const { return scale_; }

  /// Once it is known how far rounding may move what is met.
  LANCER_INLINE void set_far(double far) {
    start_ = splat(static_cast<float>(-far));
    later_ = far;
  }
  LANCER_INLINE Floats start() const { return start_; }

  /// Along an axis rays meet the upper sides first, or the lower ones.
  LANCER_INLINE void set_sides(std::size_t axis, bool upper_first) {
    const std::size_t upper = upper_first ? 1 : 0;
    near_side_[axis] = 2 * axis + upper;
    far_side_[axis] = 2 * axis + 1 - upper;
  }
  LANCER_INLINE Floats near(const Node& node, std::size_t axis) const {
    return load(node.sides[near_side_[axis]].data());
  }
  LANCER_INLINE Floats far(const Node& node, std::size_t axis) const {
    return load(node.sides[far_side_[axis]].data());
  }

 private:
  Floats start_;
  std::array<std::size_t, 3> near_side_, far_side_;
  double scale_ = 1;
  double before_ = 0;  // the distance left out
  double later_ = 0;
};

}  // namespace lancer::tracer::LANCER_TARGET
