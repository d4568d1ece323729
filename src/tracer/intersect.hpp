#pragma once
// What a ray meets. Coincident surfaces are told apart from near ones by the error bounds of their distances,
// and met in the order in which their objects were added; the answer never depends on the order of the
// search.

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

/// A ray from the hit's point: what it starts on, and on which side of each it starts, follows from its
/// direction for the surface that it leaves, from the ray that came for the others. Its open solids are left
/// empty.
inline Ray ray_from(const World& world, const Hit& hit, Vec3 direction);

// --- Details
// ---------------------------------------------------------------------------------------------------------

/// On which side of each of its contacts the ray from the hit starts, and which it leaves.
void set_sides(const World& world, const Hit& hit, Ray& ray);

/// As ray_from(), into a ray that starts elsewhere.
inline void restart(const World& world, const Hit& hit, Vec3 direction, Ray& ray) {
  ray.origin = hit.point;
  ray.direction = direction;
  ray.origin_error = hit.point_error;
  ray.contacts = hit.contacts;
  if (hit.contacts.size() == 1 && hit.contacts[0].primitive == hit.primitive) {
    Contact& surface = ray.contacts[0];
    surface.inside = surface.in_shape = dot(hit.normal, direction) < 0;
    surface.left = true;
  } else {
    set_sides(world, hit, ray);
  }
}

Ray ray_from(const World& world, const Hit& hit, Vec3 direction) {
  Ray ray;
  restart(world, hit, direction, ray);
  return ray;
}

}  // namespace lancer::tracer
