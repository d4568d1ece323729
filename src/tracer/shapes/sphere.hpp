#pragma once
// Spheres in world space.

#include "tracer/aabb.hpp"
#include "tracer/shapes/landing.hpp"

namespace lancer::tracer {

struct SpherePrimitive {
  Vec3 center;
  double radius = 1;
  double slack = 0;  // how far rounding may have moved the surface
};

/// Where a ray that starts on the sphere and goes inwards leaves it.
Root exit(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction);
/// The crossing that `root` is near.
Landing land(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction, const Root& root);
Vec3 normal(const SpherePrimitive& sphere, Vec3 p);
/// The point of the sphere next to p.
Vec3 project(const SpherePrimitive& sphere, Vec3 p);
inline Aabb bounds(const SpherePrimitive& sphere) {
  const Vec3 half{sphere.radius, sphere.radius, sphere.radius};
  return Aabb{sphere.center - half, sphere.center + half}.padded(sphere.slack);
}
/// < 0 inside, 0 exactly on the surface, > 0 outside.
double side(const SpherePrimitive& sphere, Vec3 p);

/// How far the crossing moves along a ray where a sphere moves by `shift`; `half_chord` is the part of the
/// radius along the ray: by shift / cosine, but sqrt(2 shift radius) at most.
inline double along_ray(double shift, double radius, double half_chord) {
  const double rise = shift * radius;
  const bool steep = half_chord > 0 && 2 * half_chord * half_chord >= rise;
  return shift + (steep ? rise / half_chord : std::sqrt(2 * rise));
}

}  // namespace lancer::tracer
