#pragma once
// What a surface sends back along a ray: the formula of the language page. The light of other surfaces is
// left to the caller, as rays with coefficients.

#include <atomic>
#include <optional>
#include <utility>

#include "tracer/faint.hpp"
#include "tracer/intersect.hpp"
#include "tracer/plan.hpp"

namespace lancer::tracer {

/// The terms of a surface's radiance, joined as the settings say: a + b, or a + b - a b of what is clamped to
/// [0, 1].
class Joined {
 public:
  explicit Joined(scene::Sum how) : how_(how) {}
  void add(Color term) {
    if (how_ == scene::Sum::linear) {
      value_ += term;
    } else {
      add_clamped(term);
    }
  }
  Color value() const { return value_; }
  /// Nothing that comes on top changes the value any more.
  bool is_full() const;

 private:
  void add_clamped(Color term);

  scene::Sum how_;
  Color value_;
};

/// A reflected or transmitted ray and what its radiance counts. Under total reflection the transmitted light
/// comes from the mirror direction too: then `also` is its coefficient, a term of its own.
struct Branch {
  Ray ray;
  Color share;
  Color also;
};

struct Shaded {
  Joined own;
  std::optional<Branch> reflected, transmitted;

  explicit Shaded(scene::Sum how) : own(how) {}
};

/// What everything that follows rays through a scene shares.
struct Tracing {
  const World* world = nullptr;
  const Plan* plan = nullptr;
  const std::atomic<bool>* cancel = nullptr;

  bool cancelled() const { return cancel && cancel->load(std::memory_order_relaxed); }
};

/// How lights are asked at a surface that counts `share` in the sum.
struct Asking {
  Color share;
  Allowance* allowance = nullptr;  // for those too weak to show; null: none is left out
  LightCells* cells = nullptr;     // null: all are asked everywhere
};

/// The surface at the hit, seen along the ray; its branches only where `follow` is set.
Shaded shade(const Tracing& tracing, const Ray& ray, const Hit& hit, bool follow, Stats& stats,
             const Asking& asking = {});

}  // namespace lancer::tracer
