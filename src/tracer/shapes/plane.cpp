#include "tracer/shapes/careful.hpp"
#include "tracer/shapes/linear_form.hpp"
#include "tracer/shapes/newton.hpp"
#include "tracer/shapes/plane_roots.hpp"

namespace lancer::tracer {
namespace {

Bounded depth_below(const PlanePrimitive& plane, Vec3 p) {
  return bounded_depth(plane.level, plane.normal, p, plane.point);
}

/// How far the plane may be off next to a point that far from the plane's own, and its slope, in units of the
/// normal's length.
double depth_slack(const PlanePrimitive& plane, double distance) {
  return plane.size * (plane.slack + plane.normal_error * distance);
}
double slope_slack(const PlanePrimitive& plane) { return plane.size * plane.normal_error; }

void set_slack(const PlanePrimitive& plane, const Vec3& origin, const Vec3& direction, Landing& landing) {
  set_bounds(depth_slack(plane, sum_abs(origin - plane.point)), dot(plane.normal, direction),
             slope_slack(plane), landing);
}

[[gnu::noinline, gnu::cold]] Landings careful_landings(const PlanePrimitive& plane, Vec3 origin,
                                                       Vec3 direction, Detail detail) {
  Landings found = careful(plane, origin, direction, detail);
  set_slack(plane, origin, direction, found.at[0]);
  return found;
}

Planar planar(const PlanePrimitive& plane) { return {plane.normal, plane.level, plane.point}; }

[[gnu::noinline, gnu::cold]] void land_carefully(const PlanePrimitive& plane, Vec3 origin, Vec3 direction,
                                                 const Root& root, Landing& landing) {
  if (take(careful_landings(plane, origin, direction, Detail::places), root.entering, landing)) {
    snap(planar(plane), landing.point);
  } else {
    landing.root = root;
    set_slack(plane, origin, direction, landing);
    landing.point = project(plane, origin + direction * root.t);
  }
}

Roots roots_with(const PlanePrimitive& plane, Bounded slope, Bounded depth, double distance) {
  depth.error += depth_slack(plane, distance);
  slope.error += slope_slack(plane);
  const Root root = crossing(depth, slope, slope.value < 0);
  if (!std::isfinite(root.t)) return {};
  return {1, {root, {}}};
}

/// For the few rays that start all but in the plane, or run all but along it.
[[gnu::noinline, gnu::cold]] Roots close_roots(const PlanePrimitive& plane, const Probe& probe,
                                               double distance) {
  const Bounded slope = bounded_dot(plane.normal, probe.direction);
  const Bounded depth = depth_below(plane, probe.origin);
  if (slope.value == 0 && slope.error == 0) return {};
  if (knows_sign(slope) && knows_sign(depth)) return roots_with(plane, slope, depth, distance);
  return careful_landings(plane, probe.origin, probe.direction, Detail::distances).roots();
}

}  // namespace

Roots tilted_roots(const PlanePrimitive& plane, const Probe& probe) {
  const Vec3 offset = probe.origin - plane.point;
  const double distance = sum_abs(offset);
  const Bounded slope{dot(plane.normal, probe.direction), 3 * k_u * plane.size};
  const Bounded depth{plane.level - dot(plane.normal, offset),
                      5 * k_u * (plane.size * distance + std::fabs(plane.level))};
  if (std::fabs(slope.value) > slope.error && std::fabs(depth.value) > depth.error) {
    return roots_with(plane, slope, depth, distance);
  }
  return close_roots(plane, probe, distance);
}

Landing land(const PlanePrimitive& plane, Vec3 origin, Vec3 direction, const Root& root) {
  Landing landing{root, 0, 0, {}, plane.unit_normal};
  const bool settled = plane.across >= 0 ? land_quickly(Across{plane.across, plane.point[plane.across]},
                                                        origin, direction, landing)
                                         : land_quickly(planar(plane), origin, direction, landing);
  if (settled) {
    if (plane.across < 0) snap(planar(plane), landing.point);
    set_slack(plane, origin, direction, landing);
  } else {
    land_carefully(plane, origin, direction, root, landing);
  }
  return landing;
}

Vec3 project(const PlanePrimitive& plane, Vec3 p) {
  return p + plane.normal * (depth_below(plane, p).value / dot(plane.normal, plane.normal));
}

double side(const PlanePrimitive& plane, Vec3 p) {
  const Bounded depth = depth_below(plane, p);
  return knows_sign(depth) ? -depth.value : careful_side(plane, p);
}

}  // namespace lancer::tracer
