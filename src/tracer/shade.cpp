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
  const double n_dot_h = std::fmax(0, dot(surface.normal, normalize(towards + view)));
  return sum + surface.specular * math::pow(n_dot_h, surface.shininess);
}

Color from_light(const Tracing& tracing, const scene::Light& light, const Ray& ray, const Hit& hit,
                 const Surface& surface, Stats& stats) {
  const Incoming in = incoming(light, hit.point);
  if (is_black(in.intensity)) return {};
  const double n_dot_l = dot(surface.normal, in.towards);
  if (!(n_dot_l > 0)) return {};
  const Color unshadowed = in.intensity * reflected_light(surface, in.towards, -ray.direction, n_dot_l);
  if (is_black(unshadowed)) return {};
  if (tracing.plan->shadows == ShadowWork::none) return unshadowed;
  const Ray shadow_ray = ray_from(*tracing.world, hit, in.towards);
  return light_through(*tracing.world, tracing.plan->shadows, shadow_ray, in.distance, stats) * unshadowed;
}

/// The solids that a ray from the hit is inside of. A ray that only touches a sphere or box goes on outside,
/// whichever way rounding has it.
OpenSolids open_after(const Tracing& tracing, const Hit& hit, Vec3 direction, OpenSolids open) {
  const World& world = *tracing.world;
  if (!tracing.plan->media || !is_convex_solid(world.primitives[hit.primitive].kind)) return open;
  cross(world, open, hit.shape, dot(hit.normal, direction) < 0);
  return open;
}

Branch reflection(const Tracing& tracing, const Ray& ray, const Hit& hit, const Surface& surface,
                  Color share) {
  Branch branch{ray_from(*tracing.world, hit, mirrored(ray.direction, surface.normal)), share, {}};
  branch.ray.open = open_after(tracing, hit, branch.ray.direction, ray.open);
  return branch;
}

/// The two directions in which light goes on, and what of it.
void add_branches(const Tracing& tracing, const Ray& ray, const Hit& hit, const Surface& surface,
                  Shaded& out) {
  const World& world = *tracing.world;
  Color mirror_share = surface.reflection;
  Color through_share = surface.transmission;
  if (!is_black(through_share)) {
    OpenSolids beyond = ray.open;
    double from = 1, to = 1;
    if (tracing.plan->media) {
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
      out.reflected = reflection(tracing, ray, hit, surface, mirror_share);
      out.reflected->also = through_share;
      return;
    }
    if (!is_black(through_share)) {
      out.transmitted = Branch{ray_from(world, hit, *direction), through_share, {}};
      out.transmitted->ray.open = open_after(tracing, hit, *direction, beyond);
    }
  }
  if (!is_black(mirror_share)) out.reflected = reflection(tracing, ray, hit, surface, mirror_share);
}

}  // namespace

void Joined::add(Color term) {
  if (how_ == scene::Sum::linear) {
    value_ += term;
  } else {
    const Color t = clamped(term);
    value_ = value_ + t * (grey(1) - value_);
  }
}

bool Joined::is_full() const { return how_ == scene::Sum::log && value_ == grey(1); }

Shaded shade(const Tracing& tracing, const Ray& ray, const Hit& hit, bool follow, Stats& stats) {
  const scene::Scene& scene = *tracing.world->scene;
  const Surface surface = surface_at(*tracing.world, ray, hit);
  Shaded out{Joined(scene.settings.sum), {}, {}};
  out.own.add(surface.ambient * scene.settings.ambient);
  for (const scene::Light& light : tracing.world->lights) {
    if (tracing.cancelled()) break;
    out.own.add(from_light(tracing, light, ray, hit, surface, stats));
  }
  if (follow) add_branches(tracing, ray, hit, surface, out);
  return out;
}

}  // namespace lancer::tracer
