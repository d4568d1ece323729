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

/// Exact, for the few rays that rounding leaves open.
[[gnu::cold]] Roots careful_roots(const SpherePrimitive& sphere, const Probe& probe);

/// Hearn and Baker's discriminant, r^2 - |f - (f.d)d|^2, which does not lose the radius far away (Haines,
/// Guenther, Akenine-Moeller, Ray Tracing Gems, chapter 7), with a bound of its error; exact within that.
inline Roots roots(const SpherePrimitive& sphere, const Probe& probe) {
  const double r = sphere.radius;
  const Vec3 f = probe.origin - sphere.center;
  const double b = -dot(f, probe.direction);
  const Vec3 from_axis = f + probe.direction * b;
  const double discriminant = r * r - dot(from_axis, from_axis);
  const double reach = sum_abs(f);
  const double lost = 20 * k_u * reach;  // bounds the error of from_axis
  const double doubt = 2 * lost * (sum_abs(from_axis) + lost) + 4 * k_u * r * r;
  if (discriminant < -doubt) return {};
  if (discriminant > doubt) {
    const double half_chord = std::sqrt(discriminant);
    const double near = b - half_chord, far = b + half_chord;
    const double lateral = (sphere.slack * r + doubt) / half_chord;
    const double error = sphere.slack + lateral + 18 * k_u * (reach + r);
    if (std::fabs(near) > error && std::fabs(far) > error) {
      return {2, {Root{near, error, true}, Root{far, error, false}}};
    }
  }
  return careful_roots(sphere, probe);
}
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
