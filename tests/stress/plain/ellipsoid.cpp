#include "tracer/shapes/ellipsoid.hpp"

namespace lancer::tracer {

Roots roots(const EllipsoidPrimitive& e, const Probe& probe) {
  const Vec3 f = apply(e.to_own, probe.origin - e.center), d = apply(e.to_own, probe.direction);
  const double a = dot(d, d), b = dot(f, d);
  const double discriminant = b * b - a * (dot(f, f) - 1);
  if (discriminant < 0) return {};
  const double half = std::sqrt(discriminant);
  return {2, {Root{(-b - half) / a, 0, true}, Root{(-b + half) / a, 0, false}}};
}

Root exit(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction) {
  const Vec3 f = apply(e.to_own, origin - e.center), d = apply(e.to_own, direction);
  return {std::fmax(-2 * dot(f, d) / dot(d, d), 0), 0, false};
}

Landing land(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction, const Root& root) {
  const Vec3 p = origin + direction * root.t;
  return {root, 0, 0, p, normal(e, p)};
}

Vec3 normal(const EllipsoidPrimitive& e, Vec3 p) {
  const Vec3 n = apply_transposed(e.to_own, apply(e.to_own, p - e.center));
  return n / std::sqrt(dot(n, n));
}

Vec3 project(const EllipsoidPrimitive&, Vec3 p) { return p; }

Aabb bounds(const EllipsoidPrimitive& e) {
  const Vec3 half{length(e.to_world[0]), length(e.to_world[1]), length(e.to_world[2])};
  return Aabb{e.center - half, e.center + half}.padded(e.slack);
}

double side(const EllipsoidPrimitive& e, Vec3 p) {
  const Vec3 own = apply(e.to_own, p - e.center);
  return dot(own, own) - 1;
}

}  // namespace lancer::tracer
