#pragma once
// A tree of boxes over numbered items. It knows nothing of shapes, and what is found never depends on how it
// is built: it only leaves out what cannot matter. No ray that meets an item's box is ever kept from the
// item.

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "tracer/aabb.hpp"
#include "tracer/tree/build.hpp"
#include "tracer/tree/walk.hpp"

namespace lancer::tracer {

/// Which of the boxes that a ray meets are looked into first.
enum class Order : std::uint8_t { nearest_first, any };

class Bvh {
 public:
  using BoxOf = std::function<Aabb(std::uint32_t item)>;

  Bvh() = default;
  /// Over the items 0 .. count - 1, fewer than 2^30. `box_of` is asked more than once for each, from several
  /// threads. Stops early, with an unusable tree, once `cancel` is set. The tree does not depend on the
  /// number of threads.
  Bvh(std::uint32_t count, const BoxOf& box_of, const std::atomic<bool>* cancel = nullptr);

  /// Calls visit(item) for at least all items whose box the ray may meet between 0 and `limit`, as interval()
  /// tells, until it returns true (then so does this). The direction has unit length. `limit` is read again
  /// after each visit, so a visitor may lower it.
  template <class Visit>
  bool traverse(const Probe& probe, const double& limit, std::uint64_t& node_visits, Visit visit,
                Order order = Order::nearest_first) const;

  /// Calls visit(item) for at least all items whose box contains p.
  template <class Visit>
  void around(Vec3 p, Visit visit) const;

  std::span<const Node> nodes() const { return {tree_.nodes.get(), tree_.node_count}; }
  /// The first one is the whole tree's.
  const std::vector<Frame>& frames() const { return tree_.frames; }
  /// The items in the order of the leaves, each leaf's last one marked by k_last_item.
  const std::vector<std::uint32_t>& items() const { return tree_.items; }

 private:
  void around(Vec3 p, std::vector<std::uint32_t>& found) const;

  Tree tree_;
};

template <class Visit>
bool Bvh::traverse(const Probe& probe, const double& limit, std::uint64_t& node_visits, Visit visit,
                   Order order) const {
  if (tree_.node_count == 0) return false;
  const auto visit_leaf = [](void* context, const std::uint32_t* item) {
    for (;; ++item) {
      if ((*static_cast<Visit*>(context))(*item & ~k_last_item)) return true;
      if ((*item & k_last_item) != 0) return false;
    }
  };
  const Walk walk{
      tree_.nodes.get(), tree_.frames.data(), tree_.items.data(), probe, limit, node_visits, &visit,
      visit_leaf};
  return order == Order::any ? walk_in_any_order(walk) : walk_nearest_first(walk);
}

template <class Visit>
void Bvh::around(Vec3 p, Visit visit) const {
  std::vector<std::uint32_t> found;
  around(p, found);
  for (const std::uint32_t item : found) visit(item);
}

}  // namespace lancer::tracer
