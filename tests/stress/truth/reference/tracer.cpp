#include "tracer.hpp"

#include <algorithm>
#include <tuple>

namespace lancer::reference {
namespace {

/// A distance of no more than this part of the coordinates is none at all.
const Real k_nothing("1e-38");

bool heads_into(const Contact& contact, const Vector& direction) {
  const Real outward = dot(contact.normal, direction);
  return contact.inside ? outward > 0 : outward < 0;
}

}  // namespace

Tracer::Tracer(const scene::Scene& scene, Tolerance tolerance) : scene_(scene), tolerance_(tolerance) {
  for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) bodies_.emplace_back(scene, i);
}

const scene::Material& Tracer::material(std::size_t body) const {
  return scene_.materials[scene_.shapes[bodies_[body].shape()].material];
}

Real Tracer::index(const std::vector<std::size_t>& open) const {
  return open.empty() ? scene_.settings.ior : material(open.back()).ior;
}

Ray Tracer::from_eye(const Vector& origin, const Vector& direction) const {
  Ray ray{origin, direction, {}, {}};
  struct Way {
    std::size_t body;
    Real out;
    bool endless;
  };
  std::vector<Way> ways;
  std::vector<Root> roots;
  const Real size = largest(origin);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].encloses()) continue;
    const Real side = bodies_[i].side(origin);
    bodies_[i].roots(origin, direction, roots);
    bool touched = false;
    Way way{i, 0, true};
    for (const Root& root : roots) {
      if (abs(root.t) * length(direction) <= k_nothing * size)
        touched = true;
      else if (!root.entering && root.t > 0 && (way.endless || root.t < way.out))
        way = {i, root.t, false};
    }
    // From a surface itself: inside if it looks in.
    if (touched) {
      bool in = false;
      for (const Root& root : roots) {
        if (abs(root.t) * length(direction) <= k_nothing * size) in = in || root.entering;
      }
      if (!in) continue;
    } else if (side > 0) {
      continue;
    }
    ways.push_back(way);
  }
  std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) {
    if (a.endless || b.endless)
      return a.endless && !b.endless ? true : a.endless == b.endless && a.body < b.body;
    return a.out > b.out;
  });
  // Coincident ways out: the solid that was added first is the outermost.
  const Real reach = tolerance_.coincident * size;
  for (auto first = ways.begin(); first != ways.end();) {
    auto last = first + 1;
    const auto one = [&](const Way& a, const Way& b) {
      if (a.endless || b.endless) return a.endless && b.endless;
      return (a.out - b.out) * length(direction) <=
             reach + Real(tolerance_.coincident) * a.out * length(direction);
    };
    while (last != ways.end() && one(*(last - 1), *last)) ++last;
    std::sort(first, last, [](const Way& a, const Way& b) { return a.body < b.body; });
    first = last;
  }
  for (const Way& way : ways) ray.open.push_back(way.body);
  return ray;
}

void Tracer::crossings(const Ray& ray, std::vector<Crossing>& out) const {
  out.clear();
  std::vector<Root> roots;
  std::vector<const Contact*> touching;
  const Real nothing = k_nothing * largest(ray.origin) / length(ray.direction);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    touching.clear();
    for (const Contact& c : ray.contacts) {
      if (c.body != i) continue;
      touching.push_back(&c);
      if (!c.left && heads_into(c, ray.direction)) out.push_back({i, {0, !c.inside, c.face}, true});
    }
    bodies_[i].roots(ray.origin, ray.direction, roots);
    if (bodies_[i].is_convex() && !touching.empty()) {
      // All is known but where a ray that runs within leaves.
      const Contact& c = *touching.front();
      const bool inward = dot(c.normal, ray.direction) < 0;
      if (inward && roots.size() == 2) out.push_back({i, roots[1], false});
      continue;
    }
    for (const Root& root : roots) {
      const bool known = std::any_of(touching.begin(), touching.end(),
                                     [&](const Contact* c) { return c->face == root.face; });
      if (!known && root.t > nothing) out.push_back({i, root, false});
    }
  }
}

bool Tracer::met_at_start(const Ray& ray, Meeting& out) const {
  const Contact* first = nullptr;
  for (const Contact& c : ray.contacts) {
    if (c.left || !heads_into(c, ray.direction)) continue;
    if (!first || std::tie(c.body, c.face) < std::tie(first->body, first->face)) first = &c;
  }
  if (!first) return false;
  out = {first->body, 0, !first->inside, first->face, ray.origin, first->normal, ray.contacts};
  for (Contact& c : out.contacts) c.left = false;
  return true;
}

bool Tracer::closest(const Ray& ray, Meeting& out) const {
  if (met_at_start(ray, out)) return true;
  std::vector<Crossing> found;
  crossings(ray, found);
  if (found.empty()) return false;
  const auto nearest = std::min_element(
      found.begin(), found.end(), [](const Crossing& a, const Crossing& b) { return a.root.t < b.root.t; });
  const Vector p = ray.origin + ray.direction * nearest->root.t;
  const Real reach = Real(tolerance_.coincident) * largest(p);
  std::vector<Contact> together;
  const Crossing* first = nullptr;
  for (const Crossing& c : found) {
    const Vector at = ray.origin + ray.direction * c.root.t;
    const Vector normal = bodies_[c.body].normal(at, c.root.face);
    // How far the surfaces are apart, at right angles to them.
    if ((c.root.t - nearest->root.t) * abs(dot(normal, ray.direction)) > reach) continue;
    together.push_back({c.body, c.root.face, !c.root.entering, false, normal});
    if (!first || std::tie(c.body, c.root.face) < std::tie(first->body, first->root.face)) first = &c;
  }
  const Vector at = ray.origin + ray.direction * first->root.t;
  out = {first->body,
         first->root.t,
         first->root.entering,
         first->root.face,
         at,
         bodies_[first->body].normal(at, first->root.face),
         together};
  return true;
}

std::vector<std::size_t> Tracer::crossed(const Ray& ray, const Meeting& met) const {
  std::vector<std::size_t> open = ray.open;
  if (!bodies_[met.body].encloses()) return open;
  const auto at = std::find(open.begin(), open.end(), met.body);
  if (met.entering && at == open.end()) open.push_back(met.body);
  if (!met.entering && at != open.end()) open.erase(at);
  return open;
}

Ray Tracer::onwards(const Meeting& met, const Vector& direction, const std::vector<std::size_t>& open) const {
  Ray ray{met.point, direction, met.contacts, open};
  const bool inside = dot(met.normal, direction) < 0;
  const bool back = inside != met.entering;
  const Vector away = inside ? -met.normal : met.normal;
  for (Contact& c : ray.contacts) {
    const bool same = c.body == met.body && c.face == met.face;
    // Where facets of one mesh meet, they are crossed together.
    if (same || (c.body == met.body && !back && (dot(c.normal, direction) < 0) == inside)) c.inside = inside;
    // A facet that begins here and lies behind the surface is touched at its rim only.
    c.left = same || (back && bodies_[c.body].ends_behind(c.face, met.point, away));
  }
  return ray;
}

}  // namespace lancer::reference
