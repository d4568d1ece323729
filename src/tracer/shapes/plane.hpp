#pragma once
// Planes: the points x with normal . (x - point) = level. The normal is as written, neither divided by its
// length nor rounded by that, but for a power of two.

#include "tracer/shapes/landing.hpp"

namespace lancer::tracer {

struct PlanePrimitive {
  Vec3 point;
  Vec3 normal;       // outward, largest component in [1, 2)
  double level = 0;  // in units of the normal's length
  Vec3 unit_normal;
  double size = 0;          // the sum of the normal's components' magnitudes
  double slack = 0;         // how far rounding may have moved the surface
  double normal_error = 0;  // relative, of the normal
  int across = -1;          // the axis that it lies across at the point's own coordinate; -1: none
};

Landing land(const PlanePrimitive& plane, Vec3 origin, Vec3 direction, const Root& root);
inline Vec3 normal(const PlanePrimitive& plane) { return plane.unit_normal; }
/// The point of the plane next to p.
Vec3 project(const PlanePrimitive& plane, Vec3 p);
/// < 0 inside, 0 exactly on the surface, > 0 outside, in units of the normal's length.
double side(const PlanePrimitive& plane, Vec3 p);

}  // namespace lancer::tracer
