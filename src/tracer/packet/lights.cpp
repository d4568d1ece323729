// What lights add to the hits of a wave.

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/math.hpp"
#include "tracer/light.hpp"
#include "tracer/packet/hits.hpp"
#include "tracer/shadow.hpp"

namespace lancer::tracer {
namespace {

/// The way to the light, where the kernel leaves it out: for very small and very large scenes. Returns how
/// many have the light at the very point.
std::uint64_t find_bearings(const scene::Light& light, const Hits& hits, Lighting& room) {
  std::uint64_t there = 0;
  for (std::size_t i = 0; i < hits.count; ++i) {
    if (room.known[i] != 0 || hits.direct[i] == 0) continue;
    const Bearing from = bearing(light, hits.point[i]);
    room.towards.set(i, from.towards);
    room.distance[i] = from.distance;
    room.n_dot_l[i] = dot(hits.facing[i], from.towards);
    const double outward = dot(hits.normal[i], from.towards);
    room.starts.rise[i] = std::fabs(outward);
    room.starts.passes[i] = hits.convex[i] != 0 && outward < 0 ? -1 : 0;
    room.asked[i] = from.distance != 0 && room.n_dot_l[i] > 0 ? -1 : 0;
    there += from.distance == 0 ? 1 : 0;
  }
  return there;
}

/// What arrives, where that is not everywhere the same. Returns at how many hits nothing does.
std::uint64_t find_arriving(const scene::Light& light, const Hits& hits, Lighting& room, Stats& stats) {
  std::uint64_t outside = 0;
  for (std::size_t i = 0; i < hits.count; ++i) {
    if (room.asked[i] == 0) continue;
    const Color arriving = intensity(light, {room.towards[i], room.distance[i]});
    room.arriving.set(i, arriving);
    if (!is_black(arriving)) continue;
    ++outside;
    room.asked[i] = 0;
  }
  stats.lights_outside_cone += outside;
  return outside;
}

void find_highlights(const Hits& hits, Lighting& room) {
  if (!hits.any_specular) {
    std::fill_n(room.highlight.at.begin(), hits.count, 0.0);
    return;
  }
  LANCER_ON_TARGET(find_shiny(room.asked, hits.specular, room.shiny, hits.count));
  bool all_known = LANCER_ON_TARGET(halfway({&hits.facing, &hits.direction, &room.towards, &room.shiny},
                                            room.n_dot_h, room.known, hits.count));
  for (std::size_t i = 0; i < hits.count && !all_known; ++i) {
    if (room.known[i] != 0 || room.shiny[i] == 0) continue;
    room.n_dot_h[i] = std::fmax(0, dot(hits.facing[i], normalize(room.towards[i] + -hits.direction[i])));
  }
  all_known = LANCER_ON_TARGET(
      powers(room.n_dot_h, hits.shininess, room.shiny, room.highlight, room.known, hits.count));
  for (std::size_t i = 0; i < hits.count && !all_known; ++i) {
    if (room.known[i] != 0 || room.shiny[i] == 0) continue;
    room.highlight[i] = math::pow(room.n_dot_h[i], hits.shininess[i]);
  }
}

/// What the solids leave of light that shines through them, in the order of the scene.
Color filtered(const World& world, Filters& filters, std::size_t i) {
  auto* const first = filters.crossed[i].data();
  auto* const last = first + filters.count[i];
  std::sort(first, last);
  Color through = grey(1);
  for (const std::uint32_t* one = first; one != last; ++one) {
    const Color leaves = world.material_of(world.primitives[*one / 2].shape).transmission.color;
    through = through * leaves;
    if (*one % 2 != 0) through = through * leaves;
  }
  return through;
}

/// Light by the shadow ray of a hit alone.
void add_alone(const Tracing& tracing, Hits& hits, const Lighting& room, std::size_t i, Stats& stats) {
  const Plan& plan = *tracing.plan;
  const Ray ray = ray_from(*tracing.world, hits.hit(*tracing.world, i), room.towards[i]);
  --stats.shadow_rays;  // counted there
  const Color through =
      light_through(*tracing.world, plan.shadows, ray, room.distance[i], stats, plan.any_hit);
  if (!is_black(through)) hits.own.set(i, hits.own[i] + through * room.sent[i]);
}

/// Adds the light where nothing is in its way.
void add_unblocked(const Tracing& tracing, const Scenery& scenery, Hits& hits, Lighting& room, Stats& stats) {
  const Plan& plan = *tracing.plan;
  if (plan.shadows == ShadowWork::none) {
    LANCER_ON_TARGET(add_sent(room.sent, room.asked, hits.own, hits.count));
    return;
  }
  if (!plan.any_hit) {
    for (std::size_t i = 0; i < hits.count; ++i) {
      if (room.asked[i] != 0) add_alone(tracing, hits, room, i, stats);
    }
    return;
  }
  Filters* const filters = plan.shadows == ShadowWork::filtered ? &room.filters : nullptr;
  Work work;
  const RaysView rays{&hits.point, &room.towards, &room.starts, &room.exits, nullptr, hits.count};
  LANCER_ON_TARGET(find_exits(scenery, rays, &room.asked, room.exits));
  LANCER_ON_TARGET(
      find_blocked(scenery, {rays, &room.asked, &room.distance}, {&room.seen, &room.lit, filters}, work));
  stats.shape_tests += work.shape_tests;
  stats.node_visits += work.node_visits;
  LANCER_ON_TARGET(add_sent(room.sent, room.lit, hits.own, hits.count));
  for (std::size_t i = 0; i < hits.count && work.unclear > 0; ++i) {
    if (room.asked[i] == 0 || room.lit[i] != 0 || room.seen[i] == Outlook::surface) continue;
    if (room.seen[i] == Outlook::in_doubt) {
      add_alone(tracing, hits, room, i, stats);
    } else {
      hits.own.set(i, hits.own[i] + filtered(*tracing.world, *filters, i) * room.sent[i]);
    }
  }
}

void add_light(const Tracing& tracing, const Scenery& scenery, const scene::Light& light, Hits& hits,
               Lighting& room, Stats& stats) {
  const bool is_sun = light.kind == scene::LightKind::sun;
  const LightView view{is_sun,
                       is_sun ? bearing(light, {}).towards : light.at,
                       &hits.point,
                       &hits.facing,
                       &hits.normal,
                       &hits.convex,
                       &hits.direct,
                       &room.towards,
                       &room.distance,
                       &room.n_dot_l,
                       &room.known,
                       &room.asked,
                       &room.starts.rise,
                       &room.starts.passes};
  std::uint64_t direct = LANCER_ON_TARGET(count_set(hits.direct, hits.count));
  if (!LANCER_ON_TARGET(look_at_light(view, hits.count))) direct -= find_bearings(light, hits, room);
  std::uint64_t asked = LANCER_ON_TARGET(count_set(room.asked, hits.count));
  stats.lights_behind += direct - asked;
  const bool same = light.kind != scene::LightKind::spot && !fades(light);
  const Color everywhere = same ? intensity(light, {{}, 1}) : Color{};
  if (same && is_black(everywhere)) {
    stats.lights_outside_cone += asked;
    return;
  }
  if (!same) asked -= find_arriving(light, hits, room, stats);
  find_highlights(hits, room);
  LANCER_ON_TARGET(send({&hits.diffuse, &hits.specular, same ? nullptr : &room.arriving, everywhere,
                         &room.n_dot_l, &room.highlight, &room.sent, &room.asked},
                        hits.count));
  const std::uint64_t answered = LANCER_ON_TARGET(count_set(room.asked, hits.count));
  stats.lights_unanswered += asked - answered;
  if (answered == 0) return;
  stats.shadow_rays += tracing.plan->shadows != ShadowWork::none ? answered : 0;
  add_unblocked(tracing, scenery, hits, room, stats);
}

}  // namespace

void add_lights(const Tracing& tracing, const Scenery& scenery, Hits& hits, Lighting& room, Stats& stats) {
  const Plan& plan = *tracing.plan;
  const std::vector<scene::Light>& all = tracing.world->lights;
  const std::size_t count = plan.every_light ? all.size() : plan.lights.size();
  if (hits.count == 0) return;
  const auto copy = [&](const auto& from, auto& to) {
    std::copy_n(from.at.begin(), hits.count, to.at.begin());
  };
  copy(hits.error, room.starts.error);
  copy(hits.primitive_word, room.starts.primitive);
  copy(hits.shape, room.starts.shape);
  for (std::size_t i = 0; i < count && !tracing.cancelled(); ++i) {
    add_light(tracing, scenery, all[plan.every_light ? i : plan.lights[i]], hits, room, stats);
  }
}

}  // namespace lancer::tracer
