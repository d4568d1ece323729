#include "tracer/shapes/plane.hpp"

#include "tracer/shapes/linear_form.hpp"

namespace lancer::tracer {
namespace {

Bounded depth_below(const PlanePrimitive& plane, Vec3 p) {
  return bounded_depth(plane.level, plane.normal, p, plane.point);
}

}  // namespace

Roots roots(const PlanePrimitive& plane, const Probe& probe) {
  const Bounded slope = bounded_dot(plane.normal, probe.direction);
  if (slope.value == 0) return {};
  const double size = sum_abs(plane.normal);
  Bounded depth = depth_below(plane, probe.origin);
  depth.error += size * (plane.slack + plane.normal_error * sum_abs(probe.origin - plane.point));
  const Root root = crossing(depth, slope, size * plane.normal_error, slope.value < 0);
  if (!std::isfinite(root.t)) return {};
  return {1, {root, {}}};
}

Vec3 normal(const PlanePrimitive& plane) { return normalize(plane.normal); }

Vec3 project(const PlanePrimitive& plane, Vec3 p) {
  return p + plane.normal * (depth_below(plane, p).value / dot(plane.normal, plane.normal));
}

double side(const PlanePrimitive& plane, Vec3 p) { return -depth_below(plane, p).value; }

}  // namespace lancer::tracer
