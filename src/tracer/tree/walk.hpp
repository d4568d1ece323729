#pragma once
// The way of one ray through a tree, in two versions that visit the same nodes (see floats.hpp).

#include <cstdint>

#include "tracer/processor.hpp"
#include "tracer/ray.hpp"
#include "tracer/tree/node.hpp"

namespace lancer::tracer {

/// What a walk needs of the tree, the ray and the caller.
struct Walk {
  const Node* nodes;
  const Frame* frames;
  const std::uint32_t* items;
  const Probe& probe;
  const double& limit;
  std::uint64_t& node_visits;
  void* context;
  /// Sees to the items of a leaf; true: the walk is over.
  bool (*visit_leaf)(void* context, const std::uint32_t* items);
};

#define LANCER_WALKS(TARGET)              \
  namespace TARGET {                      \
  bool walk_nearest_first(const Walk& w); \
  bool walk_in_any_order(const Walk& w);  \
  }
LANCER_WALKS(baseline)
#if defined(LANCER_HAS_AVX2)
LANCER_WALKS(avx2)
#endif
#undef LANCER_WALKS

inline bool walk_nearest_first(const Walk& walk) {
#if defined(LANCER_HAS_AVX2)
  if (k_use_avx2) return avx2::walk_nearest_first(walk);
#endif
  return baseline::walk_nearest_first(walk);
}

inline bool walk_in_any_order(const Walk& walk) {
#if defined(LANCER_HAS_AVX2)
  if (k_use_avx2) return avx2::walk_in_any_order(walk);
#endif
  return baseline::walk_in_any_order(walk);
}

/// Nodes are no deeper than this below the root of their frame.
inline constexpr std::size_t k_max_depth = 40;

}  // namespace lancer::tracer
