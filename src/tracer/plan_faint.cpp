// What is too faint to show, where an error is asked for.

#include <algorithm>
#include <cmath>

#include "tracer/light.hpp"
#include "tracer/lights_in_reach.hpp"
#include "tracer/planner.hpp"

namespace lancer::tracer {

using scene::k_none;

/// Things that brighten what is behind them: their shadows are more than the light itself.
Planner::Things Planner::bright_shadows() const {
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
  if (!keeps_rays_apart() && !out_.transmits && scene_.lights.size() <= k_few_lights) {
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

}  // namespace lancer::tracer
