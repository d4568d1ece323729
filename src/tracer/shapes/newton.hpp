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

#define LANCER_LANDINGS(TARGET)                                                \
  namespace TARGET {                                                           \
  bool land(const SpherePrimitive&, Vec3 origin, Vec3 direction, Landing&);    \
  bool land(const EllipsoidPrimitive&, Vec3 origin, Vec3 direction, Landing&); \
  bool land(const Planar&, Vec3 origin, Vec3 direction, Landing&);             \
  bool land(const Across&, Vec3 origin, Vec3 direction, Landing&);             \
  bool land(const FacetPrimitive&, Vec3 origin, Vec3 direction, Landing&);     \
  }
LANCER_LANDINGS(baseline)
#if defined(LANCER_HAS_AVX2)
LANCER_LANDINGS(avx2)
#endif
#undef LANCER_LANDINGS

template <class Surface>
bool land_quickly(const Surface& surface, Vec3 origin, Vec3 direction, Landing& landing) {
#if defined(LANCER_HAS_AVX2)
  if (k_use_avx2) return avx2::land(surface, origin, direction, landing);
#endif
  return baseline::land(surface, origin, direction, landing);
}

/// The coordinate that all points of a plane across an axis share is what the plane says, and needs no ray.
inline void snap(const Planar& plane, Vec3& point) {
  for (int axis = 0; axis < 3; ++axis) {
    if (plane.n[(axis + 1) % 3] != 0 || plane.n[(axis + 2) % 3] != 0) continue;
    const DoubleDouble off = DoubleDouble{plane.level, 0} / DoubleDouble{plane.n[axis], 0};
    point[axis] = plane.level == 0 ? plane.at[axis] : (plane.at[axis] + off).hi;
  }
}

}  // namespace lancer::tracer
