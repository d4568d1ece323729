#include "tracer/intersect.hpp"

#include <algorithm>
#include <tuple>

#include "tracer/candidates.hpp"

namespace lancer::tracer {
namespace {

/// A surface that the ray meets, or a facet that it passes by its rim.
struct Met {
  std::uint32_t primitive = 0;
  Root root;
  Vec3 normal;
  bool passed = false;
};
using MetList = SmallList<Met, 8>;

/// A closed mesh whose edge or corner the ray touches without a crossing is met there all the same, by a
/// facet that takes the ray in and one that takes it out again; where only one of the two is, as at the start
/// of an edge that the ray runs along, it runs beside the mesh. The other facets stay passed.
void add_touched(const World& world, const Ray& ray, const Probe& probe, MetList& passed,
                 Candidates& candidates) {
  const auto is_at_rim = [&](std::uint32_t primitive, const Root& root) {
    return root.rim && root.t > 0 && encloses(*world.scene, world.primitives[primitive].shape);
  };
  const auto meet = [&](const Root& a, const Root& b) { return std::fabs(a.t - b.t) <= a.error + b.error; };
  const auto is_same = [&](std::uint32_t a, std::uint32_t b) {
    return world.primitives[a].shape == world.primitives[b].shape;
  };
  MetList touched;
  for (const Met& m : passed) {
    if (!is_at_rim(m.primitive, m.root) || m.root.t - m.root.error > candidates.limit()) continue;
    const bool crossed = std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& c) {
      return is_at_rim(c.primitive, c.root) && is_same(c.primitive, m.primitive) && meet(c.root, m.root);
    });
    if (!crossed && !is_echo(world, ray, m.primitive, m.root)) touched.push_back(m);
  }
  std::sort(touched.begin(), touched.end(),
            [](const Met& a, const Met& b) { return a.primitive < b.primitive; });
  for (const Met& m : touched) {
    const auto first_there = [&](bool entering) {
      return std::find_if(touched.begin(), touched.end(), [&](const Met& o) {
        return is_same(o.primitive, m.primitive) && meet(o.root, m.root) && o.root.entering == entering;
      });
    };
    const bool goes_out_again = first_there(!m.root.entering) != touched.end();
    if (!goes_out_again || first_there(m.root.entering)->primitive != m.primitive) continue;
    const Interval own = own_interval(world, m.primitive, probe);
    Root root = m.root;
    root.rim = false;
    if (own.enter <= own.leave) candidates.add(m.primitive, root, own);
  }
}

/// The surfaces that may be the first; to `passed` come facets that the ray misses by rounding alone.
Candidates search(const World& world, const Ray& ray, Stats& stats, MetList& passed) {
  Candidates candidates;
  for (const Contact& contact : ray.contacts) {
    if (at_start(contact, world.primitives[contact.primitive].kind, ray.direction) ==
        AtStart::passes_through) {
      candidates.add(contact.primitive, exit(world, contact.primitive, ray.origin, ray.direction),
                     k_anywhere);
    }
  }
  const Probe probe(ray);
  const auto test = [&](std::uint32_t primitive) {
    if (find_contact(ray.contacts, primitive)) return false;
    ++stats.shape_tests;
    const Roots found = roots_ahead(world, ray, primitive, probe);
    if (found.passes) passed.push_back({primitive, found.root[0], {}, true});
    for (int i = 0; i < found.count; ++i) {
      if (!(found.root[i].t > 0) && !found.at_start) continue;
      const Root& root = found.root[i];
      if (!root.loose && root.t - root.error > candidates.limit()) break;
      const Interval own = own_interval(world, primitive, probe);
      if (!(own.enter <= own.leave)) break;
      if (is_echo(world, ray, primitive, root)) continue;
      candidates.add(primitive, root, own);
      break;
    }
    return false;
  };
  for (const std::uint32_t primitive : world.unbounded) test(primitive);
  world.tree.traverse(probe, candidates.limit(), stats.node_visits,
                      [&](std::uint32_t item) { return test(world.bounded[item]); });
  if (!passed.empty()) add_touched(world, ray, probe, passed, candidates);
  candidates.tidy();
  // Of those farther away the search finds some and leaves out others, as the tree has it.
  std::size_t kept = 0;
  for (const Met& m : passed) {
    const Interval own = own_interval(world, m.primitive, probe);
    const bool is_met = std::any_of(candidates.begin(), candidates.end(),
                                    [&](const Candidate& c) { return c.primitive == m.primitive; });
    if (!is_met && own.enter <= own.leave && own.enter <= candidates.limit()) passed[kept++] = m;
  }
  passed.shrink(kept);
  return candidates;
}

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
MetList surfaces_at(const World& world, const Ray& ray, const Candidates& candidates, const MetList& passed,
                    const Hit& hit) {
  MetList met;
  for (const Candidate& c : candidates) {
    met.push_back({c.primitive, c.root, c.primitive == hit.primitive ? hit.normal : c.normal, false});
  }
  for (const Met& m : passed) {
    const FacetPrimitive& facet = world.facets[world.primitives[m.primitive].record];
    const double tolerance =
        8 * k_u * (max_abs(hit.point) + sum_abs(hit.point - ray.origin)) + 4 * facet.slack;
    if (touches(facet, hit.point, tolerance)) met.push_back({m.primitive, m.root, facet.normal, true});
  }
  return met;
}

void collect_contacts(const World& world, const Ray& ray, const Candidates& candidates, const MetList& met,
                      Hit& hit) {
  for (const Met& m : met) {
    const Primitive& primitive = world.primitives[m.primitive];
    const bool mixed = primitive.kind == Kind::facet && is_mixed(world, met, primitive.shape);
    const bool in_shape = mixed ? starts_inside(ray, primitive.shape) : !m.root.entering;
    const bool joined = primitive.kind == Kind::facet && encloses(*world.scene, primitive.shape) &&
                        ((m.passed && m.root.rim) || way_in(world, candidates, primitive.shape) != 0);
    hit.contacts.push_back(
        {m.primitive, primitive.shape, m.root.face, !m.root.entering, in_shape, false, m.normal, joined});
  }
  // The order in which the search found them must not show.
  std::sort(hit.contacts.begin(), hit.contacts.end(),
            [](const Contact& a, const Contact& b) { return a.primitive < b.primitive; });
  // A ray that has not measurably moved still stands where it started.
  if (hit.root.t > hit.root.error + ray.origin_error) return;
  for (Contact contact : ray.contacts) {
    if (find_contact(hit.contacts, contact.primitive)) continue;
    contact.left = false;
    hit.contacts.push_back(contact);
  }
}

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

/// The first of the surfaces that the ray crosses right where it starts; of a mesh, one that fits the ray's
/// side of it.
const Contact* met_at_start(const World& world, const Ray& ray) {
  const Contact* best = nullptr;
  const auto rank = [](const Contact& c) {
    return std::make_tuple(c.shape, c.inside != c.in_shape, c.primitive);
  };
  for (const Contact& contact : ray.contacts) {
    const Kind kind = world.primitives[contact.primitive].kind;
    if (at_start(contact, kind, ray.direction) != AtStart::meets) continue;
    if (!best || rank(contact) < rank(*best)) best = &contact;
  }
  return best;
}

}  // namespace

AtStart at_start(const Contact& contact, Kind kind, Vec3 direction) {
  const double outward = dot(contact.normal, direction);
  if (!contact.left && (contact.inside ? outward > 0 : outward < 0)) return AtStart::meets;
  return is_convex_solid(kind) && outward < 0 ? AtStart::passes_through : AtStart::nothing;
}

bool starts_inside(const Ray& ray, std::uint32_t shape) {
  for (const Contact& contact : ray.contacts) {
    if (contact.shape == shape) return contact.in_shape;
  }
  return std::find(ray.open.begin(), ray.open.end(), shape) != ray.open.end();
}

Roots roots_ahead(const World& world, const Ray& ray, std::uint32_t primitive, const Probe& probe) {
  Roots found = roots(world, primitive, probe);
  if (found.count == 0 || ray.origin_error == 0) return found;
  const Primitive p = world.primitives[primitive];
  const auto is_at_start = [&](const Root& root) {
    const Vec3 n = normal(world, primitive, ray.origin + ray.direction * root.t, root.face);
    return (std::fabs(root.t) - root.error) * std::fabs(dot(n, ray.direction)) <= ray.origin_error;
  };
  if (p.kind == Kind::facet && encloses(*world.scene, p.shape)) {
    if (!is_at_start(found.root[0])) return found;
    if (found.root[0].entering == starts_inside(ray, p.shape)) return {};
    found.at_start = true;
  } else if (is_convex_solid(p.kind) && found.count == 2) {
    const Root in = found.root[0], out = found.root[1];
    if (starts_inside(ray, p.shape)) {
      // Having gone in, by a side that it all but lies in perhaps, it can only go out.
      found = {1, {out, {}}, false, !(out.t > 0) && is_at_start(out)};
    } else if (!(in.t > 0) && out.t > 0) {
      if (is_at_start(out)) return {};
      found.at_start = is_at_start(in);
    }
  }
  return found;
}

bool is_echo(const World& world, const Ray& ray, std::uint32_t primitive, const Root& root) {
  if (world.primitives[primitive].kind != Kind::facet) return false;
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

bool is_before(const World& world, const Ray& ray, std::uint32_t primitive, const Root& root,
               double distance) {
  if (root.t + root.error < distance) return true;
  if (root.t - root.error >= distance) return false;
  const Root exactly = land(world, primitive, ray.origin, ray.direction, root).root;
  return exactly.t + exactly.error < distance;
}

bool closest(const World& world, const Ray& ray, Stats& stats, Hit& hit) {
  hit.contacts.clear();
  if (const Contact* const contact = met_at_start(world, ray)) {
    hit.primitive = contact->primitive;
    hit.shape = contact->shape;
    hit.root = {0, ray.origin_error, !contact->inside, false, contact->face};
    hit.point = ray.origin;
    hit.point_error = ray.origin_error;
    hit.normal = contact->normal;
    hit.contacts = ray.contacts;
    for (Contact& c : hit.contacts) c.left = false;
    return true;
  }
  MetList passed;
  Candidates candidates = search(world, ray, stats, passed);
  if (candidates.size() > 1) candidates = settled(world, ray, candidates);
  if (candidates.empty()) return false;
  const Candidate& first = first_met(world, ray, candidates);
  const Landing landing = land(world, first.primitive, ray.origin, ray.direction, first.root);
  hit.primitive = first.primitive;
  hit.shape = world.primitives[first.primitive].shape;
  hit.root = within(landing.root, first.own);
  hit.point = landing.point;
  hit.normal = landing.normal;
  // As the first, it is met no later than where any of the others must have been.
  if (hit.root.t > candidates.limit()) {
    hit.root.t = candidates.limit();
    hit.point = project(world, hit.primitive, ray.origin + ray.direction * hit.root.t, hit.root.face);
    hit.normal = normal(world, hit.primitive, hit.point, hit.root.face);
  }
  const double since = hit.root.t - std::max(first.earliest, 0.0);
  hit.root.error = std::min(hit.root.error, std::max(since, candidates.limit() - hit.root.t));
  hit.point_error = hit.root.error + 4 * k_u * max_abs(hit.point);
  collect_contacts(world, ray, candidates, surfaces_at(world, ray, candidates, passed, hit), hit);
  return true;
}

Ray ray_from(const World& world, const Hit& hit, Vec3 direction) {
  Ray ray{hit.point, direction, hit.point_error, hit.contacts, {}};
  const bool inside = dot(hit.normal, direction) < 0;
  const bool turns_back = inside != hit.root.entering;
  const Vec3 away = inside ? -hit.normal : hit.normal;
  for (Contact& contact : ray.contacts) {
    if (contact.shape == hit.shape) {
      // The other facets of a mesh that the ray crosses here in the same way are crossed with this one, and
      // so are those that are joined.
      const bool goes_behind = dot(contact.normal, direction) < 0;
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
  return ray;
}

}  // namespace lancer::tracer
