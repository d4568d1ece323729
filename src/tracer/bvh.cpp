#include "tracer/bvh.hpp"

#include <algorithm>
#include <numeric>

namespace lancer::tracer {
namespace {

constexpr int k_bins = 16;
constexpr std::uint32_t k_leaf_size = 2;
constexpr int k_heuristic_depth = 48;  // below, halves: 2^32 items are then no deeper than k_max_depth

/// Half the surface, relative to `unit`, so that neither tiny nor huge scenes leave the range of numbers.
double half_area(const Aabb& box, double unit) {
  const Vec3 size = (box.hi - box.lo) / unit;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

struct Split {
  int axis = -1;
  int bin = 0;  // the first of the upper part
  double cost = std::numeric_limits<double>::infinity();
};

class Builder {
 public:
  Builder(const std::vector<Aabb>& boxes, const std::atomic<bool>* cancel, std::vector<Bvh::Node>& nodes,
          std::vector<std::uint32_t>& items)
      : boxes_(boxes), cancel_(cancel), nodes_(nodes), items_(items) {}

  void build(std::uint32_t begin, std::uint32_t end, int depth) {
    const std::size_t here = nodes_.size();
    nodes_.emplace_back();
    Aabb centers;
    for (std::uint32_t i = begin; i < end; ++i) {
      nodes_[here].box.add(boxes_[items_[i]]);
      centers.add(boxes_[items_[i]].center());
    }
    const std::uint32_t count = end - begin;
    if (count <= k_leaf_size || (cancel_ && cancel_->load(std::memory_order_relaxed))) {
      nodes_[here].first = begin;
      nodes_[here].count = count;
      return;
    }
    int axis = 0;
    const std::uint32_t middle = partition(begin, end, centers, depth, axis);
    nodes_[here].axis = static_cast<std::uint8_t>(axis);
    build(begin, middle, depth + 1);
    nodes_[here].first = static_cast<std::uint32_t>(nodes_.size());
    build(middle, end, depth + 1);
  }

 private:
  /// The first item of the upper part, which holds some but not all.
  std::uint32_t partition(std::uint32_t begin, std::uint32_t end, const Aabb& centers, int depth, int& axis) {
    if (depth < k_heuristic_depth) {
      const Split split = best_split(begin, end, centers);
      if (split.axis >= 0) {
        axis = split.axis;
        const auto lower = [&](std::uint32_t item) { return bin_of(item, centers, axis) < split.bin; };
        const auto first = items_.begin() + begin;
        return static_cast<std::uint32_t>(std::partition(first, items_.begin() + end, lower) -
                                          items_.begin());
      }
    }
    const Vec3 size = centers.hi - centers.lo;
    axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const std::uint32_t middle = begin + (end - begin) / 2;
    const int along = axis;
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double ca = boxes_[a].center()[along], cb = boxes_[b].center()[along];
                       return ca < cb || (ca == cb && a < b);
                     });
    return middle;
  }

  int bin_of(std::uint32_t item, const Aabb& centers, int axis) const {
    const double at =
        (boxes_[item].center()[axis] - centers.lo[axis]) / (centers.hi[axis] - centers.lo[axis]);
    return std::min(k_bins - 1, static_cast<int>(at * k_bins));
  }

  Split best_split(std::uint32_t begin, std::uint32_t end, const Aabb& centers) const {
    Split best;
    const double unit = max_abs(centers.hi - centers.lo);
    for (int axis = 0; axis < 3; ++axis) {
      if (centers.hi[axis] > centers.lo[axis]) best_split_along(axis, begin, end, centers, unit, best);
    }
    return best;
  }

  void best_split_along(int axis, std::uint32_t begin, std::uint32_t end, const Aabb& centers, double unit,
                        Split& best) const {
    std::array<Aabb, k_bins> boxes;
    std::array<std::uint32_t, k_bins> counts{};
    for (std::uint32_t i = begin; i < end; ++i) {
      const auto bin = static_cast<std::size_t>(bin_of(items_[i], centers, axis));
      boxes[bin].add(boxes_[items_[i]]);
      ++counts[bin];
    }
    std::array<double, k_bins> upper_cost{};
    Aabb upper;
    std::uint32_t upper_count = 0;
    for (std::size_t bin = k_bins - 1; bin > 0; --bin) {
      if (counts[bin] > 0) upper.add(boxes[bin]);
      upper_count += counts[bin];
      upper_cost[bin] = upper_count > 0 ? half_area(upper, unit) * upper_count : 0;
    }
    Aabb lower;
    std::uint32_t lower_count = 0;
    for (std::size_t bin = 1; bin < k_bins; ++bin) {
      if (counts[bin - 1] > 0) lower.add(boxes[bin - 1]);
      lower_count += counts[bin - 1];
      if (lower_count == 0 || lower_count == end - begin) continue;
      const double cost = half_area(lower, unit) * lower_count + upper_cost[bin];
      if (cost < best.cost) best = {axis, static_cast<int>(bin), cost};
    }
  }

  const std::vector<Aabb>& boxes_;
  const std::atomic<bool>* cancel_;
  std::vector<Bvh::Node>& nodes_;
  std::vector<std::uint32_t>& items_;
};

}  // namespace

Bvh::Bvh(const std::vector<Aabb>& boxes, const std::atomic<bool>* cancel) : items_(boxes.size()) {
  if (boxes.empty()) return;
  std::iota(items_.begin(), items_.end(), 0U);
  nodes_.reserve(2 * boxes.size());
  Builder(boxes, cancel, nodes_, items_).build(0, static_cast<std::uint32_t>(boxes.size()), 0);
}

}  // namespace lancer::tracer
