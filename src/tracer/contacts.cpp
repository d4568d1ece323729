#include "tracer/contacts.hpp"

#include <algorithm>
#include <tuple>

namespace lancer::tracer {
namespace {

/// At an edge: does the facet of the contact lie behind the surface that a ray leaves to the side `away`?
/// Then the ray, although it runs behind the facet's plane, only touches its rim. A facet of another object
/// that lies in the surface is no such facet: a ray from its far side crosses it.
bool falls_away(const World& world, const Contact& contact, const Hit& hit, Vec3 away) {
  const Primitive primitive = world.primitives[contact.primitive];
  if (primitive.kind != Kind::facet) return false;
  const FacetPrimitive& f = world.facets[primitive.record];
  const double ahead = dot(away, (f.a - hit.point) + (f.b - hit.point) + (f.c - hit.point));
  if (contact.shape == hit.shape) return ahead <= 0;
  const double slack = 3 * hit.point_error + 32 * k_u * (max_abs(f.a) + max_abs(f.b) + max_abs(f.c));
  return ahead < -slack;
}

/// Does the facet lie behind the surface that the ray starts on, as far as rounding lets tell?
bool is_behind(const FacetPrimitive& facet, const Contact& contact, const Ray& ray) {
  const Vec3 away = contact.inside ? -contact.normal : contact.normal;
  const double highest = std::max(dot(away, facet.a - ray.origin),
                                  std::max(dot(away, facet.b - ray.origin), dot(away, facet.c - ray.origin)));
  return highest <= 4 * (ray.origin_error + facet.slack);
}

}  // namespace

bool starts_inside(const Ray& ray, std::uint32_t shape) {
  for (const Contact& contact : ray.contacts) {
    if (contact.shape == shape) return contact.in_shape;
  }
  return std::find(ray.open.begin(), ray.open.end(), shape) != ray.open.end();
}

Roots ahead(const World& world, const Ray& ray, std::uint32_t primitive, const Roots& found) {
  const Primitive& p = world.primitives[primitive];
  const auto is_at_start = [&](const Root& root) {
    const Vec3 n = normal(world, primitive, ray.origin + ray.direction * root.t, root.face);
    return (std::fabs(root.t) - root.error) * std::fabs(dot(n, ray.direction)) <= ray.origin_error;
  };
  Roots counted = found;
  if (p.kind == Kind::facet && encloses(*world.scene, p.shape)) {
    if (!is_at_start(found.root[0])) return found;
    if (found.root[0].entering == starts_inside(ray, p.shape)) return {};
    counted.at_start = true;
  } else if (is_convex_solid(p.kind) && found.count == 2) {
    const Root &in = found.root[0], &out = found.root[1];
    if (starts_inside(ray, p.shape)) {
      // Having gone in, by a side that it all but lies in perhaps, it can only go out.
      counted = {1, {out, {}}, false, !(out.t > 0) && is_at_start(out)};
    } else if (!(in.t > 0) && out.t > 0) {
      if (is_at_start(out)) return {};
      counted.at_start = is_at_start(in);
    }
  }
  return counted;
}

bool is_echo_of_start(const World& world, const Ray& ray, std::uint32_t primitive, const Root& root) {
  const std::uint32_t shape = world.primitives[primitive].shape;
  const FacetPrimitive& facet = world.facets[world.primitives[primitive].record];
  for (const Contact& contact : ray.contacts) {
    if (contact.shape != shape) continue;
    const bool fits = contact.in_shape != root.entering || !encloses(*world.scene, shape);
    if (fits && !is_behind(facet, contact, ray)) continue;
    // Until then the ray has not measurably left the facet that it starts on.
    const double rise = std::fabs(dot(contact.normal, ray.direction));
    if ((root.t - root.error) * rise > ray.origin_error) continue;
    const Root exactly = land(world, primitive, ray.origin, ray.direction, root).root;
    if ((exactly.t - exactly.error) * rise <= ray.origin_error) return true;
  }
  return false;
}

const Contact* met_at_start(const World& world, const Ray& ray) {
  const Contact* best = nullptr;
  const auto rank = [](const Contact& c) {
    return std::make_tuple(c.shape, c.inside != c.in_shape, c.primitive);
  };
  for (const Contact& contact : ray.contacts) {
    if (contact.left) continue;
    const Kind kind = world.primitives[contact.primitive].kind;
    if (at_start(contact, kind, ray.direction) != AtStart::meets) continue;
    if (!best || rank(contact) < rank(*best)) best = &contact;
  }
  return best;
}

void set_sides(const World& world, const Hit& hit, Ray& ray) {
  const bool inside = dot(hit.normal, ray.direction) < 0;
  const bool turns_back = inside != hit.root.entering;
  const Vec3 away = inside ? -hit.normal : hit.normal;
  for (Contact& contact : ray.contacts) {
    if (contact.shape == hit.shape) {
      // The other facets of a mesh that the ray crosses here in the same way are crossed with this one, and
      // so are those that are joined.
      const bool goes_behind = dot(contact.normal, ray.direction) < 0;
      if (contact.primitive == hit.primitive || (!turns_back && goes_behind == inside)) {
        contact.inside = inside;
      } else if (contact.joined) {
        contact.inside = turns_back ? inside : goes_behind;
      }
      contact.in_shape = inside;
    }
    if (contact.primitive == hit.primitive || (turns_back && falls_away(world, contact, hit, away))) {
      contact.left = true;
    }
  }
}

}  // namespace lancer::tracer
