#pragma once
// Spheres under a transform that is no similarity. Rays are carried into the space where it is the unit
// sphere around the origin; the origin of the world is moved to its centre first, so that distance costs no
// accuracy.

#include "tracer/aabb.hpp"
#include "tracer/shapes/landing.hpp"
#include "tracer/shapes/linear_map.hpp"

namespace lancer::tracer {

/// The points x with |to_own (x - center)| = 1.
struct EllipsoidPrimitive {
  Vec3 center;
  Rows to_own;           // offsets from the centre to the unit sphere's space
  Rows to_world;         // and back
  double slack = 0;      // how far rounding may have moved the surface, in world units
  double reach = 0;      // the sum of the magnitudes of to_own
  double own_slack = 0;  // the slack in the unit sphere's space
};

Roots roots(const EllipsoidPrimitive& ellipsoid, const Probe& probe);
Root exit(const EllipsoidPrimitive& ellipsoid, Vec3 origin, Vec3 direction);
Landing land(const EllipsoidPrimitive& ellipsoid, Vec3 origin, Vec3 direction, const Root& root);
Vec3 normal(const EllipsoidPrimitive& ellipsoid, Vec3 p);
Vec3 project(const EllipsoidPrimitive& ellipsoid, Vec3 p);
Aabb bounds(const EllipsoidPrimitive& ellipsoid);
/// < 0 inside, 0 exactly on the surface, > 0 outside.
double side(const EllipsoidPrimitive& ellipsoid, Vec3 p);

}  // namespace lancer::tracer
