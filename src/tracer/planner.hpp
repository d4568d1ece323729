#pragma once
// What plan() works with: one look at scene, view and options, then a decision after the other.

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tracer/extent.hpp"
#include "tracer/inventory.hpp"
#include "tracer/plan.hpp"

namespace lancer::tracer {

class Planner {
 public:
  Planner(const scene::Scene& scene, const scene::View& view, const Options& options)
      : scene_(scene), view_(view), options_(options), has_(scene) {
    out_.skips = options.skips;
    out_.exposure = scene.settings.exposure;
    out_.primitives = has_.primitives;
    out_.worn = shapes_with([](auto& w, auto&) { return w.any; }).size();
  }

  Plan run();

 private:
  using Index = scene::Index;
  using Things = std::vector<Index>;
  /// More lights than these are worth it to look which matter where.
  static constexpr std::size_t k_few_lights = 4;
  static constexpr std::size_t k_most_named = 3;

  void plan_recursion();
  void plan_lights();
  void plan_terms();
  void plan_shadow_rays();
  void plan_any_hit();
  void plan_media();
  void plan_patterns();
  void plan_packets();
  /// Why the scene or the view keeps rays from going together; null: nothing does.
  const char* keeps_rays_apart() const {
    if (scene_.settings.sum != scene::Sum::linear) return "the sum of terms is not linear";
    const bool in_solids = out_.media && view_.projection == scene::Projection::orthographic;
    return in_solids ? "each ray starts in solids of its own" : nullptr;
  }
  void plan_tree();
  void plan_faint();

  bool may(Skip skip) const { return options_.skips.has(skip); }

  void decide(Skip skip, Verdict verdict, std::string reason, const Things& things = {},
              Thing::Kind kind = Thing::Kind::shape) {
    Decision decision{skip, verdict, std::move(reason), {}, things.size()};
    for (std::size_t i = 0; i < std::min(things.size(), k_most_named); ++i)
      decision.things.push_back({kind, things[i]});
    out_.decisions.push_back(std::move(decision));
  }

  /// It can be left out for this reason, and is, unless that was turned off.
  bool leave_out(Skip skip, std::string reason, const Things& things = {},
                 Thing::Kind kind = Thing::Kind::shape, Verdict verdict = Verdict::skipped) {
    decide(skip, may(skip) ? verdict : Verdict::off, std::move(reason), things, kind);
    return may(skip);
  }

  /// For each material for which test(wearers, terms) gives a shape, that shape.
  template <class Test>
  Things shapes_with(Test test) const {
    Things out;
    for (std::size_t m = 0; m < has_.wearers.size(); ++m) {
      if (has_.wearers[m].any == scene::k_none) continue;
      const Index shape = test(has_.wearers[m], has_.terms[m]);
      if (shape != scene::k_none) out.push_back(shape);
    }
    return out;
  }

  Things other_indices() const;
  bool eye_may_be_in(Index mesh) const;
  Things meshes_around_rays() const;
  Things bright_shadows() const;
  void ask_all_but(const Things& dropped);
  void plan_light_cells();
  const Extent& extent() {
    if (!extent_) extent_.emplace(scene_);
    return *extent_;
  }

  const scene::Scene& scene_;
  const scene::View& view_;
  const Options& options_;
  Inventory has_;
  std::optional<Extent> extent_;  // once asked for
  Plan out_;
};

}  // namespace lancer::tracer
