#include "tracer/shadow.hpp"

#include <algorithm>
#include <vector>

#include "tracer/crossings.hpp"
#include "tracer/pattern.hpp"

namespace lancer::tracer {
namespace {

using CrossingList = SmallList<Crossing, 8>;

/// By object, then along the ray: an order that does not depend on the search.
bool comes_first(const Crossing& a, const Crossing& b) {
  if (a.shape != b.shape) return a.shape < b.shape;
  if (a.root.entering != b.root.entering) return a.root.entering;
  if (a.root.t != b.root.t) return a.root.t < b.root.t;
  return a.primitive < b.primitive;
}

/// Where facets of one mesh meet, the ray crosses it once. In the order of comes_first.
bool repeats(const Crossing& before, const Crossing& now) {
  return before.shape == now.shape && before.primitive != now.primitive &&
         before.root.entering == now.root.entering &&
         now.root.t - now.root.error <= before.root.t + before.root.error;
}

Color transmission(const World& world, const Ray& ray, const Crossing& crossing) {
  const scene::Material& material = world.material_of(crossing.shape);
  if (material.transmission.pattern == scene::k_none) return material.transmission.color;
  const Vec3 on_ray = ray.origin + ray.direction * crossing.root.t;
  const Vec3 p = project(world, crossing.primitive, on_ray, crossing.root.face);
  return color_at(*world.scene, material.transmission,
                  own_point(world, crossing.shape, p, pattern_error(world, crossing.primitive, p)));
}

bool casts(const World& world, const Crossing& crossing) {
  return world.scene->shapes[crossing.shape].shadow;
}

Color filtered(const World& world, const Ray& ray, double distance, Stats& stats, bool any_hit) {
  CrossingList list;
  bool blocked = false;
  crossings(world, ray, distance, stats, [&](const Crossing& crossing) {
    if (!casts(world, crossing)) return false;
    list.push_back(crossing);
    blocked = blocked || is_black(*world.scene, world.material_of(crossing.shape).transmission);
    return blocked && any_hit;
  });
  if (blocked) return {};
  if (list.size() > 1) std::sort(list.begin(), list.end(), comes_first);
  Color through = grey(1);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i == 0 || !repeats(list[i - 1], list[i])) through = through * transmission(world, ray, list[i]);
  }
  return through;
}

}  // namespace

Color light_through(const World& world, ShadowWork work, const Ray& ray, double distance, Stats& stats,
                    bool any_hit) {
  if (work == ShadowWork::none) return grey(1);
  ++stats.shadow_rays;
  if (work == ShadowWork::filtered) return filtered(world, ray, distance, stats, any_hit);
  bool blocked = false;
  crossings(world, ray, distance, stats, [&](const Crossing& crossing) {
    blocked = blocked || casts(world, crossing);
    return blocked && any_hit;
  });
  return grey(blocked ? 0 : 1);
}

}  // namespace lancer::tracer
