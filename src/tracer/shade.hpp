#pragma once
// What a surface sends back along a ray: the formula of the language page. The light of other surfaces is
// left to the caller, as rays with coefficients.

#include <atomic>
#include <optional>

#include "tracer/intersect.hpp"
#include "tracer/plan.hpp"

namespace lancer::tracer {

/// The terms of a surface's radiance, joined as the settings say: a + b, or a + b - a b of what is clamped to
/// [0, 1].
class Joined {
 public:
  explicit Joined(scene::Sum how) : how_(how) {}
  void add(Color term);
  Color value() const { return value_; }
  /// Nothing that comes on top changes the value any more.
  bool is_full() const;

 private:
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
};

/// What everything that follows rays through a scene shares.
struct Tracing {
  const World* world = nullptr;
  const Plan* plan = nullptr;
  const std::atomic<bool>* cancel = nullptr;

  bool cancelled() const { return cancel && cancel->load(std::memory_order_relaxed); }
};

/// What lights that are too weak to show may still take from a pixel.
class FaintLights {
 public:
  /// `share`: what the surface counts in the sum; `left`: what all of these lights may still add up to.
  FaintLights(Color share, Color left) : share_(share), left_(left) {}

  /// May light of that much go missing? Then it is taken off. Never more than a part of what is left, so that
  /// a first, not so faint one does not leave the many others without.
  bool takes(Color light);
  Color left() const { return left_; }

 private:
  Color share_, left_;
};

/// The surface at the hit, seen along the ray; its branches only where `follow` is set. Lights are left out
/// for being faint where `faint` is given.
Shaded shade(const Tracing& tracing, const Ray& ray, const Hit& hit, bool follow, Stats& stats,
             FaintLights* faint = nullptr);

}  // namespace lancer::tracer
