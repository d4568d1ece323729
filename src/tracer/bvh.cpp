#include "tracer/bvh.hpp"

namespace lancer::tracer {
namespace {

/// Is p within the sides of the node's child, as far as floats can tell?
bool holds(const Node& node, std::size_t child, const std::array<double, 3>& p) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (p[axis] < static_cast<double>(node.sides[2 * axis][child])) return false;
    if (p[axis] > static_cast<double>(node.sides[2 * axis + 1][child])) return false;
  }
  return true;
}

std::array<double, 3> in_frame(const Frame& frame, Vec3 p) {
  const Vec3 q = (p - frame.origin) * frame.inverse_scale;
  return {q.x, q.y, q.z};
}

}  // namespace

Bvh::Bvh(std::uint32_t count, const BoxOf& box_of, const std::atomic<bool>* cancel) {
  if (count > 0) tree_ = build_tree(count, box_of, cancel);
}

void Bvh::around(Vec3 p, std::vector<std::uint32_t>& found) const {
  struct Waiting {
    std::uint32_t node, frame;
  };
  const auto& [nodes, node_count, frames, items] = tree_;
  if (node_count == 0) return;
  std::vector<Waiting> waiting{{frames[0].root, 0}};
  while (!waiting.empty()) {
    const Waiting at = waiting.back();
    waiting.pop_back();
    const Node& node = nodes[at.node];
    const std::array<double, 3> own = in_frame(frames[at.frame], p);
    for (std::size_t i = 0; i < k_width; ++i) {
      const Child child = node.children[i];
      if (!holds(node, i, own)) continue;
      if (child.is_node()) {
        waiting.push_back({child.index(), at.frame});
      } else if (!child.is_leaf()) {
        waiting.push_back({frames[child.index()].root, child.index()});
      } else {
        std::size_t item = child.index();
        do found.push_back(items[item] & ~k_last_item);
        while ((items[item++] & k_last_item) == 0);
      }
    }
  }
}

}  // namespace lancer::tracer
