#include "tracer/shade.hpp"

#include <algorithm>
#include <cmath>

#include "base/math.hpp"
#include "tracer/light.hpp"
#include "tracer/media.hpp"
#include "tracer/optics.hpp"
#include "tracer/shadow.hpp"
#include "tracer/surface.hpp"

namespace lancer::tracer {
namespace {

Color clamped(Color c) {
  return {std::clamp(c.r, 0.0, 1.0), std::clamp(c.g, 0.0, 1.0), std::clamp(c.b, 0.0, 1.0)};
}

/// kd max(0, n.l) + ks max(0, n.h)^shininess, for a light in front.
Color reflected_light(const Surface& surface, Vec3 towards, Vec3 view, double n_dot_l) {
  Color sum = surface.diffuse * n_dot_l;
  if (is_black(surface.specular)) return sum;
  const double n_dot_h = larger(0, dot(surface.normal, normalize(towards + view)));
  return sum + surface.specular * math::pow(n_dot_h, surface.shininess);
}

/// A surface that a ray met, for the lights and rays that are asked from there.
struct Meeting {
  const Tracing& tracing;
  const Ray& ray;
  const Hit& hit;
  const Surface& surface;
};

/// `light`: a function, called only where something may be left out.
template <class Light>
bool is_too_faint(const Asking& asking, const Light& light, Stats& stats) {
  if (!asking.allowance || !asking.allowance->takes(asking.share * light())) return false;
  ++stats.lights_faint;
  return true;
}

/// The light's whole term without shadows. Nothing where it is known to be black, and need not be asked for
/// shadows; why is counted.
std::optional<Color> unshadowed(const Meeting& at, const scene::Light& light, const Bearing& from,
                                const Asking& asking, Stats& stats) {
  const Skips skips = at.tracing.plan->skips;
  const double n_dot_l = dot(at.surface.normal, from.towards);
  const bool in_front = n_dot_l > 0;
  if (!in_front && skips.has(Skip::dark_lights)) {
    ++stats.lights_behind;
    return std::nullopt;
  }
  const Color arriving = intensity(light, from);
  if (is_black(arriving) && skips.has(Skip::dark_lights)) {
    ++stats.lights_outside_cone;
    return std::nullopt;
  }
  // Before the highlight is worked out, and with it.
  const auto most = [&] {
    return arriving * (at.surface.diffuse * larger(0, n_dot_l) + at.surface.specular);
  };
  if (is_too_faint(asking, most, stats)) return std::nullopt;
  const Color sent =
      in_front ? arriving * reflected_light(at.surface, from.towards, -at.ray.direction, n_dot_l) : Color{};
  if (is_black(sent) && in_front && !is_black(arriving) && skips.has(Skip::zero_terms)) {
    ++stats.lights_unanswered;
    return std::nullopt;
  }
  if (is_too_faint(
          asking, [&] { return sent; }, stats))
    return std::nullopt;
  return sent;
}

Color from_light(const Meeting& at, const scene::Light& light, const Asking& asking, Stats& stats) {
  const Plan& plan = *at.tracing.plan;
  const Bearing from = bearing(light, at.hit.point);
  if (from.distance == 0) return {};
  const std::optional<Color> sent = unshadowed(at, light, from, asking, stats);
  if (!sent) return {};
  if (plan.shadows == ShadowWork::none) return *sent;
  const World& world = *at.tracing.world;
  const Ray shadow_ray = ray_from(world, at.hit, from.towards);
  const Color through = light_through(world, plan.shadows, shadow_ray, from.distance, stats, plan.any_hit);
  return is_black(*sent) ? Color{} : through * *sent;
}

void ask_lights(const Meeting& at, const Asking& asking, Joined& sum, Stats& stats) {
  const Plan& plan = *at.tracing.plan;
  const std::vector<scene::Light>& all = at.tracing.world->lights;
  const auto ask = [&](const scene::Light& light) { sum.add(from_light(at, light, asking, stats)); };
  const std::vector<scene::Index>* some = plan.every_light ? nullptr : &plan.lights;
  if (asking.cells) {
    const LightCells::Cell& cell = asking.cells->at(at.hit.point + at.tracing.world->origin);
    stats.lights_outside_cone += cell.outside_cone;
    stats.lights_faint += cell.faint;
    some = &cell.lights;
  }
  const std::size_t count = some ? some->size() : all.size();
  for (std::size_t i = 0; i < count && !at.tracing.cancelled(); ++i) ask(all[some ? (*some)[i] : i]);
}

/// A ray from the hit, where rays that have not turned off are inside of the solids `open`. A ray that only
/// touches a sphere or box goes on outside, whichever way rounding has it.
void branch_off(const Meeting& at, Vec3 direction, Color share, const OpenSolids& open,
                std::optional<Branch>& out, Stats& stats) {
  const World& world = *at.tracing.world;
  Branch& branch = out.emplace(ray_from(world, at.hit, direction), share);
  branch.ray.open = open;
  if (!at.tracing.plan->media || !is_convex_solid(world.primitives[at.hit.primitive].kind)) return;
  ++stats.medium_changes;
  cross(world, branch.ray.open, at.hit.shape, dot(at.hit.normal, direction) < 0);
}

void reflect(const Meeting& at, Color share, std::optional<Branch>& out, Stats& stats) {
  branch_off(at, mirrored(at.ray.direction, at.surface.normal), share, at.ray.open, out, stats);
}

/// The two directions in which light goes on, and what of it.
void add_branches(const Meeting& at, Shaded& out, Stats& stats) {
  const auto& [tracing, ray, hit, surface] = at;
  const World& world = *tracing.world;
  ++stats.branchings;
  Color mirror_share = surface.reflection;
  Color through_share = surface.transmission;
  if (!is_black(through_share)) {
    OpenSolids beyond = ray.open;
    double from = 1, to = 1;
    if (tracing.plan->media) {
      ++stats.medium_changes;
      cross(world, beyond, hit.shape, hit.root.entering);
      from = refractive_index(world, ray.open);
      to = refractive_index(world, beyond);
    }
    if (surface.fresnel) {
      const double f = fresnel(ray.direction, surface.normal, from, to);
      mirror_share += f * through_share;
      through_share = (1 - f) * through_share;
    }
    const std::optional<Vec3> direction = refracted(ray.direction, surface.normal, from, to);
    if (!direction) {
      reflect(at, mirror_share, out.reflected, stats);
      out.reflected->also = through_share;
      return;
    }
    if (!is_black(through_share)) {
      branch_off(at, *direction, through_share, beyond, out.transmitted, stats);
    }
  }
  if (!is_black(mirror_share)) reflect(at, mirror_share, out.reflected, stats);
}

}  // namespace

void Joined::add_clamped(Color term) {
  const Color t = clamped(term);
  value_ = value_ + t * (grey(1) - value_);
}

bool Joined::is_full() const { return how_ == scene::Sum::log && value_ == grey(1); }

Shaded shade(const Tracing& tracing, const Ray& ray, const Hit& hit, bool follow, Stats& stats,
             const Asking& asking) {
  const Plan& plan = *tracing.plan;
  const scene::Scene& scene = *tracing.world->scene;
  const MaterialNeeds& needs = plan.needs_of(scene.shapes[hit.shape].material);
  const Surface surface = surface_at(*tracing.world, needs, ray, hit, follow, stats);
  const Meeting at{tracing, ray, hit, surface};
  Shaded out(scene.settings.sum);
  out.own.add(surface.ambient * scene.settings.ambient);
  if (needs.direct) {
    ask_lights(at, asking, out.own, stats);
  } else {
    stats.lights_unanswered += plan.every_light ? scene.lights.size() : plan.lights.size();
  }
  if (follow && needs.onward) add_branches(at, out, stats);
  return out;
}

}  // namespace lancer::tracer
