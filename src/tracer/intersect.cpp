#include "tracer/intersect.hpp"

#include <algorithm>

#include "tracer/contacts.hpp"
#include "tracer/search.hpp"

namespace lancer::tracer {
namespace {

/// A surface that passes through the hit, or a facet that ends there but for rounding.
struct Met {
  std::uint32_t primitive = 0;
  Root root;
  Vec3 normal;
  bool passed = false;
};
using MetList = SmallList<Met, 8>;

/// Where the quick bounds leave several, only what the surfaces' own rounding leaves open. Distances are
/// compared as what they are more than the least of them, so that their own last digits do not show.
Candidates settled(const World& world, const Ray& ray, const Candidates& quick) {
  SmallList<Landing, 8> landings;
  double least = k_infinity;
  for (const Candidate& c : quick) {
    landings.push_back(land(world, c.primitive, ray.origin, ray.direction, c.root));
    landings[landings.size() - 1].root.rim = c.root.rim;
    least = std::min(least, landings.back().root.t);
  }
  Candidates candidates;
  const Landing* landing = landings.begin();
  for (const Candidate& c : quick) {
    const double more = (landing->root.t - least) + landing->rest;
    const Span span = landing->span();
    const Interval own{c.own.enter - least, c.own.leave - least};
    candidates.add(c.primitive, landing->root, own, more - span.before, more + span.after, landing->normal);
    ++landing;
  }
  candidates.tidy();
  candidates.shift(least);
  return candidates;
}

/// Where facets of a closed mesh meet, those of them that the ray crosses take it in, > 0, out, < 0, or into
/// or out of nothing, 0, as where it touches an edge.
int way_in(const World& world, const Candidates& met, std::uint32_t shape) {
  int way = 0;
  for (const Candidate& m : met) {
    if (world.primitives[m.primitive].shape == shape) way += m.root.entering ? 1 : -1;
  }
  return way;
}

/// The candidate of the object that was added first. Where several facets of its mesh meet, the first of
/// those that fit the side of the mesh that the ray comes from.
const Candidate& first_met(const World& world, const Ray& ray, const Candidates& candidates) {
  const auto shape_of = [&](const Candidate& c) { return world.primitives[c.primitive].shape; };
  std::uint32_t shape = shape_of(*candidates.begin());
  for (const Candidate& c : candidates) shape = std::min(shape, shape_of(c));
  const int way = encloses(*world.scene, shape) ? way_in(world, candidates, shape) : 0;
  const bool inside = way != 0 ? way < 0 : starts_inside(ray, shape);
  const Candidate* best = nullptr;
  for (const Candidate& c : candidates) {
    if (shape_of(c) != shape) continue;
    const bool fits = c.root.entering != inside;
    const bool best_fits = best && best->root.entering != inside;
    if (!best || (fits && !best_fits) || (fits == best_fits && c.primitive < best->primitive)) best = &c;
  }
  return *best;
}

/// Do facets of the shape, a mesh, cross at the hit in both ways?
bool is_mixed(const World& world, const MetList& met, std::uint32_t shape) {
  bool enters = false, leaves = false;
  for (const Met& m : met) {
    if (world.primitives[m.primitive].shape == shape) (m.root.entering ? enters : leaves) = true;
  }
  return enters && leaves;
}

/// What passes through the hit: the candidates, and such facets as end there but for rounding, which in the
/// corner of two walls must stop a ray that goes on from one of them.
MetList surfaces_at(const World& world, const Ray& ray, const Candidates& candidates,
                    const PassedList& passed, const Hit& hit) {
  MetList met;
  for (const Candidate& c : candidates) {
    met.push_back({c.primitive, c.root, c.primitive == hit.primitive ? hit.normal : c.normal, false});
  }
  for (const Passed& m : passed) {
    const FacetPrimitive& facet = world.facets[world.primitives[m.primitive].record];
    const double tolerance =
        8 * k_u * (max_abs(hit.point) + sum_abs(hit.point - ray.origin)) + 4 * facet.slack;
    if (touches(facet, hit.point, tolerance)) met.push_back({m.primitive, m.root, facet.normal, true});
  }
  return met;
}

/// The contacts of a hit that several surfaces pass through, perhaps.
[[gnu::noinline]] void collect_contacts(const World& world, const Ray& ray, const Found& found, Hit& hit) {
  const MetList met = surfaces_at(world, ray, found.candidates, found.passed, hit);
  for (const Met& m : met) {
    const Primitive& primitive = world.primitives[m.primitive];
    const bool mixed = primitive.kind == Kind::facet && is_mixed(world, met, primitive.shape);
    const bool in_shape = mixed ? starts_inside(ray, primitive.shape) : !m.root.entering;
    const bool joined = primitive.kind == Kind::facet && encloses(*world.scene, primitive.shape) &&
                        ((m.passed && m.root.rim) || way_in(world, found.candidates, primitive.shape) != 0);
    hit.contacts.push_back(
        {m.primitive, primitive.shape, m.root.face, !m.root.entering, in_shape, false, joined, m.normal});
  }
  // The order in which the search found them must not show.
  std::sort(hit.contacts.begin(), hit.contacts.end(),
            [](const Contact& a, const Contact& b) { return a.primitive < b.primitive; });
}

/// A ray that has not measurably moved still stands where it started.
[[gnu::noinline]] void keep_contacts(const Ray& ray, Hit& hit) {
  for (Contact contact : ray.contacts) {
    if (find_contact(hit.contacts, contact.primitive)) continue;
    contact.left = false;
    hit.contacts.push_back(contact);
  }
}

void meet_at_start(const Ray& ray, const Contact& contact, Hit& hit) {
  hit.primitive = contact.primitive;
  hit.shape = contact.shape;
  hit.root = {0, ray.origin_error, !contact.inside, false, contact.face};
  hit.point = ray.origin;
  hit.point_error = ray.origin_error;
  hit.normal = contact.normal;
  hit.contacts = ray.contacts;
  for (Contact& c : hit.contacts) c.left = false;
}

/// The hit itself, without its contacts. As the first, it is met no later than where any of the others must
/// have been: at `limit`.
void land_on(const World& world, const Ray& ray, const Candidate& first, double limit, Hit& hit) {
  const Landing landing = land(world, first.primitive, ray.origin, ray.direction, first.root);
  hit.primitive = first.primitive;
  hit.shape = world.primitives[first.primitive].shape;
  hit.root = within(landing.root, first.own);
  hit.point = landing.point;
  hit.normal = landing.normal;
  if (hit.root.t > limit) {
    hit.root.t = limit;
    hit.point = project(world, hit.primitive, ray.origin + ray.direction * hit.root.t, hit.root.face);
    hit.normal = normal(world, hit.primitive, hit.point, hit.root.face);
  }
  const double since = hit.root.t - std::max(first.earliest, 0.0);
  hit.root.error = std::min(hit.root.error, std::max(since, limit - hit.root.t));
  hit.point_error = hit.root.error + 4 * k_u * max_abs(hit.point);
}

}  // namespace

bool closest(const World& world, const Ray& ray, Stats& stats, Hit& hit) {
  hit.contacts.clear();
  if (const Contact* const contact = met_at_start(world, ray)) {
    meet_at_start(ray, *contact, hit);
    return true;
  }
  Found found;
  search(world, ray, stats, found);
  Candidates& candidates = found.candidates;
  if (candidates.size() > 1) candidates = settled(world, ray, candidates);
  if (candidates.empty()) return false;
  if (candidates.size() == 1 && found.passed.empty()) {
    const Candidate& only = *candidates.begin();
    land_on(world, ray, only, candidates.limit(), hit);
    const bool inside = !only.root.entering;
    const bool joined =
        world.primitives[hit.primitive].kind == Kind::facet && encloses(*world.scene, hit.shape);
    hit.contacts.push_back(
        {hit.primitive, hit.shape, only.root.face, inside, inside, false, joined, hit.normal});
  } else {
    land_on(world, ray, first_met(world, ray, candidates), candidates.limit(), hit);
    collect_contacts(world, ray, found, hit);
  }
  if (!(hit.root.t > hit.root.error + ray.origin_error)) keep_contacts(ray, hit);
  return true;
}

}  // namespace lancer::tracer
