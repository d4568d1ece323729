#pragma once
// The radiance along a ray: the surfaces it meets, and those that their reflections and refractions meet in
// turn. However deep that goes, it runs in a loop with a stack of its own.

#include <vector>

#include "tracer/faint.hpp"
#include "tracer/shade.hpp"

namespace lancer::tracer {

/// One thread's tracer. Returns early, with no meaningful value, once the tracing is cancelled.
class Tracer {
 public:
  explicit Tracer(const Tracing& tracing) : tracing_(tracing), cells_(*tracing.world->scene, *tracing.plan) {}

  /// What arrives along the ray, of which `depth` deviations may be followed.
  Color radiance(const Ray& ray, int depth);

  /// Adds to the sum (of sum "linear") what the ray brings, which counts `share` in it, term by term in the
  /// order of radiance().
  void follow(const Ray& first, Color share, int depth, Color& sum);

  Stats& stats() { return stats_; }

 private:
  /// A surface whose radiance waits for that of a ray (sum "log", where a share cannot be carried along).
  struct Waiting {
    Joined value;
    Color share, also;
    Color reach;  // what a change of this surface's radiance changes the sum by, at the most
    int depth;
    bool then_transmitted;  // the last of `later_` is its second ray
  };

  /// Where nothing goes on from what a ray meets.
  Color one_surface(const Ray& ray);
  Color linear(const Ray& ray, int depth);
  /// As linear(), but what is too faint to show is left out.
  Color linear_to_error(const Ray& ray, int depth);
  /// Drops the branch of a surface with that `reach` if it is too faint to show.
  void drop_if_faint(std::optional<Branch>& branch, Color reach, int depth, Allowance& allowance);
  /// What may go missing in all from a sample that already sees `seen`.
  Color allowance(Color seen) const;
  Color log(Ray ray, int depth);

  LightCells* cells() { return tracing_.plan->light_cells.used ? &cells_ : nullptr; }

  Tracing tracing_;
  LightCells cells_;
  Stats stats_;
  std::vector<Pending> pending_;
  PendingRays brightest_;
  std::vector<Waiting> waiting_;
  std::vector<Branch> later_;
};

}  // namespace lancer::tracer
