#include "tracer/shadow.hpp"

#include <algorithm>
#include <span>
#include <tuple>

#include "tracer/crossings.hpp"
#include "tracer/pattern.hpp"

namespace lancer::tracer {
namespace {

using CrossingList = SmallList<Crossing, 8>;

/// By object, then along the ray: an order that does not depend on the search.
bool comes_first(const Crossing& a, const Crossing& b) {
  return std::make_tuple(a.shape, a.root.t, a.primitive) < std::make_tuple(b.shape, b.root.t, b.primitive);
}

/// Where facets of one object meet, the ray crosses it once: of a closed mesh in the way that is left over
/// where it goes in, out and in again, and in and out where none is. Of crossings at one place, which are all
/// of one object, those that count.
void add_joined(const World& world, std::span<const Crossing> met, CrossingList& out) {
  int way = 0;
  for (const Crossing& c : met) way += c.root.entering ? 1 : -1;
  const bool both_ways = way == 0 || !encloses(*world.scene, met.front().shape);
  for (const bool entering : {true, false}) {
    if (!both_ways && entering != (way > 0)) continue;
    const auto fits = [&](const Crossing& c) { return c.root.entering == entering; };
    const auto one = std::find_if(met.begin(), met.end(), fits);
    if (one != met.end()) out.push_back(*one);
  }
}

/// In the order of comes_first.
CrossingList joined(const World& world, const CrossingList& list) {
  if (list.size() < 2) return list;
  CrossingList out;
  for (const Crossing* first = list.begin(); first != list.end();) {
    double end = first->root.t + first->root.error;
    const Crossing* last = first + 1;
    for (; last != list.end() && last->shape == first->shape && last->root.t - last->root.error <= end;
         ++last) {
      end = std::max(end, last->root.t + last->root.error);
    }
    add_joined(world, {first, last}, out);
    first = last;
  }
  return out;
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
  for (const Crossing& crossing : joined(world, list)) through = through * transmission(world, ray, crossing);
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
