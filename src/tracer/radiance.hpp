#pragma once
// The radiance along a ray: the surfaces it meets, and those that their reflections and refractions meet in
// turn. However deep that goes, it runs in a loop with a stack of its own.

#include <vector>

#include "tracer/shade.hpp"

namespace lancer::tracer {

/// One thread's tracer. Returns early, with no meaningful value, once the tracing is cancelled.
class Tracer {
 public:
  explicit Tracer(const Tracing& tracing) : tracing_(tracing) {}

  /// What arrives along the ray, of which `depth` deviations may be followed.
  Color radiance(Ray ray, int depth);

  Stats& stats() { return stats_; }

 private:
  /// A ray still to be followed, and what its radiance counts in the sum.
  struct Pending {
    Ray ray;
    Color share;
    int depth;
  };
  /// A surface whose radiance waits for that of a ray (sum "log", where a share cannot be carried along).
  struct Waiting {
    Joined value;
    Color share, also;
    int depth;
    bool then_transmitted;  // the last of `later_` is its second ray
  };

  Color linear(Ray ray, int depth);
  Color log(Ray ray, int depth);

  Tracing tracing_;
  Stats stats_;
  std::vector<Pending> pending_;
  std::vector<Waiting> waiting_;
  std::vector<Branch> later_;
};

}  // namespace lancer::tracer
