#include "tracer/plan.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "scene/corners.hpp"
#include "tracer/extent.hpp"
#include "tracer/inventory.hpp"
#include "tracer/light.hpp"
#include "tracer/lights_in_reach.hpp"
#include "tracer/pattern.hpp"
#include "tracer/world.hpp"

namespace lancer::tracer {
namespace {

/// More than these are worth it to look which matter where.
constexpr std::size_t k_few_lights = 4;

using scene::Index;
using scene::k_none;
using Things = std::vector<Index>;

constexpr std::size_t k_most_named = 3;

class Planner {
 public:
  Planner(const scene::Scene& scene, const scene::View& view, const Options& options)
      : scene_(scene), view_(view), options_(options), has_(scene) {
    out_.skips = options.skips;
    out_.exposure = scene.settings.exposure;
    out_.primitives = has_.primitives;
    out_.worn = shapes_with([](auto& w, auto&) { return w.any; }).size();
  }

  Plan run() {
    plan_recursion();
    plan_lights();
    plan_terms();
    plan_shadow_rays();
    plan_any_hit();
    plan_media();
    plan_patterns();
    plan_faint();
    plan_light_cells();
    plan_packets();
    plan_tree();
    std::sort(out_.decisions.begin(), out_.decisions.end(),
              [](const Decision& a, const Decision& b) { return a.skip < b.skip; });
    return std::move(out_);
  }

 private:
  void plan_recursion();
  void plan_lights();
  void plan_terms();
  void plan_shadow_rays();
  void plan_any_hit();
  void plan_media();
  void plan_patterns();
  void plan_packets();
  /// Do the scene and the view let rays go together?
  bool suits_packets() const {
    const bool in_solids = out_.media && view_.projection == scene::Projection::orthographic;
    return scene_.settings.sum == scene::Sum::linear && !in_solids;
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
      if (has_.wearers[m].any == k_none) continue;
      const Index shape = test(has_.wearers[m], has_.terms[m]);
      if (shape != k_none) out.push_back(shape);
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

void Planner::plan_recursion() {
  const Things reflecting = shapes_with([](auto& w, auto& t) { return t.reflection ? w.any : k_none; });
  const Things clear = shapes_with([](auto& w, auto& t) { return t.transmission ? w.any : k_none; });
  const Things onward = shapes_with([](auto& w, auto& t) { return t.onward() ? w.any : k_none; });
  const bool depth = scene_.settings.depth > 0;
  out_.reflects = depth && !reflecting.empty();
  out_.transmits = depth && !clear.empty();
  if (!depth) {
    out_.recursion = !leave_out(Skip::recursion, "the settings follow rays to depth 0");
  } else if (onward.empty()) {
    out_.recursion = !leave_out(Skip::recursion, "nothing reflects or lets light through");
  } else {
    decide(Skip::recursion, Verdict::needed, "{} may reflect or let light through", onward);
  }
}

/// Lights that are not asked, for they are among `dropped` (in order).
void Planner::ask_all_but(const Things& dropped) {
  Things asked;
  for (Index i = 0; i < scene_.lights.size(); ++i) {
    const bool was_asked = out_.every_light || std::binary_search(out_.lights.begin(), out_.lights.end(), i);
    if (was_asked && !std::binary_search(dropped.begin(), dropped.end(), i)) asked.push_back(i);
  }
  out_.every_light = asked.size() == scene_.lights.size();
  out_.lights = out_.every_light ? Things{} : std::move(asked);
}

void Planner::plan_lights() {
  const auto is_spot = [](const scene::Light& light) { return light.kind == scene::LightKind::spot; };
  const bool spots = std::any_of(scene_.lights.begin(), scene_.lights.end(), is_spot);
  const Things dark = dark_lights(scene_, spots ? &extent() : nullptr);
  if (may(Skip::dark_lights)) ask_all_but(dark);
  if (scene_.lights.empty()) {
    leave_out(Skip::dark_lights, "there is no light");
  } else if (!dark.empty()) {
    leave_out(Skip::dark_lights, "nowhere: {}", dark, Thing::Kind::light, Verdict::as_met);
  } else {
    leave_out(Skip::dark_lights, "", {}, Thing::Kind::light, Verdict::as_met);
  }
}

void Planner::plan_terms() {
  const bool lit = out_.every_light ? !scene_.lights.empty() : !out_.lights.empty();
  const bool bare = !may(Skip::zero_terms);
  const bool ambient = !is_black(scene_.settings.ambient) || !may(Skip::patterns);
  for (std::size_t m = 0; m < has_.wearers.size(); ++m) {
    const Terms& terms = has_.terms[m];
    MaterialNeeds needs;
    needs.direct = bare || (lit && terms.direct());
    needs.onward = out_.recursion && (terms.onward() || !may(Skip::recursion));
    needs.ambient = ambient;
    needs.diffuse = needs.specular = needs.direct || !may(Skip::patterns);
    needs.reflection = needs.transmission = needs.onward || !may(Skip::patterns);
    out_.needs.push_back(needs);
  }
  const Things zero = shapes_with([](auto& w, auto& t) { return t.direct() ? k_none : w.any; });
  if (scene_.lights.empty()) {
    leave_out(Skip::zero_terms, "there is no light");
  } else if (!zero.empty()) {
    leave_out(Skip::zero_terms, "{}: neither diffuse nor specular", zero, Thing::Kind::shape,
              Verdict::as_met);
  } else {
    leave_out(Skip::zero_terms, "", {}, Thing::Kind::shape, Verdict::as_met);
  }
}

void Planner::plan_shadow_rays() {
  const Things casters = shapes_with([](auto& w, auto&) { return w.caster; });
  const Things lit = shapes_with([](auto& w, auto& t) { return t.direct() ? w.any : k_none; });
  const bool opaque = scene_.settings.shadows == scene::Shadows::opaque;
  out_.shadows = opaque ? ShadowWork::blocked : ShadowWork::filtered;
  if (scene_.settings.shadows == scene::Shadows::off) {
    decide(Skip::shadow_rays, Verdict::skipped, "the settings turn shadows off");
    out_.shadows = ShadowWork::none;
  } else if (scene_.lights.empty()) {
    decide(Skip::shadow_rays, Verdict::skipped, "there is no light");
    out_.shadows = ShadowWork::none;
  } else if (casters.empty()) {
    if (leave_out(Skip::shadow_rays, "no shape casts a shadow")) out_.shadows = ShadowWork::none;
  } else if (lit.empty()) {
    if (leave_out(Skip::shadow_rays, "no surface is diffuse or specular")) out_.shadows = ShadowWork::none;
  } else {
    decide(Skip::shadow_rays, Verdict::needed, "{} may stand between a light and a surface", casters);
  }
}

void Planner::plan_any_hit() {
  const Things clear = shapes_with([](auto& w, auto& t) { return t.transmission ? w.caster : k_none; });
  out_.any_hit = may(Skip::any_hit);
  if (out_.shadows == ShadowWork::none) {
    decide(Skip::any_hit, Verdict::skipped, "there are no shadow rays");
  } else if (out_.shadows == ShadowWork::blocked) {
    leave_out(Skip::any_hit, "the settings make all shadows opaque");
  } else if (clear.empty()) {
    if (leave_out(Skip::any_hit, "nothing that casts a shadow lets light through"))
      out_.shadows = ShadowWork::blocked;
  } else {
    decide(Skip::any_hit, Verdict::needed, "light may come through {}", clear);
  }
}

/// Of the solids, those whose refractive index is not that of the surrounding space.
Things Planner::other_indices() const {
  Things out;
  for (std::size_t m = 0; m < has_.wearers.size(); ++m) {
    const Index solid = has_.wearers[m].solid;
    if (solid != k_none && scene_.materials[m].ior != scene_.settings.ior) out.push_back(solid);
  }
  return out;
}

/// False only where the eye is surely outside.
bool Planner::eye_may_be_in(Index mesh) const {
  if (view_.projection == scene::Projection::orthographic) return true;
  Aabb box;
  scene::each_corner(scene_, scene_.shapes[mesh], [&](Vec3 p) { box.add(p); });
  return box.padded(1e-9 * max_abs(box.hi - box.lo)).contains(view_.eye);
}

/// Solid meshes that a ray may be inside of: which of two facets it meets at an edge is decided by that.
Things Planner::meshes_around_rays() const {
  Things out;
  for (const Index mesh : has_.solid_meshes) {
    const bool clear = has_.terms[scene_.shapes[mesh].material].transmission;
    if ((out_.transmits && clear) || eye_may_be_in(mesh)) out.push_back(mesh);
  }
  return out;
}

void Planner::plan_media() {
  const Things bending = other_indices();
  if (out_.transmits && !bending.empty()) {
    decide(Skip::media, Verdict::needed, "{} may bend light", bending);
  } else if (const Things meshes = meshes_around_rays(); !meshes.empty()) {
    decide(Skip::media, Verdict::needed, "rays may be inside {}, of solid facets", meshes);
  } else if (!out_.transmits) {
    out_.media = !leave_out(Skip::media, "no ray goes through anything");
  } else {
    out_.media = !leave_out(Skip::media, "all refractive indices are the same");
  }
}

void Planner::plan_patterns() {
  Things unseen, seen;
  for (std::size_t m = 0; m < has_.wearers.size(); ++m) {
    const scene::Material& material = scene_.materials[m];
    MaterialNeeds& needs = out_.needs[m];
    const auto is = [](const scene::Texture& texture) { return texture.pattern != k_none; };
    needs.pattern = !may(Skip::patterns) || (is(material.ambient) && needs.ambient) ||
                    (is(material.diffuse) && needs.diffuse) || (is(material.specular) && needs.specular) ||
                    (is(material.reflection) && needs.reflection) ||
                    (is(material.transmission) && needs.transmission);
    if (has_.wearers[m].any == k_none || !has_pattern(material)) continue;
    (needs.pattern ? seen : unseen).push_back(has_.wearers[m].any);
  }
  if (!seen.empty() && may(Skip::patterns)) {
    decide(Skip::patterns, Verdict::as_met, "worn by {}", seen);
  } else if (unseen.empty() && seen.empty()) {
    leave_out(Skip::patterns, "nothing wears one");
  } else {
    leave_out(Skip::patterns, "those of {} count in no term", unseen.empty() ? seen : unseen);
  }
}

/// Rays of neighbouring pixels go together where what a ray does does not depend on what others of its pixel
/// brought.
void Planner::plan_packets() {
  const auto by_itself = [&](std::string reason) {
    decide(Skip::single_rays, Verdict::needed, std::move(reason));
  };
  if (scene_.settings.sum != scene::Sum::linear) {
    by_itself("the sum of terms is not linear");
  } else if (out_.media && view_.projection == scene::Projection::orthographic) {
    by_itself("each ray starts in solids of its own");
  } else if (out_.faint_rays || out_.faint_lights) {
    by_itself("what is too faint to show is left out, ray by ray");
  } else if (out_.light_cells.used) {
    by_itself("lights are looked up by place");
  } else if (!may(Skip::dark_lights) || !may(Skip::zero_terms)) {
    by_itself("lights are asked even where they are dark");
  } else {
    out_.packets = leave_out(Skip::single_rays, "rays of neighbouring pixels are traced together");
  }
}

void Planner::plan_tree() {
  const std::string many = std::to_string(has_.primitives);
  // What lets light through is met by many rays that go different ways.
  const bool all_together = out_.packets && !out_.transmits;
  const std::uint64_t longest = all_together                   ? k_longest_packet_list
                                : has_.only_spheres_and_planes ? k_longest_list_of_spheres
                                                               : k_longest_list;
  if (has_.primitives > longest) {
    decide(Skip::tree, Verdict::needed, many + " things are more than a list is good for");
  } else {
    out_.tree = !leave_out(Skip::tree, many + " things are asked one by one");
  }
}

/// Things that brighten what is behind them: their shadows are more than the light itself.
Things Planner::bright_shadows() const {
  if (scene_.settings.shadows != scene::Shadows::filtered) return {};
  Things out;
  for (std::size_t m = 0; m < has_.wearers.size(); ++m) {
    if (has_.wearers[m].caster == k_none || !has_.terms[m].transmission) continue;
    const Color most = largest(scene_, scene_.materials[m].transmission);
    if (most.r > 1 || most.g > 1 || most.b > 1) out.push_back(has_.wearers[m].caster);
  }
  return out;
}

/// Where more than a few lights have their limits, they are looked up by place. For lamps that fade a part of
/// what may go missing is spent.
void Planner::plan_light_cells() {
  constexpr double k_part = 0.25;
  std::size_t spots = 0, fading = 0;
  for (const scene::Light& light : scene_.lights) {
    spots += light.kind == scene::LightKind::spot ? 1 : 0;
    fading += fades(light) ? 1 : 0;
  }
  LightCellPlan& cells = out_.light_cells;
  cells.spots = spots > 0 && may(Skip::dark_lights);
  const bool faint = fading > 0 && out_.faint_lights;
  cells.used = (cells.spots ? spots : 0) + (faint ? fading : 0) > k_few_lights;
  if (!cells.used) return;
  Aabb around = extent().bounded();
  for (const scene::Light& light : scene_.lights) {
    if (!(around.lo.x <= around.hi.x) && light.kind != scene::LightKind::sun) around.add(light.at);
  }
  const double size = max_abs(around.hi - around.lo);
  cells.middle = around.center();
  cells.reach = size > 0 ? size / 2 : 1;
  cells.size = cells.reach / 16;
  if (!faint) return;
  const double sent = most_sent(scene_, has_, out_.recursion ? scene_.settings.depth : 0);
  cells.faint = k_part * out_.faint_error * tolerance(0) / out_.exposure / std::max(sent, 1e-300);
  out_.faint_error *= 1 - k_part;
}

void Planner::plan_faint() {
  out_.faint_error = options_.error * k_faint_part;
  if (!(options_.error > 0)) {
    decide(Skip::faint_rays, Verdict::needed, "no error is asked for");
    decide(Skip::faint_lights, Verdict::needed, "no error is asked for");
    return;
  }
  if (suits_packets() && !out_.transmits && scene_.lights.size() <= k_few_lights) {
    // They take less time than it would take to see which do not matter.
    decide(Skip::faint_rays, Verdict::needed, "rays of neighbouring pixels are traced together");
    decide(Skip::faint_lights, Verdict::needed, "rays of neighbouring pixels are traced together");
    return;
  }
  if (const Things bright = bright_shadows(); !bright.empty()) {
    decide(Skip::faint_rays, Verdict::needed, "{} may make a light brighter without bound", bright);
    decide(Skip::faint_lights, Verdict::needed, "{} may make a light brighter without bound", bright);
    return;
  }
  out_.faint_lights = leave_out(Skip::faint_lights, "all of them in a pixel: below an eighth of the error",
                                {}, Thing::Kind::light, Verdict::as_met);
  if (!out_.recursion) {
    decide(Skip::faint_rays, Verdict::skipped, "no rays go on");
    return;
  }
  Brightness brightness(scene_);
  if (const auto& lamp = brightness.near_lamp()) {
    decide(Skip::faint_rays, Verdict::needed, "{} may be next to a surface, and so without bound",
           {lamp->light}, Thing::Kind::light);
    return;
  }
  out_.faint_rays = leave_out(Skip::faint_rays, "all of them in a pixel: below an eighth of the error", {},
                              Thing::Kind::shape, Verdict::as_met);
  out_.brightness = std::move(brightness);
}

}  // namespace

Plan plan(const scene::Scene& scene, const scene::View& view, const Options& options) {
  return Planner(scene, view, options).run();
}

}  // namespace lancer::tracer
