#include "tracer/shapes/ellipsoid.hpp"

#include "tracer/shapes/linear_map.hpp"
#include "tracer/shapes/sphere.hpp"

namespace lancer::tracer {
namespace {

/// What rounding, of the maps' own entries too, may move a point by in the unit sphere's space.
double own_error(const EllipsoidPrimitive& e, Vec3 offset) {
  const double stretch =
      std::fmax(sum_abs(e.to_own[0]), std::fmax(sum_abs(e.to_own[1]), sum_abs(e.to_own[2])));
  return 8 * k_u * sum_abs(apply_abs(e.to_own, offset)) + stretch * e.slack;
}

}  // namespace

Roots roots(const EllipsoidPrimitive& e, const Probe& probe) {
  const Vec3 offset = probe.origin - e.center;
  const Vec3 f = apply(e.to_own, offset);
  return quadric_roots(f, {}, apply(e.to_own, probe.direction), 1, own_error(e, offset));
}

Root exit(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction) {
  const Vec3 offset = origin - e.center;
  const Vec3 f = apply(e.to_own, offset);
  const Vec3 d = apply(e.to_own, direction);
  const double a = dot(d, d);
  const double error = (4 * k_u * (sum_abs(f) + 1) + own_error(e, offset)) / std::sqrt(a);
  return plain_root(std::fmax(-2 * dot(f, d) / a, 0), error, false);
}

Vec3 normal(const EllipsoidPrimitive& e, Vec3 p) {
  return normalize(apply_transposed(e.to_own, normalize(apply(e.to_own, p - e.center))));
}

Vec3 project(const EllipsoidPrimitive& e, Vec3 p) {
  return e.center + apply(e.to_world, normalize(apply(e.to_own, p - e.center)));
}

Aabb bounds(const EllipsoidPrimitive& e) {
  const Vec3 half{length(e.to_world[0]), length(e.to_world[1]), length(e.to_world[2])};
  return Aabb{e.center - half, e.center + half}.padded(e.slack + 8 * k_u * max_abs(half));
}

double side(const EllipsoidPrimitive& e, Vec3 p) {
  const Vec3 own = apply(e.to_own, p - e.center);
  return dot(own, own) - 1;
}

}  // namespace lancer::tracer
