#include "tracer/packet/hits.hpp"

#include <algorithm>
#include <cmath>

#include "base/math.hpp"
#include "tracer/light.hpp"
#include "tracer/pattern.hpp"
#include "tracer/shadow.hpp"

namespace lancer::tracer {
namespace {

bool is_smooth(const scene::Scene& scene, std::uint32_t index) {
  const scene::Shape& shape = scene.shapes[index];
  if (shape.kind == scene::ShapeKind::facet) return scene.facets[shape.record].normals != scene::k_none;
  return shape.kind == scene::ShapeKind::mesh && !scene.meshes[shape.record].normals.empty();
}

/// The way to the light, where the kernel leaves it out: for very small and very large scenes.
void find_bearings(const scene::Light& light, const Hits& hits, Lighting& room) {
  for (std::size_t i = 0; i < hits.count; ++i) {
    if (room.known[i] != 0 || hits.there[i] == 0) continue;
    const Bearing from = bearing(light, hits.point[i]);
    room.towards.set(i, from.towards);
    room.distance[i] = from.distance;
    room.n_dot_l[i] = dot(hits.facing[i], from.towards);
    const double outward = dot(hits.normal[i], from.towards);
    room.starts.rise[i] = std::fabs(outward);
    room.starts.passes[i] = hits.convex[i] != 0 && outward < 0 ? -1 : 0;
  }
}

/// Which hits the light may shine on, and with what.
void find_arriving(const scene::Light& light, const Hits& hits, Lighting& room, Stats& stats) {
  const bool same = light.kind != scene::LightKind::spot && !fades(light);
  const Color everywhere = same ? intensity(light, {{}, 1}) : Color{};
  for (std::size_t i = 0; i < hits.count; ++i) {
    room.asked[i] = 0;
    room.arriving.set(i, everywhere);
    if (hits.there[i] == 0 || !hits.needs[i]->direct || room.distance[i] == 0) continue;
    if (!(room.n_dot_l[i] > 0)) {
      ++stats.lights_behind;
      continue;
    }
    if (!same) room.arriving.set(i, intensity(light, {room.towards[i], room.distance[i]}));
    if (is_black(room.arriving[i])) {
      ++stats.lights_outside_cone;
    } else {
      room.asked[i] = -1;
    }
  }
}

void find_highlights(const Hits& hits, Lighting& room) {
  if (!hits.any_specular) {
    std::fill_n(room.highlight.at.begin(), hits.count, 0.0);
    return;
  }
  LANCER_ON_TARGET(halfway(hits.facing, hits.direction, room.towards, room.n_dot_h, room.known, hits.count));
  for (std::size_t i = 0; i < hits.count; ++i) {
    if (room.known[i] != 0 || room.asked[i] == 0) continue;
    room.n_dot_h[i] = std::fmax(0, dot(hits.facing[i], normalize(room.towards[i] + -hits.direction[i])));
  }
  LANCER_ON_TARGET(powers(room.n_dot_h, hits.shininess, room.highlight, room.known, hits.count));
  for (std::size_t i = 0; i < hits.count; ++i) {
    if (room.asked[i] == 0 || is_black(hits.specular[i])) {
      room.highlight[i] = 0;
    } else if (room.known[i] == 0) {
      room.highlight[i] = math::pow(room.n_dot_h[i], hits.shininess[i]);
    }
  }
}

/// Adds the light where nothing is in its way.
void add_unblocked(const Tracing& tracing, const Scenery& scenery, Hits& hits, Lighting& room, Stats& stats) {
  const Plan& plan = *tracing.plan;
  const bool together = plan.shadows != ShadowWork::none && plan.any_hit;
  if (together) {
    room.starts.error = hits.error;
    room.starts.primitive = hits.primitive_word;
    room.starts.shape = hits.shape;
    Work work;
    LANCER_ON_TARGET(find_blocked(
        scenery, {{&hits.point, &room.towards, &room.starts, hits.count}, &room.asked, &room.distance},
        room.seen, work));
    stats.shape_tests += work.shape_tests;
    stats.node_visits += work.node_visits;
  }
  for (std::size_t i = 0; i < hits.count; ++i) {
    if (room.asked[i] == 0) continue;
    const Color sent = room.sent[i];
    Color through = grey(1);
    if (together && room.seen[i] != Outlook::in_doubt) {
      ++stats.shadow_rays;
      through = grey(room.seen[i] == Outlook::surface ? 0 : 1);
    } else if (plan.shadows != ShadowWork::none) {
      const Ray ray = ray_from(*tracing.world, hits.hit(*tracing.world, i), room.towards[i]);
      through = light_through(*tracing.world, plan.shadows, ray, room.distance[i], stats, plan.any_hit);
    }
    hits.own.set(i, hits.own[i] + (plan.shadows == ShadowWork::none ? sent : through * sent));
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
                       &room.towards,
                       &room.distance,
                       &room.n_dot_l,
                       &room.known,
                       &room.starts.rise,
                       &room.starts.passes};
  LANCER_ON_TARGET(look_at_light(view, hits.count));
  find_bearings(light, hits, room);
  find_arriving(light, hits, room, stats);
  find_highlights(hits, room);
  LANCER_ON_TARGET(
      send({&hits.diffuse, &hits.specular, &room.arriving, &room.n_dot_l, &room.highlight, &room.sent},
           hits.count));
  for (std::size_t i = 0; i < hits.count; ++i) {
    if (room.asked[i] == 0 || !is_black(room.sent[i])) continue;
    ++stats.lights_unanswered;
    room.asked[i] = 0;
  }
  add_unblocked(tracing, scenery, hits, room, stats);
}

}  // namespace

Ray Rays::ray(std::size_t i, bool from_eye) const {
  Ray ray{origin[i], direction[i], from_eye ? 0 : starts.error[i], {}, {}};
  if (!from_eye) ray.contacts.push_back(contact[i]);
  return ray;
}

Ground ground(const World& world, std::uint32_t primitive) {
  const Primitive& p = world.primitives[primitive];
  if (p.kind == Kind::sphere) return Ground::sphere;
  if (p.kind == Kind::facet) return Ground::facet;
  const int across = p.kind == Kind::plane ? world.planes[p.record].across : -1;
  return across < 0 ? Ground::other : static_cast<Ground>(static_cast<int>(Ground::plane_x) + across);
}

Contact Hits::contact(const World& world, std::size_t i, bool inside, bool left) const {
  const auto of = static_cast<std::uint32_t>(shape[i]);
  const bool joined = world.primitives[primitive[i]].kind == Kind::facet && encloses(*world.scene, of);
  return {primitive[i], of, face[i], inside, inside, left, joined, normal[i]};
}

Hit Hits::hit(const World& world, std::size_t i) const {
  Hit hit;
  hit.primitive = primitive[i];
  hit.shape = static_cast<std::uint32_t>(shape[i]);
  hit.root.t = t[i];
  hit.root.entering = entering[i] != 0;
  hit.root.face = face[i];
  hit.point = point[i];
  hit.point_error = error[i];
  hit.normal = normal[i];
  hit.contacts.push_back(contact(world, i, !hit.root.entering, false));
  return hit;
}

void find_surfaces(const Tracing& tracing, Hits& hits, bool follow, Stats& stats) {
  const World& world = *tracing.world;
  const scene::Scene& scene = *world.scene;
  const Plan& plan = *tracing.plan;
  hits.any_specular = false;
  for (std::size_t i = 0; i < hits.count; ++i) {
    if (hits.there[i] == 0) continue;
    const Primitive& primitive = world.primitives[hits.primitive[i]];
    hits.primitive_word[i] = hits.primitive[i];
    hits.shape[i] = primitive.shape;
    hits.convex[i] = is_convex_solid(primitive.kind) ? -1 : 0;
    const scene::Index index = scene.shapes[primitive.shape].material;
    const scene::Material& m = scene.materials[index];
    const MaterialNeeds& needs = plan.needs_of(index);
    hits.needs[i] = &needs;
    const bool plain = !needs.pattern && !has_pattern(m) && !is_smooth(scene, primitive.shape);
    const Vec3 outward = hits.normal[i];
    const Surface surface = plain ? Surface{hits.entering[i] != 0 ? outward : -outward,
                                            m.ambient.color,
                                            m.diffuse.color,
                                            m.specular.color,
                                            m.reflection.color,
                                            {},
                                            m.shininess,
                                            false}
                                  : surface_at(world, needs, {hits.origin[i], hits.direction[i], 0, {}, {}},
                                               hits.hit(world, i), follow, stats);
    hits.facing.set(i, surface.normal);
    hits.own.set(i, Color{} + surface.ambient * scene.settings.ambient);
    hits.diffuse.set(i, surface.diffuse);
    hits.specular.set(i, surface.specular);
    hits.reflection.set(i, surface.reflection);
    hits.shininess[i] = surface.shininess;
    hits.any_specular = hits.any_specular || !is_black(surface.specular);
    if (!needs.direct) stats.lights_unanswered += plan.every_light ? scene.lights.size() : plan.lights.size();
  }
}

void add_lights(const Tracing& tracing, const Scenery& scenery, Hits& hits, Lighting& room, Stats& stats) {
  const Plan& plan = *tracing.plan;
  const std::vector<scene::Light>& all = tracing.world->lights;
  const std::size_t count = plan.every_light ? all.size() : plan.lights.size();
  for (std::size_t i = 0; i < count && !tracing.cancelled(); ++i) {
    add_light(tracing, scenery, all[plan.every_light ? i : plan.lights[i]], hits, room, stats);
  }
}

}  // namespace lancer::tracer
