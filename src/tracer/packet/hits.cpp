#include "tracer/packet/hits.hpp"

#include "tracer/surface.hpp"

namespace lancer::tracer {
namespace {

/// Where the surface depends on the point.
void find_surface(const Tracing& tracing, Hits& hits, std::size_t i, bool follow, Stats& stats) {
  const scene::Scene& scene = *tracing.world->scene;
  const auto shape = static_cast<std::uint32_t>(hits.shape[i]);
  const MaterialNeeds& needs = tracing.plan->needs_of(scene.shapes[shape].material);
  const Ray ray{hits.origin[i], hits.direction[i], 0, {}, {}};
  const Surface surface = surface_at(*tracing.world, needs, ray, hits.hit(*tracing.world, i), follow, stats);
  hits.facing.set(i, surface.normal);
  hits.own.set(i, Color{} + surface.ambient * scene.settings.ambient);
  hits.diffuse.set(i, surface.diffuse);
  hits.specular.set(i, surface.specular);
  hits.reflection.set(i, surface.reflection);
  hits.transmission.set(i, surface.transmission);
}

}  // namespace

Ray single_ray(const World& world, const Rays& rays, std::size_t i, const OpenLists& lists) {
  Ray ray{rays.origin[i], rays.direction[i], 0, {}, {}};
  if (rays.from_eye) return ray;
  const Vec3 normal = rays.normal[i];
  ray.origin_error = rays.starts.error[i];
  ray.contacts.push_back(contact_at(world, static_cast<std::uint32_t>(rays.starts.primitive[i]), rays.face[i],
                                    normal, dot(normal, ray.direction) < 0, true));
  ray.open = lists.open(static_cast<std::uint32_t>(rays.starts.open[i]));
  return ray;
}

Contact contact_at(const World& world, std::uint32_t primitive, std::uint8_t face, Vec3 normal, bool inside,
                   bool left) {
  const Primitive& p = world.primitives[primitive];
  const bool joined = p.kind == Kind::facet && encloses(*world.scene, p.shape);
  return {primitive, p.shape, face, inside, inside, left, joined, normal};
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
  hit.contacts.push_back(
      contact_at(world, hit.primitive, hit.root.face, hit.normal, !hit.root.entering, false));
  return hit;
}

void find_surfaces(const Tracing& tracing, const Looks& looks, Hits& hits, bool follow, Stats& stats) {
  const Plan& plan = *tracing.plan;
  const std::size_t count = hits.count;
  std::array<const Paint*, k_wave + k_group> paints;
  bool all_plain = true;
  hits.any_specular = hits.any_transmission = false;
  std::size_t unanswered = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t primitive = hits.primitive[i];
    const Look& look = looks.primitives[primitive];
    const Paint& one = *(paints[i] = &looks.paint(look));
    hits.primitive_word[i] = primitive;
    hits.shape[i] = look.shape;
    hits.convex[i] = look.is_convex ? -1 : 0;
    hits.direct[i] = one.direct & hits.there[i];
    hits.onward[i] = one.onward & hits.there[i];
    hits.shininess[i] = one.shininess;
    hits.fresnel[i] = one.fresnel;
    all_plain = all_plain && look.is_plain;
    hits.any_specular = hits.any_specular || !is_black(one.specular);
    hits.any_transmission = hits.any_transmission || !is_black(one.transmission);
    unanswered += hits.there[i] != 0 && one.direct == 0 ? 1 : 0;
  }
  stats.lights_unanswered +=
      unanswered * (plan.every_light ? tracing.world->lights.size() : plan.lights.size());
  // Patterns may have any of them.
  hits.any_specular = hits.any_specular || !all_plain;
  hits.any_transmission = hits.any_transmission || !all_plain;
  LANCER_ON_TARGET(face_rays(hits.normal, hits.entering, hits.facing, count));
  LANCER_ON_TARGET(paint(paints.data(),
                         {&hits.own, &hits.diffuse, &hits.specular, follow ? &hits.reflection : nullptr,
                          follow && hits.any_transmission ? &hits.transmission : nullptr},
                         count));
  if (all_plain) return;
  for (std::size_t i = 0; i < count; ++i) {
    if (hits.there[i] != 0 && !looks.primitives[hits.primitive[i]].is_plain)
      find_surface(tracing, hits, i, follow, stats);
  }
}

}  // namespace lancer::tracer
