#pragma once
// A range of references sorted into a few bins along each axis, to tell where to cut it.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "tracer/tree/references.hpp"

namespace lancer::tracer {

/// Which bin a centre is in, along each axis.
class Binning {
 public:
  static constexpr std::size_t k_most = 16;

  /// Few references are cut about as well with few bins, and much sooner.
  explicit Binning(const Range& range)
      : count_(std::min<std::size_t>(k_most, 4 + range.count() / 4)), least_(range.least_center) {
    const auto least = values(range.least_center), most = values(range.most_center);
    std::array<std::int16_t, 8> scale{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto cells = static_cast<std::uint32_t>(most[axis] - least[axis] + 1);
      const auto bins_per_cell = static_cast<std::uint32_t>(count_ << 16) / cells;
      scale[axis] = static_cast<std::int16_t>(std::min(bins_per_cell, 0xFFFFU));
    }
    scale_ = cells_from(scale);
  }

  std::size_t count() const { return count_; }
  std::array<std::size_t, 3> bins(CellBox box) const { return scaled(center(box.cells), least_, scale_); }

 private:
  std::size_t count_;
  Cells least_, scale_;
};

/// Between two bins.
struct Cut {
  std::size_t axis = 0;
  std::size_t bin = 0;  // the first of the upper part

  bool exists() const { return bin > 0; }
};

/// What is in each bin.
class Bins {
 public:
  explicit Bins(std::size_t count) : count_(count) {
    for (auto& row : boxes_) std::fill_n(row.begin(), count, CellBox{});
    for (auto& row : counts_) std::fill_n(row.begin(), count, 0U);
  }

  void add(CellBox box, const std::array<std::size_t, 3>& bins) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      boxes_[axis][bins[axis]].add(box);
      ++counts_[axis][bins[axis]];
    }
  }
  void add(const Bins& other) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t bin = 0; bin < count_; ++bin) {
        boxes_[axis][bin].add(other.boxes_[axis][bin]);
        counts_[axis][bin] += other.counts_[axis][bin];
      }
    }
  }

  /// The cut with the least sum of surface times number; none where all is in one bin.
  Cut best() const {
    Cut best;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) best_along(axis, least, best);
    return best;
  }

 private:
  void best_along(std::size_t axis, float& least, Cut& best) const {
    const auto& boxes = boxes_[axis];
    const auto& counts = counts_[axis];
    std::array<float, Binning::k_most> upper_cost;
    CellBox upper;
    std::uint32_t upper_count = 0;
    for (std::size_t bin = count_ - 1; bin > 0; --bin) {
      upper.add(boxes[bin]);
      upper_count += counts[bin];
      upper_cost[bin] = upper_count > 0 ? upper.half_area() * static_cast<float>(upper_count)
                                        : std::numeric_limits<float>::infinity();
    }
    CellBox lower;
    std::uint32_t lower_count = 0;
    for (std::size_t bin = 1; bin < count_; ++bin) {
      lower.add(boxes[bin - 1]);
      lower_count += counts[bin - 1];
      if (lower_count == 0) continue;
      const float cost = lower.half_area() * static_cast<float>(lower_count) + upper_cost[bin];
      if (cost < least) {
        least = cost;
        best = {axis, bin};
      }
    }
  }

  std::size_t count_;
  std::array<std::array<CellBox, Binning::k_most>, 3> boxes_;
  std::array<std::array<std::uint32_t, Binning::k_most>, 3> counts_;
};

}  // namespace lancer::tracer
