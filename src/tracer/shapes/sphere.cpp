#include "tracer/shapes/careful.hpp"
#include "tracer/shapes/newton.hpp"
#include "tracer/shapes/sphere_roots.hpp"

namespace lancer::tracer {
namespace {

void set_slack(const SpherePrimitive& sphere, double half_chord, Landing& landing) {
  landing.root.error =
      along_ray(sphere.slack, sphere.radius, half_chord) + 2 * k_u * std::fabs(landing.root.t);
}

[[gnu::noinline, gnu::cold]] Landings careful_landings(const SpherePrimitive& sphere, Vec3 origin,
                                                       Vec3 direction, Detail detail) {
  Landings found = careful(sphere, origin, direction, detail);
  for (Landing& landing : found.at)
    set_slack(sphere, sphere.radius * std::fabs(dot(landing.normal, direction)), landing);
  return found;
}

}  // namespace

Roots careful_roots(const SpherePrimitive& sphere, const Probe& probe) {
  return careful_landings(sphere, probe.origin, probe.direction, Detail::distances).roots();
}

Root exit(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction) {
  const Vec3 f = origin - sphere.center;
  const double half_chord = std::max(-dot(f, direction), 0.0);
  const double error = along_ray(sphere.slack, sphere.radius, half_chord);
  return {2 * half_chord, error + 16 * k_u * (sum_abs(f) + sphere.radius), false};
}

Landing land(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction, const Root& root) {
  Landing landing{root, 0, 0, {}, {}};
  if (land_quickly(sphere, origin, direction, landing)) {
    set_slack(sphere, sphere.radius * std::fabs(dot(landing.normal, direction)), landing);
    return landing;
  }
  if (take(careful_landings(sphere, origin, direction, Detail::places), root.entering, landing))
    return landing;
  landing.root = root;
  landing.point = project(sphere, origin + direction * root.t);
  landing.normal = normal(sphere, landing.point);
  return landing;
}

Vec3 normal(const SpherePrimitive& sphere, Vec3 p) { return normalize(p - sphere.center); }

Vec3 project(const SpherePrimitive& sphere, Vec3 p) {
  return sphere.center + normalize(p - sphere.center) * sphere.radius;
}

double side(const SpherePrimitive& sphere, Vec3 p) {
  const Triple2 f = exact_difference(p, sphere.center);
  Accurate power;
  power.add_product(-sphere.radius, sphere.radius);
  for (const DoubleDouble& x : f) {
    power.add_product(x.hi, x.hi);
    power.add_small(2 * x.hi * x.lo);
  }
  const double size = dot(rounded(f), rounded(f)) + sphere.radius * sphere.radius;
  const double out = power.value();
  return std::fabs(out) > 64 * k_u * k_u * size ? out : careful_side(sphere, p);
}

}  // namespace lancer::tracer
