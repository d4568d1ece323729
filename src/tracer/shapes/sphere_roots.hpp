#pragma once
// The test of spheres, which searches take into themselves.

#include <cmath>

#include "tracer/shapes/sphere.hpp"

namespace lancer::tracer {

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

}  // namespace lancer::tracer
