#include "tracer/tree/build.hpp"

#include <algorithm>
#include <mutex>
#include <tuple>

#include "tracer/tree/arrange.hpp"
#include "tracer/tree/grid.hpp"
#include "tracer/tree/references.hpp"
#include "tracer/tree/split.hpp"
#include "tracer/tree/tasks.hpp"
#include "tracer/tree/walk.hpp"

namespace lancer::tracer {
namespace {

constexpr std::uint32_t k_leaf_size = 4;
constexpr std::uint32_t k_fork = 4096;       // parts of nodes with more items are built at once
constexpr std::uint32_t k_chunk = 1U << 14;  // of items that are looked at by one thread
constexpr std::size_t k_heuristic_depth =
    24;                                      // below, halves: 2^30 items are then no deeper than k_max_depth
constexpr float k_fewest_cells = 256;        // what is smaller gets a grid of its own, ...
constexpr std::uint32_t k_fewest_items = 8;  // ... if it holds as many items,
constexpr double k_frame_gain = 0x1p13;      // and a frame of its own where the unit is smaller by as much

class Builder {
 public:
  Builder(std::uint32_t count, const std::function<Aabb(std::uint32_t)>& box_of,
          const std::atomic<bool>* cancel)
      : box_of_(box_of),
        cancel_(cancel),
        count_(count),
        references_(count),
        nodes_(new Node[count / (k_leaf_size + 1) + count / (k_width - 1) + 2]) {}

  Tree build() {
    Range all(0, count_);
    const Aabb bounds = gather<Aabb>(all, [&](std::uint32_t i, Aabb& box) {
      references_.set(i, {}, i);
      box.add(box_at(i));
    });
    lay_grid(all, bounds);
    add_frame(all, frame_around(bounds));
    std::vector<std::uint32_t> items(count_);
    for (std::uint32_t i = 0; i < count_; ++i) items[i] = references_.item(i);
    return arrange({std::move(nodes_), node_count_, std::move(frames_), std::move(items)});
  }

 private:
  bool cancelled() const { return cancel_ && cancel_->load(std::memory_order_relaxed); }

  Aabb box_at(std::uint32_t place) const { return tamed(box_of_(references_.item(place) & ~k_last_item)); }

  /// Calls work(place, sum) for each reference, and adds the sums up.
  template <class Sum, class Work>
  Sum gather(const Range& range, const Work& work) const {
    std::vector<Sum> sums((range.count() + k_chunk - 1) / k_chunk);
    const auto chunk = [&](std::size_t number) {
      const std::uint32_t begin = range.begin + static_cast<std::uint32_t>(number) * k_chunk;
      const std::uint32_t end = std::min(begin + k_chunk, range.end);
      for (std::uint32_t i = begin; i < end; ++i) work(i, sums[number]);
    };
    sums.size() > 1 ? at_once(sums.size(), chunk) : chunk(0);
    for (std::size_t i = 1; i < sums.size(); ++i) sums[0].add(sums[i]);
    return sums[0];
  }

  Aabb bounds_of(const Range& range) const {
    Aabb bounds;
    for (std::uint32_t i = range.begin; i < range.end; ++i) bounds.add(box_at(i));
    return bounds;
  }

  void lay_grid(Range& range, const Aabb& bounds) {
    const Grid grid(bounds);
    range.add(gather<Range>(range, [&](std::uint32_t i, Range& part) {
      const std::uint32_t item = references_.item(i);
      references_.set(i, grid.sides(tamed(box_of_(item))), item);
      part.add(references_[i]);
    }));
  }

  std::uint32_t add_frame(const Range& range, Frame frame) {
    frame.root = node_count_.fetch_add(1, std::memory_order_relaxed);
    std::uint32_t number = 0;
    {
      const std::lock_guard lock(frames_mutex_);
      number = static_cast<std::uint32_t>(frames_.size());
      frames_.push_back(frame);
    }
    fill(range, frame.root, frame, 0);
    return number;
  }

  /// Makes the node of the range; what it fills.
  FrameBox fill(const Range& range, std::uint32_t number, const Frame& frame, std::size_t depth) {
    std::array<Range, k_width> parts;
    const std::size_t count = cut(range, depth >= k_heuristic_depth, parts);
    Node& node = nodes_[number];
    const auto make = [&](std::size_t i) { make_child(node, i, parts[i], frame, depth); };
    if (range.count() > k_fork) {
      at_once(count, make);
    } else {
      for (std::size_t i = 0; i < count; ++i) make(i);
    }
    for (std::size_t i = count; i < k_width; ++i) set_empty(node, i);
    return united(node);
  }

  void make_child(Node& node, std::size_t i, Range part, const Frame& frame, std::size_t depth) {
    if (part.count() <= k_leaf_size || cancelled()) {
      set_box(node, i, in_frame(frame, bounds_of(part)));
      references_.mark_last(part.end - 1);
      node.children[i] = Child::leaf(part.begin);
      return;
    }
    if (part.count() >= k_fewest_items && is_small(part)) {
      const Aabb bounds = bounds_of(part);
      part = Range(part.begin, part.end);
      lay_grid(part, bounds);
      const Frame own = frame_around(bounds);
      if (own.inverse_scale >= frame.inverse_scale * k_frame_gain) {
        set_box(node, i, in_frame(frame, bounds));
        node.children[i] = Child::part(add_frame(part, own));
        return;
      }
    }
    const std::uint32_t number = node_count_.fetch_add(1, std::memory_order_relaxed);
    node.children[i] = Child::node(number);
    set_box(node, i, fill(part, number, frame, depth + 1));
  }

  static bool is_small(const Range& part) {
    const auto [x, y, z] = part.box.size();
    return std::max(x, std::max(y, z)) < k_fewest_cells;
  }

  /// How much there is to gain from cutting the part; none: negative.
  static float worth(const Range& part, bool in_halves) {
    const std::uint32_t count = part.count();
    if (count < 2) return -1;
    if (in_halves) return static_cast<float>(count);
    // What need not be cut is only cut where there is room.
    constexpr float k_beyond = 0x1p40F;
    return part.box.half_area() + (count > k_leaf_size ? k_beyond : 0);
  }

  std::size_t cut(const Range& range, bool in_halves, std::array<Range, k_width>& parts) {
    parts[0] = range;
    std::size_t count = 1;
    while (count < k_width && !cancelled()) {
      const auto less = [&](const Range& a, const Range& b) {
        return worth(a, in_halves) < worth(b, in_halves);
      };
      Range& best = *std::max_element(parts.begin(), parts.begin() + count, less);
      if (worth(best, in_halves) < 0) break;
      std::tie(best, parts[count++]) = split(references_, best, in_halves);
    }
    return count;
  }

  static void set_box(Node& node, std::size_t i, const FrameBox& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.sides[2 * axis][i] = box.lo[axis];
      node.sides[2 * axis + 1][i] = box.hi[axis];
    }
  }
  static void set_empty(Node& node, std::size_t i) {
    constexpr float k_infinity = std::numeric_limits<float>::infinity();
    set_box(node, i, {{k_infinity, k_infinity, k_infinity}, {-k_infinity, -k_infinity, -k_infinity}});
    node.children[i] = Child::none();
  }
  static FrameBox united(const Node& node) {
    FrameBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Node::Sides &lo = node.sides[2 * axis], &hi = node.sides[2 * axis + 1];
      box.lo[axis] = *std::min_element(lo.begin(), lo.end());
      box.hi[axis] = *std::max_element(hi.begin(), hi.end());
    }
    return box;
  }

  const std::function<Aabb(std::uint32_t)>& box_of_;
  const std::atomic<bool>* cancel_;
  std::uint32_t count_;
  References references_;
  std::unique_ptr<Node[]> nodes_;
  std::atomic<std::uint32_t> node_count_{0};
  std::mutex frames_mutex_;
  std::vector<Frame> frames_;
};

}  // namespace

Tree build_tree(std::uint32_t count, const std::function<Aabb(std::uint32_t)>& box_of,
                const std::atomic<bool>* cancel) {
  return Builder(count, box_of, cancel).build();
}

}  // namespace lancer::tracer
