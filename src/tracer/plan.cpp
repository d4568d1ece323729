#include "tracer/plan.hpp"

#include <algorithm>
#include <utility>

#include "scene/corners.hpp"
#include "tracer/lights_in_reach.hpp"
#include "tracer/pattern.hpp"
#include "tracer/planner.hpp"

namespace lancer::tracer {

using scene::k_none;

Plan Planner::run() {
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
Planner::Things Planner::other_indices() const {
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
Planner::Things Planner::meshes_around_rays() const {
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
  if (const char* const reason = keeps_rays_apart()) {
    by_itself(reason);
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
    out_.tree = !leave_out(Skip::tree, has_.primitives == 1 ? "there is one thing alone"
                                                            : many + " things are asked one by one");
  }
}

Plan plan(const scene::Scene& scene, const scene::View& view, const Options& options) {
  return Planner(scene, view, options).run();
}

}  // namespace lancer::tracer
