#pragma once
// Every surface that a ray crosses on a part of its way: what shadows ask for.

#include <algorithm>
#include <cstdint>

#include "tracer/candidates.hpp"
#include "tracer/contacts.hpp"
#include "tracer/intersect.hpp"
#include "tracer/options.hpp"
#include "tracer/world.hpp"

namespace lancer::tracer {

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

// --- Details
// ---------------------------------------------------------------------------------------------------------

/// Is the crossing before the ray has gone `distance`, whatever the surface's own rounding?
inline bool is_before(const World& world, const Ray& ray, std::uint32_t primitive, const Root& root,
                      double distance) {
  if (root.t + root.error < distance) return true;
  if (root.t - root.error >= distance) return false;
  const Root exactly = land(world, primitive, ray.origin, ray.direction, root).root;
  return exactly.t + exactly.error < distance;
}

/// One ray's crossings, found and told.
template <class Visit>
class CrossingSearch {
 public:
  CrossingSearch(const World& world, const Ray& ray, double distance, Visit& visit)
      : world_(world),
        ray_(ray),
        start_(ray),
        distance_(distance),
        probe_(ray, world.has_facets()),
        visit_(visit) {}

  bool run(Stats& stats) {
    if (!ray_.contacts.empty() && tell_start()) return true;
    const bool over = tell_others(stats);
    stats.shape_tests += tests_;
    return over;
  }

 private:
  /// What the ray crosses of the surfaces that it starts on.
  bool tell_start() {
    for (const Contact& contact : ray_.contacts) {
      const Kind kind = world_.primitives[contact.primitive].kind;
      const AtStart start = at_start(contact, kind, ray_.direction);
      if (start == AtStart::nothing) continue;
      const bool enters = start == AtStart::meets && !contact.inside;
      if (start == AtStart::meets) {
        const Root root{0, ray_.origin_error, enters, false, contact.face};
        const bool counts = root.error < distance_;
        if (counts && visit_(Crossing{contact.primitive, contact.shape, root})) return true;
      }
      if (is_convex_solid(kind) && (enters || start == AtStart::passes_through)) {
        const Root root = exit(world_, contact.primitive, ray_.origin, ray_.direction);
        const bool counts = is_before(world_, ray_, contact.primitive, root, distance_);
        if (counts && visit_(Crossing{contact.primitive, contact.shape, root})) return true;
      }
    }
    return false;
  }

  bool tell_others(Stats& stats) {
    for (const std::uint32_t primitive : world_.unbounded) {
      if (test(primitive)) return true;
    }
    if (world_.listed_spheres.each(probe_, [&](std::uint32_t primitive) { return test(primitive); })) {
      return true;
    }
    const auto test_item = [&](std::uint32_t item) { return test(world_.bounded[item]); };
    return world_.tree.traverse(probe_, distance_, stats.node_visits, test_item, Order::any);
  }

  bool test(std::uint32_t primitive) {
    if (start_.is_on(primitive)) return false;
    ++tests_;
    const Primitive& p = world_.primitives[primitive];
    return with_roots(world_, p, probe_, [&](const Roots& found) {
      if (found.count == 0) return false;
      return tell(primitive, start_.is_rounded() ? ahead(world_, ray_, primitive, found) : found);
    });
  }

  bool tell(std::uint32_t primitive, const Roots& found) {
    const auto counts = [&](int i) {
      return i < found.count && (found.root[i].t > 0 || (i == 0 && found.at_start));
    };
    return (counts(0) && tell(primitive, found.root[0])) || (counts(1) && tell(primitive, found.root[1]));
  }

  bool tell(std::uint32_t primitive, const Root& found) {
    const Interval own = own_interval(world_, primitive, probe_);
    if (!(own.enter <= own.leave) || !(own.enter <= distance_)) return false;
    const Root root = within(found, own);
    if (!is_before(world_, ray_, primitive, root, distance_)) return false;
    if (is_echo(world_, ray_, primitive, root)) return false;
    return visit_(Crossing{primitive, world_.primitives[primitive].shape, root});
  }

  const World& world_;
  const Ray& ray_;
  const Start start_;
  const double distance_;
  const Probe probe_;
  Visit& visit_;
  std::uint64_t tests_ = 0;
};

template <class Visit>
bool crossings(const World& world, const Ray& ray, double distance, Stats& stats, Visit visit) {
  return CrossingSearch<Visit>(world, ray, distance, visit).run(stats);
}

}  // namespace lancer::tracer
