#include "tracer/tree/arrange.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace lancer::tracer {
namespace {

/// Where each node belongs; children already speak of the new places.
std::vector<std::uint32_t> new_places(Tree& tree) {
  std::vector<std::uint32_t> places(tree.node_count);
  std::vector<Frame> frames{tree.frames[0]};
  std::vector<std::uint32_t> waiting{frames[0].root};
  std::uint32_t next = 0;
  places[waiting[0]] = frames[0].root = next++;
  while (!waiting.empty()) {
    Node& node = tree.nodes[waiting.back()];
    waiting.pop_back();
    const auto first = static_cast<std::ptrdiff_t>(waiting.size());
    for (Child& child : node.children) {
      if (child.is_leaf()) continue;
      std::uint32_t root = child.index();
      if (child.is_node()) {
        child = Child::node(next);
      } else {
        Frame frame = tree.frames[child.index()];
        root = std::exchange(frame.root, next);
        child = Child::part(static_cast<std::uint32_t>(frames.size()));
        frames.push_back(frame);
      }
      waiting.push_back(root);
      places[root] = next++;
    }
    std::reverse(waiting.begin() + first, waiting.end());
  }
  tree.frames = std::move(frames);
  return places;
}

}  // namespace

Tree arrange(Tree tree) {
  std::vector<std::uint32_t> places = new_places(tree);
  for (std::uint32_t i = 0; i < places.size(); ++i) {
    while (places[i] != i) {
      const std::uint32_t to = places[i];
      std::swap(tree.nodes[i], tree.nodes[to]);
      std::swap(places[i], places[to]);
    }
  }
  return tree;
}

}  // namespace lancer::tracer
