#pragma once
// Rays, and what they remember of the place where they start. A ray that leaves a surface knows which
// surfaces pass through its start and on which side of each it is; whether it meets them there is decided
// from that, never from the size of a computed distance. So no epsilon is needed, at any scale.

#include <cstdint>
#include <utility>

#include "base/vec.hpp"
#include "tracer/small_list.hpp"

namespace lancer::tracer {

/// A primitive that passes through the start of a ray.
struct Contact {
  std::uint32_t primitive = 0;
  std::uint32_t shape = 0;
  std::uint8_t face = 0;  // of a box
  bool inside = false;    // the ray starts on the side that the normal points away from
  bool in_shape = false;  // the ray starts inside the shape; for all but facets of a mesh the same
  bool left = false;      // the surface that this ray leaves, which it never meets here
  bool joined = false;    // one of the facets of a closed mesh that meet here and are crossed as one
  Vec3 normal;            // outward, unit length, at the start
};
using Contacts = SmallList<Contact, 2>;

/// The solids that a ray is inside of, as places in Scene::shapes, in the order of entry.
using OpenSolids = SmallList<std::uint32_t, 4>;

struct Ray {
  Vec3 origin;
  Vec3 direction;           // unit length
  double origin_error = 0;  // how far, at most, rounding moved the origin from where it should be
  Contacts contacts;
  OpenSolids open;
};

/// What intersection tests want to know of a ray, worked out once.
struct Probe {
  Vec3 origin, direction;
  Vec3 inverse;  // 1 / direction, infinite where a component is 0
  /// For facets. kz: the largest component; kx and ky keep the winding (Woop, Benthin, Wald 2013)
  int kx = 0, ky = 1, kz = 2;
  double shear_x = 0, shear_y = 0;

  /// Where there are no facets, what they ask for may be left out.
  Probe(Vec3 origin_in, Vec3 direction_in, bool for_facets = true)
      : origin(origin_in),
        direction(direction_in),
        inverse{1 / direction.x, 1 / direction.y, 1 / direction.z} {
    if (for_facets) find_shear();
  }
  explicit Probe(const Ray& ray, bool for_facets = true) : Probe(ray.origin, ray.direction, for_facets) {}

 private:
  void find_shear() {
    const Vec3 a{std::fabs(direction.x), std::fabs(direction.y), std::fabs(direction.z)};
    kz = a.x > a.y ? (a.x > a.z ? 0 : 2) : (a.y > a.z ? 1 : 2);
    kx = (kz + 1) % 3;
    ky = (kx + 1) % 3;
    if (direction[kz] < 0) std::swap(kx, ky);
    shear_x = direction[kx] / direction[kz];
    shear_y = direction[ky] / direction[kz];
  }
};

/// Where the line of a ray crosses a surface.
struct Root {
  double t = 0;      // along the ray; may be negative
  double error = 0;  // how far, at most, t is off for rounding and for the slack of the surface
  bool entering = true;
  bool loose = false;     // the ray all but lies in the surface, whose slack may put the crossing anywhere
  std::uint8_t face = 0;  // of a box: 2 axis, + 1 for the upper side
  bool rim = false;       // met by exact arithmetic, perhaps at the very rim of a facet
};

/// None, one or two crossings in ascending order of t.
struct Roots {
  int count = 0;
  Root root[2];
  bool passes = false;    // none, but the ray passes by a facet's rim within rounding: root[0] is where
  bool at_start = false;  // root[0] counts where the ray starts, although rounding has it behind that
};

}  // namespace lancer::tracer
