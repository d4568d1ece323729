#pragma once
// The arithmetic of landings, in two versions of the same bits (see lanes.hpp). Each corrects the distance in
// `landing` and fills in the point and, where the surface is not flat, the normal; false where twice the
// precision is not enough.

#include "tracer/processor.hpp"
#include "tracer/shapes/box.hpp"
#include "tracer/shapes/ellipsoid.hpp"
#include "tracer/shapes/facet.hpp"
#include "tracer/shapes/landing.hpp"
#include "tracer/shapes/plane.hpp"
#include "tracer/shapes/sphere.hpp"

namespace lancer::tracer {

/// The points x with n . (x - at) = level.
struct Planar {
  Vec3 n;
  double level = 0;
  Vec3 at;
};

/// The points x with x[axis] = at.
struct Across {
  int axis = 0;
  double at = 0;
};

#define LANCER_LANDINGS(TARGET)                                                              \
  namespace TARGET {                                                                         \
  bool land(const SpherePrimitive&, const Vec3& origin, const Vec3& direction, Landing&);    \
  bool land(const EllipsoidPrimitive&, const Vec3& origin, const Vec3& direction, Landing&); \
  bool land(const Planar&, const Vec3& origin, const Vec3& direction, Landing&);             \
  bool land(const Across&, const Vec3& origin, const Vec3& direction, Landing&);             \
  bool land(const FacetPrimitive&, const Vec3& origin, const Vec3& direction, Landing&);     \
  }
LANCER_LANDINGS(baseline)
#if defined(LANCER_HAS_AVX2)
LANCER_LANDINGS(avx2)
#endif
#undef LANCER_LANDINGS

template <class Surface>
bool land_quickly(const Surface& surface, const Vec3& origin, const Vec3& direction, Landing& landing) {
#if defined(LANCER_HAS_AVX2)
  if (k_use_avx2) return avx2::land(surface, origin, direction, landing);
#endif
  return baseline::land(surface, origin, direction, landing);
}

/// The coordinate that all points of a plane across an axis share is what the plane says, and needs no ray.
void snap_across(const Planar& plane, int axis, Vec3& point);
inline void snap(const Planar& plane, Vec3& point) {
  const bool x = plane.n.x != 0, y = plane.n.y != 0, z = plane.n.z != 0;
  if (x + y + z == 1) snap_across(plane, x ? 0 : (y ? 1 : 2), point);
}

}  // namespace lancer::tracer
