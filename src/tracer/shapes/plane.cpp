#include "tracer/shapes/plane.hpp"

#include "tracer/shapes/careful.hpp"
#include "tracer/shapes/linear_form.hpp"
#include "tracer/shapes/planar.hpp"

namespace lancer::tracer {
namespace {

Bounded depth_below(const PlanePrimitive& plane, Vec3 p) {
  return bounded_depth(plane.level, plane.normal, p, plane.point);
}

Planar plane_of(const PlanePrimitive& plane) { return planar(plane.normal, plane.level, plane.point); }

/// With the bounds that follow where the plane as written is off by its slack and its normal's error.
Root with_slack(const PlanePrimitive& plane, const Probe& probe, Bounded depth, const Bounded& slope) {
  const double size = sum_abs(plane.normal);
  depth.error += size * (plane.slack + plane.normal_error * sum_abs(probe.origin - plane.point));
  return crossing(depth, slope, size * plane.normal_error, slope.value < 0);
}

Root banded(const PlanePrimitive& plane, Vec3 origin, Vec3 direction, double t) {
  const double slope = dot(plane.normal, direction);
  Root root = with_slack(plane, Probe(origin, direction), {t * slope, 0}, {slope, 0});
  root.t = t;
  return root;
}

Landings careful_landings(const PlanePrimitive& plane, Vec3 origin, Vec3 direction) {
  Landings found = careful(plane, origin, direction);
  if (found.count == 0) return found;
  Root& root = found.at[0].root;
  const bool entering = root.entering;
  root = banded(plane, origin, direction, root.t);
  root.entering = entering;
  return found;
}

}  // namespace

Roots roots(const PlanePrimitive& plane, const Probe& probe) {
  const Bounded slope = bounded_dot(plane.normal, probe.direction);
  const Bounded depth = depth_below(plane, probe.origin);
  if (slope.value == 0 && slope.error == 0) return {};
  if (!knows_sign(slope) || !knows_sign(depth)) {
    const Landings exactly = careful_landings(plane, probe.origin, probe.direction);
    return {exactly.count, {exactly.at[0].root, {}}};
  }
  const Root root = with_slack(plane, probe, depth, slope);
  if (!std::isfinite(root.t)) return {};
  return {1, {root, {}}};
}

Landing land(const PlanePrimitive& plane, Vec3 origin, Vec3 direction, const Root& root) {
  Landing landing{root, {}, {}};
  const bool settled = land(plane_of(plane), origin, direction, root.t, landing);
  if (settled) {
    landing.root = banded(plane, origin, direction, landing.root.t);
    landing.root.entering = root.entering;
    return landing;
  }
  const Landings exactly = careful_landings(plane, origin, direction);
  if (exactly.count == 1 && exactly.at[0].root.t > 0) {
    landing = exactly.at[0];
    snap(plane_of(plane), landing.point);
    return landing;
  }
  landing.point = project(plane, origin + direction * root.t);
  landing.normal = normal(plane);
  return landing;
}

Vec3 normal(const PlanePrimitive& plane) { return unit(plane_of(plane).n); }

Vec3 project(const PlanePrimitive& plane, Vec3 p) {
  return p + plane.normal * (depth_below(plane, p).value / dot(plane.normal, plane.normal));
}

double side(const PlanePrimitive& plane, Vec3 p) {
  const Bounded depth = depth_below(plane, p);
  return knows_sign(depth) ? -depth.value : careful_side(plane, p);
}

}  // namespace lancer::tracer
