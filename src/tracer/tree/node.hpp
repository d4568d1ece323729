#pragma once
// What a tree of boxes is made of. Boxes are kept as floats in a frame, in which all that is in the tree lies
// within [-1/2, 1/2]: so no scene is too large, too small or too far away for them. Where a part of the tree
// is too small in its frame for floats to tell its items apart, that part has a frame of its own.

#include <array>
#include <cstdint>

#include "base/vec.hpp"

namespace lancer::tracer {

/// What a node leads to: another node, a list of items, or a part of the tree that has its own frame.
class Child {
 public:
  static constexpr Child node(std::uint32_t index) { return Child(index); }
  static constexpr Child leaf(std::uint32_t first_item) { return Child(first_item | k_leaf); }
  static constexpr Child part(std::uint32_t index) { return Child(index | k_part); }
  static constexpr Child none() { return Child(k_leaf | k_part); }
  constexpr Child() = default;
  constexpr explicit Child(std::uint32_t bits) : bits_(bits) {}

  bool is_node() const { return bits_ < k_part; }
  bool is_leaf() const { return (bits_ & k_leaf) != 0; }
  bool is_none() const { return bits_ == none().bits_; }
  std::uint32_t index() const { return bits_ & ~(k_leaf | k_part); }
  std::uint32_t bits() const { return bits_; }

 private:
  static constexpr std::uint32_t k_leaf = 1U << 31, k_part = 1U << 30;
  std::uint32_t bits_;
};

inline constexpr std::size_t k_width = 8;

/// Up to eight children and their boxes, side by side (Ernst and Greiner 2008; Wald, Benthin, Boulos 2008).
/// A place without a child has a box that no ray meets: its lower sides are at +infinity, the upper ones at
/// -infinity.
struct alignas(32) Node {
  using Sides = std::array<float, k_width>;
  std::array<Sides, 6> sides;  // 2 axis, + 1 for the upper side
  std::array<Child, k_width> children;
};
static_assert(sizeof(Node) == 224);

/// Where world coordinates p are (p - origin) inverse_scale; a power of two, so that no digit is lost.
struct Frame {
  Vec3 origin;
  double inverse_scale = 1;
  std::uint32_t root = 0;  // the node that holds all that is in it
};

/// In a leaf's list of items the last one is marked by this bit.
inline constexpr std::uint32_t k_last_item = 1U << 31;

}  // namespace lancer::tracer
