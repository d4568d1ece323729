#pragma once
// Builds a tree from the top: each node's range of items is cut in two until there are eight parts, always
// the part that a ray meets most likely (as Embree builds its wide trees; Wald, Benthin, Boulos 2008).

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "tracer/aabb.hpp"
#include "tracer/tree/node.hpp"

namespace lancer::tracer {

/// See Bvh.
struct Tree {
  std::unique_ptr<Node[]> nodes;
  std::size_t node_count = 0;
  std::vector<Frame> frames;
  std::vector<std::uint32_t> items;
};

Tree build_tree(std::uint32_t count, const std::function<Aabb(std::uint32_t)>& box_of,
                const std::atomic<bool>* cancel);

}  // namespace lancer::tracer
