#pragma once
// Spheres under a transform that is no similarity. Rays are carried into the space where it is the unit
// sphere around the origin; the origin of the world is moved to its centre first, so that distance costs no
// accuracy.

#include <array>

#include "tracer/aabb.hpp"

namespace lancer::tracer {

struct EllipsoidPrimitive {
  Vec3 center;
  std::array<Vec3, 3> to_own;    // rows: offsets from the centre to the unit sphere's space
  std::array<Vec3, 3> to_world;  // rows, and back
  double slack = 0;              // in world units
};

Roots roots(const EllipsoidPrimitive& ellipsoid, const Probe& probe);
Root exit(const EllipsoidPrimitive& ellipsoid, Vec3 origin, Vec3 direction);
Vec3 normal(const EllipsoidPrimitive& ellipsoid, Vec3 p);
Vec3 project(const EllipsoidPrimitive& ellipsoid, Vec3 p);
Aabb bounds(const EllipsoidPrimitive& ellipsoid);
double side(const EllipsoidPrimitive& ellipsoid, Vec3 p);

}  // namespace lancer::tracer
