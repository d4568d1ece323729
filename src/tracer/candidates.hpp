#pragma once
// The surfaces that may be the first on a ray, kept while the tree is searched.

#include <algorithm>
#include <cstdint>

#include "tracer/aabb.hpp"
#include "tracer/ray.hpp"
#include "tracer/small_list.hpp"

namespace lancer::tracer {

inline constexpr Interval k_anywhere{0, k_infinity};

/// What is known of a root, and of where the primitive as a whole lies on the ray.
inline Root within(Root root, const Interval& own) {
  const double enter = own.enter * (1 - 2 * gamma(3));  // as in interval(), for the near side
  if (root.t < enter || root.t > own.leave) root.t = root.t < enter ? enter : own.leave;
  root.error = std::min(root.error, own.leave - enter);
  return root;
}

/// A surface that may be the first.
struct Candidate {
  std::uint32_t primitive = 0;
  Root root;
  Interval own;         // where the primitive's bounds are
  double earliest = 0;  // the true distance is no less
  Vec3 normal;          // where there are several
};

/// Those that may be the first of all seen so far. Which ones those are does not depend on the order in which
/// they are seen: at the end it holds exactly those whose lower bound is not beyond the least upper bound.
class Candidates {
 public:
  /// No surface beyond this distance can be the first.
  const double& limit() const { return limit_; }

  /// The crossing is within [low, high], as far as those are within the primitive's own bounds.
  void add(std::uint32_t primitive, const Root& root, const Interval& own, double low, double high,
           Vec3 normal = {}) {
    const double earliest = std::max(low, own.enter);
    const double latest = std::max(std::min(high, own.leave), own.enter);
    if (earliest > limit_) return;
    limit_ = std::min(limit_, latest);
    // Nearly always there is one, and the other is clearly behind it. Whoever passes beside rims asks for
    // all.
    if (list_.size() == 1 && list_[0].earliest > limit_ && !list_[0].root.rim) list_.clear();
    if (list_.size() >= k_tidy) tidy();
    list_.push_back({primitive, root, own, earliest, normal});
  }
  void add(std::uint32_t primitive, const Root& root, const Interval& own) {
    const double error = root.loose ? k_infinity : root.error;
    add(primitive, root, own, root.t - error, root.t + error);
  }

  void tidy() {
    std::size_t kept = 0;
    for (const Candidate& candidate : list_) {
      if (candidate.earliest <= limit_) list_[kept++] = candidate;
    }
    list_.shrink(kept);
  }

  /// All distances were less by `by`.
  void shift(double by) {
    limit_ += by;
    for (Candidate& c : list_) {
      c.earliest += by;
      c.own = {c.own.enter + by, c.own.leave + by};
    }
  }

  const Candidate* begin() const { return list_.begin(); }
  const Candidate* end() const { return list_.end(); }
  std::size_t size() const { return list_.size(); }
  bool empty() const { return list_.empty(); }

 private:
  static constexpr std::size_t k_tidy = 6;
  SmallList<Candidate, 8> list_;
  double limit_ = k_infinity;
};

}  // namespace lancer::tracer
