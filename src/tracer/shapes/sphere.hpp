#pragma once
// Spheres in world space, and the quadratic that ellipsoids share with them.

#include "tracer/aabb.hpp"

namespace lancer::tracer {

struct SpherePrimitive {
  Vec3 center;
  double radius = 1;
  double slack = 0;  // how far rounding may have moved the surface
};

/// The crossings of the ray f + t d with the sphere of radius r around the origin; d of any length. `low` is
/// what rounding took from f, `slack` bounds what the surface and f may be off otherwise. The discriminant is
/// Hearn and Baker's, r^2 - |f - (f.d)d/|d|^2|^2, and the roots are free of cancellation (Haines, Guenther,
/// Akenine-Moeller, Ray Tracing Gems, chapter 7).
Roots quadric_roots(Vec3 f, Vec3 low, Vec3 d, double r, double slack);

Roots roots(const SpherePrimitive& sphere, const Probe& probe);
/// Where a ray that starts on the sphere and goes inwards leaves it.
Root exit(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction);
Vec3 normal(const SpherePrimitive& sphere, Vec3 p);
/// The point of the sphere next to p.
Vec3 project(const SpherePrimitive& sphere, Vec3 p);
Aabb bounds(const SpherePrimitive& sphere);
/// < 0 inside, 0 exactly on the surface, > 0 outside.
double side(const SpherePrimitive& sphere, Vec3 p);

}  // namespace lancer::tracer
