#include "tracer/shapes/sphere_roots.hpp"

namespace lancer::tracer {

Roots roots(const SpherePrimitive& sphere, const Probe& probe) {
  const Vec3 f = probe.origin - sphere.center;
  const double b = dot(f, probe.direction);
  const double discriminant = b * b - (dot(f, f) - sphere.radius * sphere.radius);
  if (discriminant < 0) return {};
  const double half = std::sqrt(discriminant);
  return {2, {Root{-b - half, 0, true}, Root{-b + half, 0, false}}};
}

Root exit(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction) {
  return {std::fmax(-2 * dot(origin - sphere.center, direction), 0), 0, false};
}

Landing land(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction, const Root& root) {
  const Vec3 p = origin + direction * root.t;
  return {root, 0, 0, p, normal(sphere, p)};
}

Vec3 normal(const SpherePrimitive& sphere, Vec3 p) { return (p - sphere.center) / sphere.radius; }

Vec3 project(const SpherePrimitive&, Vec3 p) { return p; }

double side(const SpherePrimitive& sphere, Vec3 p) {
  const Vec3 f = p - sphere.center;
  return dot(f, f) - sphere.radius * sphere.radius;
}

}  // namespace lancer::tracer
