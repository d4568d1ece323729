#pragma once
// What planes, sides of boxes and facets share: landing on n . (x - at) = level.

#include "tracer/shapes/landing.hpp"

namespace lancer::tracer {

struct Planar {
  Triple2 n;     // of any length
  Vec3 n_terms;  // what its components' errors, a few 2^-105, are multiples of
  double level = 0;
  Vec3 at;
};

inline Planar planar(Vec3 n, double level, Vec3 at) {
  return {{DoubleDouble{n.x, 0}, DoubleDouble{n.y, 0}, DoubleDouble{n.z, 0}}, abs(n), level, at};
}

/// Where the ray meets the plane, near t; false where twice the precision is not enough. Fills point and
/// normal, with the normal's sign that of n, and the distance.
bool land(const Planar& plane, Vec3 origin, Vec3 direction, double t, Landing& landing);

/// The coordinate of all points of a plane across an axis is what the plane says, and needs no ray.
void snap(const Planar& plane, Vec3& point);

}  // namespace lancer::tracer
