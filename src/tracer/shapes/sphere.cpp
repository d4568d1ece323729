#include "tracer/shapes/sphere.hpp"

#include <utility>

namespace lancer::tracer {
namespace {

/// |f + low|^2 - r^2 as if in twice the precision.
double power_of_point(Vec3 f, Vec3 low, double r) {
  Accurate sum;
  sum.add_product(-r, r);
  for (int axis = 0; axis < 3; ++axis) {
    sum.add_product(f[axis], f[axis]);
    sum.add_small(2 * f[axis] * low[axis]);
  }
  return sum.value();
}

}  // namespace

Roots quadric_roots(Vec3 f, Vec3 low, Vec3 d, double r, double slack) {
  const double a = dot(d, d);
  const double b = -dot(f, d);
  const Vec3 from_axis = f + d * (b / a);
  const double discriminant = r * r - dot(from_axis, from_axis);
  if (!(discriminant >= 0)) return {};
  const double half_chord = std::sqrt(discriminant);
  const double q = b + std::copysign(std::sqrt(a) * half_chord, b);
  const double far_from_zero = q / a;
  const double other = q == 0 ? 0 : power_of_point(f, low, r) / q;
  const double near = std::fmin(far_from_zero, other);
  const double far = std::fmax(far_from_zero, other);
  // A shift e across the ray moves a root by e r / half_chord along it, and by sqrt(2 e r) at most.
  const double e = 4 * k_u * (sum_abs(f) + r) + slack;
  const double along =
      half_chord > 0 ? std::fmin(e * r / half_chord, std::sqrt(2 * e * r)) : std::sqrt(2 * e * r);
  const double error = (e + along) / std::sqrt(a);
  return {2, {plain_root(near, error, true), plain_root(far, error, false)}};
}

Roots roots(const SpherePrimitive& sphere, const Probe& probe) {
  Vec3 f, low;
  for (int axis = 0; axis < 3; ++axis) {
    const Double2 difference = two_sum(probe.origin[axis], -sphere.center[axis]);
    f[axis] = difference.high;
    low[axis] = difference.low;
  }
  return quadric_roots(f, low, probe.direction, sphere.radius, sphere.slack);
}

Root exit(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction) {
  const Vec3 f = origin - sphere.center;
  const double t = -2 * dot(f, direction) / dot(direction, direction);
  return plain_root(std::fmax(t, 0), 4 * k_u * (sum_abs(f) + sphere.radius) + sphere.slack, false);
}

Vec3 normal(const SpherePrimitive& sphere, Vec3 p) { return normalize(p - sphere.center); }

Vec3 project(const SpherePrimitive& sphere, Vec3 p) {
  return sphere.center + normalize(p - sphere.center) * sphere.radius;
}

Aabb bounds(const SpherePrimitive& sphere) {
  const Vec3 half{sphere.radius, sphere.radius, sphere.radius};
  return Aabb{sphere.center - half, sphere.center + half}.padded(sphere.slack);
}

double side(const SpherePrimitive& sphere, Vec3 p) {
  return power_of_point(p - sphere.center, {}, sphere.radius);
}

}  // namespace lancer::tracer
