#pragma once
// What a sample leaves out for being too faint to show. The rays that a sample still has to follow, brightest
// first, and when those that are left are together too faint to show. A branch's largest possible
// contribution is its share times a bound of what any ray can bring; following it puts its own branches in
// its place, which can bring no more.

#include <cstdint>
#include <vector>

#include "base/color.hpp"
#include "tracer/ray.hpp"

namespace lancer::tracer {

/// What may still go missing, where one thing after the other asks.
class Allowance {
 public:
  explicit Allowance(Color left) : left_(left) {}

  /// May this go missing? Then it is taken off. Never more than a part of what is left, so that a first, not
  /// so faint one does not leave the many others without.
  bool takes(Color most);
  Color left() const { return left_; }

 private:
  Color left_;
};

/// A ray still to be followed, and what its radiance counts in the sum.
struct Pending {
  Ray ray;
  Color share;
  int depth = 0;  // deviations that may still be followed
  bool transmitted = false;
};

class PendingRays {
 public:
  void clear();
  bool empty() const { return queue_.empty(); }
  std::size_t size() const { return queue_.size(); }

  /// `most`: what it can add to the sum at the most.
  void push(Pending ray, Color most);
  /// The one that can add the most; of equals, an arbitrary but always the same one.
  Pending pop();

  /// Can all that are left add no more than this?
  bool fit(Color allowed);

 private:
  struct Entry {
    double key;
    std::uint32_t place;
    Color most;
  };
  static bool is_fainter(const Entry& a, const Entry& b) { return a.key < b.key; }

  std::vector<Entry> queue_;  // a heap
  std::vector<Pending> rays_;
  std::vector<std::uint32_t> free_;  // places in rays_
  Color total_;
};

}  // namespace lancer::tracer
