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

/// A surface that a ray met, for the lights and rays that are asked from there.
struct Meeting {
  const Tracing& tracing;
  const Ray& ray;
  const Hit& hit;
  const Surface& surface;
};

/// What a light sends along the ray.
class LightTerm {
 public:
  LightTerm(const Meeting& at, const scene::Light& light)
      : at_(at),
        light_(light),
        from_(bearing(light, at.hit.point)),
        n_dot_l_(dot(at.surface.normal, from_.towards)) {}

  /// Is it known to be black, or too faint to show? Then it need not be asked for shadows; why is counted.
  bool is_left_out(const Asking& asking, Stats& stats) {
    const Skips skips = at_.tracing.plan->skips;
    if (from_.distance == 0) return true;
    if (!is_in_front() && skips.has(Skip::dark_lights)) {
      ++stats.lights_behind;
      return true;
    }
    arriving_ = intensity(light_, from_);
    if (is_black(arriving_) && skips.has(Skip::dark_lights)) {
      ++stats.lights_outside_cone;
      return true;
    }
    // What spreads is nearly always enough to know that the light is asked for shadows.
    if (!asking.allowance && is_in_front() && !is_black(arriving_ * spread())) return false;
    return is_highlight_left_out(asking, stats);
  }

  /// Without shadows, of a light that is not left out.
  Color unshadowed() const { return is_in_front() ? arriving_ * (spread() + highlight()) : Color{}; }

  /// The way to the light.
  const Bearing& from() const { return from_; }

 private:
  bool is_in_front() const { return n_dot_l_ > 0; }
  /// kd n.l
  Color spread() const { return at_.surface.diffuse * n_dot_l_; }
  /// ks max(0, n.h)^shininess
  Color highlight() const {
    if (is_black(at_.surface.specular)) return {};
    const double n_dot_h = larger(0, dot(at_.surface.normal, normalize(from_.towards - at_.ray.direction)));
    return at_.surface.specular * math::pow(n_dot_h, at_.surface.shininess);
  }

  [[gnu::noinline]] bool is_highlight_left_out(const Asking& asking, Stats& stats) const {
    const auto is_faint = [&](Color light) {
      if (!asking.allowance || !asking.allowance->takes(asking.share * light)) return false;
      ++stats.lights_faint;
      return true;
    };
    // Before the highlight is worked out, and with it.
    if (is_faint(arriving_ * (at_.surface.diffuse * larger(0, n_dot_l_) + at_.surface.specular))) return true;
    const Color sent = unshadowed();
    if (is_black(sent) && is_in_front() && !is_black(arriving_) &&
        at_.tracing.plan->skips.has(Skip::zero_terms)) {
      ++stats.lights_unanswered;
      return true;
    }
    return is_faint(sent);
  }

  const Meeting& at_;
  const scene::Light& light_;
  Bearing from_;
  double n_dot_l_;
  Color arriving_;
};

Color from_light(const Meeting& at, const scene::Light& light, const Asking& asking, Stats& stats) {
  const Plan& plan = *at.tracing.plan;
  LightTerm term(at, light);
  if (term.is_left_out(asking, stats)) return {};
  if (plan.shadows == ShadowWork::none) return term.unshadowed();
  const World& world = *at.tracing.world;
  const Ray shadow_ray = ray_from(world, at.hit, term.from().towards);
  const Color through =
      light_through(world, plan.shadows, shadow_ray, term.from().distance, stats, plan.any_hit);
  if (is_black(through)) return {};
  const Color sent = term.unshadowed();
  return is_black(sent) ? Color{} : through * sent;
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
  Branch& branch = out.emplace();
  restart(world, at.hit, direction, branch.ray);
  branch.share = share;
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
