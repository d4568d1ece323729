#include "tracer/shapes/plane_roots.hpp"

namespace lancer::tracer {

Roots roots(const PlanePrimitive& plane, const Probe& probe) {
  const double slope = dot(plane.normal, probe.direction);
  if (slope == 0) return {};
  const double t = (plane.level - dot(plane.normal, probe.origin - plane.point)) / slope;
  return {1, {Root{t, 0, slope < 0}, {}}};
}

Landing land(const PlanePrimitive& plane, Vec3 origin, Vec3 direction, const Root& root) {
  return {root, 0, 0, origin + direction * root.t, plane.unit_normal};
}

Vec3 project(const PlanePrimitive&, Vec3 p) { return p; }

double side(const PlanePrimitive& plane, Vec3 p) { return dot(plane.normal, p - plane.point) - plane.level; }

}  // namespace lancer::tracer
