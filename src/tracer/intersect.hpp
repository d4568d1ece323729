#pragma once
// What a ray meets. Coincident surfaces are told apart from near ones by the error bounds of their distances,
// and met in the order in which their objects were added; the answer never depends on the order of the
// search.

#include <algorithm>
#include <cstdint>

#include "tracer/options.hpp"
#include "tracer/world.hpp"

namespace lancer::tracer {

/// The next surface on a ray's way.
struct Hit {
  std::uint32_t primitive = 0;
  std::uint32_t shape = 0;
  Root root;
  Vec3 point;              // on the primitive
  double point_error = 0;  // how far rounding may have moved it, along the ray too
  Vec3 normal;             // outward, unit length; the facet's own where normals are smooth
  Contacts contacts;       // every surface known to pass through the point, this one included
};

/// The first surface along the ray; none: false.
bool closest(const World& world, const Ray& ray, Stats& stats, Hit& hit);

/// A surface between the start of a ray and a distance.
struct Crossing {
  std::uint32_t primitive = 0;
  std::uint32_t shape = 0;
  Root root;
};

/// Calls visit(crossing) for each surface that the ray crosses before it has gone `distance` (infinite: at
/// all), in no particular order, until it returns true (then so does this). Facets of one mesh that meet at
/// the crossing are told one by one.
template <class Visit>
bool crossings(const World& world, const Ray& ray, double distance, Stats& stats, Visit visit);

/// A ray from the hit's point: what it starts on, and on which side of each it starts, follows from its
/// direction for the surface that it leaves, from the ray that came for the others. Its open solids are left
/// empty.
Ray ray_from(const World& world, const Hit& hit, Vec3 direction);

// --- Details
// ---------------------------------------------------------------------------------------------------------

/// What a ray does at a surface that it starts on.
enum class AtStart : std::uint8_t { nothing, meets, passes_through };
/// meets: crosses it at once; passes_through: runs inside a convex solid up to its far side.
AtStart at_start(const Contact& contact, Kind kind, Vec3 direction);

inline const Contact* find_contact(const Contacts& contacts, std::uint32_t primitive) {
  for (const Contact& contact : contacts) {
    if (contact.primitive == primitive) return &contact;
  }
  return nullptr;
}

/// Is the ray inside the shape, as far as it knows?
bool starts_inside(const Ray& ray, std::uint32_t shape);

/// The roots that count for the ray. The start that rounding moved may lie on the wrong side of a convex
/// solid that is next to it: what the ray knows tells whether it is still to go in there, or out.
Roots roots_ahead(const World& world, const Ray& ray, std::uint32_t primitive, const Probe& probe);

/// Next to its start a ray that leaves a mesh can only meet those of its facets that fit the side that it is
/// on, and none that lies behind the surface it leaves: a neighbour across an edge, missed or met by rounding
/// alone, is not crossed a second time.
bool is_echo(const World& world, const Ray& ray, std::uint32_t primitive, const Root& root);

/// Is the crossing before the ray has gone `distance`, whatever the surface's own rounding?
bool is_before(const World& world, const Ray& ray, std::uint32_t primitive, const Root& root,
               double distance);

/// The part of the ray within the primitive's own bounds. A root counts only where this is not empty, which
/// makes the answer the same for every tree.
inline Interval own_interval(const World& world, std::uint32_t primitive, const Probe& probe) {
  if (world.primitives[primitive].kind == Kind::plane) return {0, k_infinity};
  return interval(bounds(world, primitive), probe);
}

/// What is known of a root, and of where the primitive as a whole lies on the ray.
inline Root within(Root root, const Interval& own) {
  const double enter = own.enter * (1 - 2 * gamma(3));  // as in interval(), for the near side
  if (root.t < enter || root.t > own.leave) root.t = root.t < enter ? enter : own.leave;
  root.error = std::min(root.error, own.leave - enter);
  return root;
}

template <class Visit>
bool crossings(const World& world, const Ray& ray, double distance, Stats& stats, Visit visit) {
  const auto before_end = [&](std::uint32_t primitive, const Root& root) {
    return is_before(world, ray, primitive, root, distance);
  };
  for (const Contact& contact : ray.contacts) {
    const Kind kind = world.primitives[contact.primitive].kind;
    const AtStart start = at_start(contact, kind, ray.direction);
    if (start == AtStart::nothing) continue;
    const bool enters = start == AtStart::meets && !contact.inside;
    if (start == AtStart::meets) {
      const Root root{0, ray.origin_error, enters, false, contact.face};
      const bool counts = root.error < distance;
      if (counts && visit(Crossing{contact.primitive, contact.shape, root})) return true;
    }
    if (is_convex_solid(kind) && (enters || start == AtStart::passes_through)) {
      const Root root = exit(world, contact.primitive, ray.origin, ray.direction);
      const bool counts = before_end(contact.primitive, root);
      if (counts && visit(Crossing{contact.primitive, contact.shape, root})) return true;
    }
  }
  const Probe probe(ray);
  const auto test = [&](std::uint32_t primitive) {
    if (find_contact(ray.contacts, primitive)) return false;
    ++stats.shape_tests;
    const Roots found = roots_ahead(world, ray, primitive, probe);
    for (int i = 0; i < found.count; ++i) {
      if (!(found.root[i].t > 0) && !found.at_start) continue;
      const Interval own = own_interval(world, primitive, probe);
      if (!(own.enter <= own.leave) || !(own.enter <= distance)) return false;
      const Root root = within(found.root[i], own);
      if (!before_end(primitive, root) || is_echo(world, ray, primitive, root)) continue;
      if (visit(Crossing{primitive, world.primitives[primitive].shape, root})) return true;
    }
    return false;
  };
  for (const std::uint32_t primitive : world.unbounded) {
    if (test(primitive)) return true;
  }
  const auto test_item = [&](std::uint32_t item) { return test(world.bounded[item]); };
  return world.tree.traverse(probe, distance, stats.node_visits, test_item, Order::any);
}

}  // namespace lancer::tracer
