#pragma once
// What a ray does at the surfaces that it starts on, and next to them. Decided from the side that it starts
// on and from its direction, never from the size of a computed distance.

#include <cstdint>

#include "tracer/intersect.hpp"
#include "tracer/world.hpp"

namespace lancer::tracer {

/// What a ray does at a surface that it starts on.
enum class AtStart : std::uint8_t { nothing, meets, passes_through };
/// meets: crosses it at once; passes_through: runs inside a convex solid up to its far side.
inline AtStart at_start(const Contact& contact, Kind kind, Vec3 direction) {
  const double outward = dot(contact.normal, direction);
  if (!contact.left && (contact.inside ? outward > 0 : outward < 0)) return AtStart::meets;
  return is_convex_solid(kind) && outward < 0 ? AtStart::passes_through : AtStart::nothing;
}

inline const Contact* find_contact(const Contacts& contacts, std::uint32_t primitive) {
  for (const Contact& contact : contacts) {
    if (contact.primitive == primitive) return &contact;
  }
  return nullptr;
}

/// The primitives at the start of a ray, which a search asks for again and again: nearly always none or one.
class Start {
 public:
  explicit Start(const Ray& ray)
      : contacts_(ray.contacts),
        first_(contacts_.empty() ? k_none : contacts_[0].primitive),
        several_(contacts_.size() > 1),
        rounded_(ray.origin_error > 0) {}

  /// May it lie beside where it should be?
  bool is_rounded() const { return rounded_; }

  bool is_on(std::uint32_t primitive) const {
    return primitive == first_ || (several_ && find_contact(contacts_, primitive) != nullptr);
  }

 private:
  static constexpr std::uint32_t k_none = ~std::uint32_t{0};

  const Contacts& contacts_;
  std::uint32_t first_;
  bool several_;
  bool rounded_;
};

/// Is the ray inside the shape, as far as it knows?
bool starts_inside(const Ray& ray, std::uint32_t shape);

/// The roots, one or two, that count for the ray. The start that rounding moved may lie on the wrong side of
/// a solid that is next to it: what the ray knows tells whether it is still to go in there, or out.
Roots ahead(const World& world, const Ray& ray, std::uint32_t primitive, const Roots& found);

/// As is_echo(), of a facet, for a ray that starts on something.
bool is_echo_of_start(const World& world, const Ray& ray, std::uint32_t primitive, const Root& root);

/// Next to its start a ray that leaves a mesh can only meet those of its facets that fit the side that it is
/// on, and none that lies behind the surface it leaves: a neighbour across an edge, missed or met by rounding
/// alone, is not crossed a second time.
inline bool is_echo(const World& world, const Ray& ray, std::uint32_t primitive, const Root& root) {
  return !ray.contacts.empty() && world.primitives[primitive].kind == Kind::facet &&
         is_echo_of_start(world, ray, primitive, root);
}

/// The first of the surfaces that the ray crosses right where it starts; of a mesh, one that fits the ray's
/// side of it. None: null.
const Contact* met_at_start(const World& world, const Ray& ray);

}  // namespace lancer::tracer
