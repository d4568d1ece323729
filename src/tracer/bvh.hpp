#pragma once
// A tree of boxes over numbered items. It knows nothing of shapes, and what is found never depends on how it
// is built: it only leaves out what cannot matter.

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <vector>

#include "tracer/aabb.hpp"

namespace lancer::tracer {

class Bvh {
 public:
  struct Node {
    Aabb box;
    std::uint32_t first = 0;  // leaf: into items_; inner: the second child (the first one follows its parent)
    std::uint32_t count = 0;  // of items; 0: an inner node
    std::uint8_t axis = 0;    // inner: along which the children were split
  };

  Bvh() = default;
  /// Item numbers are those of `boxes`. Binned surface area heuristic (Wald 2007). Stops early, with an
  /// unusable tree, once `cancel` is set.
  explicit Bvh(const std::vector<Aabb>& boxes, const std::atomic<bool>* cancel = nullptr);

  /// Calls visit(item) for the items in every leaf that the ray may meet between 0 and `limit`, nearer boxes
  /// first, until it returns true (then so does this). `limit` is read again at each node, so a visitor may
  /// lower it.
  template <class Visit>
  bool traverse(const Probe& probe, const double& limit, std::uint64_t& node_visits, Visit visit) const;

  /// Calls visit(item) for the items in every leaf whose box contains p.
  template <class Visit>
  void around(Vec3 p, Visit visit) const;

  const std::vector<Node>& nodes() const { return nodes_; }

  /// No deeper than this.
  static constexpr int k_max_depth = 96;

 private:
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> items_;
};

template <class Visit>
bool Bvh::traverse(const Probe& probe, const double& limit, std::uint64_t& node_visits, Visit visit) const {
  if (nodes_.empty()) return false;
  struct Waiting {
    std::uint32_t node;
    double enter;
  };
  std::array<Waiting, k_max_depth + 1> stack;
  std::size_t waiting = 0;
  const Interval whole = interval(nodes_[0].box, probe);
  if (whole.enter <= whole.leave) stack[waiting++] = {0, whole.enter};
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.enter > limit) continue;
    ++node_visits;
    const Node& node = nodes_[next.node];
    if (node.count > 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        if (visit(items_[i])) return true;
      }
      continue;
    }
    const std::array<std::uint32_t, 2> children{next.node + 1, node.first};
    const Interval lower = interval(nodes_[children[0]].box, probe);
    const Interval upper = interval(nodes_[children[1]].box, probe);
    const bool backwards = std::signbit(probe.direction[node.axis]);
    const auto push = [&](const Interval& part, std::uint32_t child) {
      if (part.enter <= part.leave && part.enter <= limit) stack[waiting++] = {child, part.enter};
    };
    if (backwards) {
      push(lower, children[0]);
      push(upper, children[1]);
    } else {
      push(upper, children[1]);
      push(lower, children[0]);
    }
  }
  return false;
}

template <class Visit>
void Bvh::around(Vec3 p, Visit visit) const {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, k_max_depth + 1> stack;
  std::size_t waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const std::uint32_t at = stack[--waiting];
    const Node& node = nodes_[at];
    if (!node.box.contains(p)) continue;
    if (node.count > 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) visit(items_[i]);
    } else {
      stack[waiting++] = at + 1;
      stack[waiting++] = node.first;
    }
  }
}

}  // namespace lancer::tracer
