#pragma once
// From boxes in doubles to those that a tree is cut by, and to those that are kept in it.

#include <array>
#include <cstdint>

#include "tracer/aabb.hpp"
#include "tracer/tree/node.hpp"

namespace lancer::tracer {

/// A box of which all numbers are some, and none near the end of the range of numbers.
Aabb tamed(const Aabb& box);

/// The frame for what lies within `bounds`, which is tame.
Frame frame_around(const Aabb& bounds);

/// A box in a frame, not smaller than it is.
struct FrameBox {
  std::array<float, 3> lo, hi;
};
FrameBox in_frame(const Frame& frame, const Aabb& box);

/// Cells over what lies within `bounds`, which is tame.
class Grid {
 public:
  explicit Grid(const Aabb& bounds);
  /// The sides of a box, first the lower ones. Nearly not smaller than it is.
  std::array<std::int16_t, 6> sides(const Aabb& box) const;

 private:
  Vec3 center_, per_cell_;
};

}  // namespace lancer::tracer
