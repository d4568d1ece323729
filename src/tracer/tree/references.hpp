#pragma once
// The items of a tree that is being built, in an order that becomes that of the leaves.

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "tracer/tree/cells.hpp"
#include "tracer/tree/node.hpp"

namespace lancer::tracer {

/// Some of the references, begin .. end - 1, and what they fill.
struct Range {
  std::uint32_t begin = 0, end = 0;
  CellBox box;
  Cells least_center = cells_of(INT16_MAX), most_center = cells_of(INT16_MIN);

  Range() = default;
  Range(std::uint32_t first, std::uint32_t past) : begin(first), end(past) {}

  std::uint32_t count() const { return end - begin; }
  void add(CellBox reference) {
    box.add(reference);
    const Cells at = center(reference.cells);
    least_center = lesser(least_center, at);
    most_center = greater(most_center, at);
  }
  void add(const Range& other) {  // begin and end stay
    box.add(other.box);
    least_center = lesser(least_center, other.least_center);
    most_center = greater(most_center, other.most_center);
  }
};

class References {
 public:
  explicit References(std::uint32_t count) : boxes_(new Cells[count]) {}

  CellBox operator[](std::uint32_t at) const { return {boxes_[at]}; }
  /// Its number, and whether it is the last one of a leaf.
  std::uint32_t item(std::uint32_t at) const {
    const auto v = values(boxes_[at]);
    return static_cast<std::uint16_t>(v[6]) | std::uint32_t{static_cast<std::uint16_t>(v[7])} << 16;
  }
  /// `sides`: the lower and the upper ones.
  void set(std::uint32_t at, const std::array<std::int16_t, 6>& sides, std::uint32_t item) {
    const auto turned = [](std::int16_t v) { return static_cast<std::int16_t>(~v); };
    boxes_[at] =
        cells_from({sides[0], sides[1], sides[2], turned(sides[3]), turned(sides[4]), turned(sides[5]),
                    static_cast<std::int16_t>(item), static_cast<std::int16_t>(item >> 16)});
  }
  /// The item is the last one of a leaf.
  void mark_last(std::uint32_t at) {
    auto v = values(boxes_[at]);
    v[7] = static_cast<std::int16_t>(v[7] | INT16_MIN);
    boxes_[at] = cells_from(v);
  }
  void swap(std::uint32_t a, std::uint32_t b) { std::swap(boxes_[a], boxes_[b]); }

 private:
  std::unique_ptr<Cells[]> boxes_;
};

}  // namespace lancer::tracer
