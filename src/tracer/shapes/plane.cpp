#include "tracer/shapes/plane.hpp"

#include "tracer/shapes/careful.hpp"
#include "tracer/shapes/linear_form.hpp"
#include "tracer/shapes/planar.hpp"

namespace lancer::tracer {
namespace {

Bounded depth_below(const PlanePrimitive& plane, Vec3 p) {
  return bounded_depth(plane.level, plane.normal, p, plane.point);
}

/// How far the plane may be off where the ray starts, and its slope, in units of the normal's length.
double depth_slack(const PlanePrimitive& plane, Vec3 origin) {
  return sum_abs(plane.normal) * (plane.slack + plane.normal_error * sum_abs(origin - plane.point));
}
double slope_slack(const PlanePrimitive& plane) { return sum_abs(plane.normal) * plane.normal_error; }

void set_slack(const PlanePrimitive& plane, Vec3 origin, Vec3 direction, Landing& landing) {
  spread(depth_slack(plane, origin), dot(plane.normal, direction), slope_slack(plane), landing);
}

Landings careful_landings(const PlanePrimitive& plane, Vec3 origin, Vec3 direction) {
  Landings found = careful(plane, origin, direction);
  set_slack(plane, origin, direction, found.at[0]);
  return found;
}

Planar plane_of(const PlanePrimitive& plane) { return planar(plane.normal, plane.level, plane.point); }

LANCER_FUSED bool land_fused(const PlanePrimitive& plane, Vec3 origin, Vec3 direction, Landing& landing) {
  return land_by<Fused>(plane_of(plane), origin, direction, landing);
}
bool land_split(const PlanePrimitive& plane, Vec3 origin, Vec3 direction, Landing& landing) {
  return land_by<Split>(plane_of(plane), origin, direction, landing);
}

}  // namespace

Roots roots(const PlanePrimitive& plane, const Probe& probe) {
  const Bounded slope = bounded_dot(plane.normal, probe.direction);
  const Bounded depth = depth_below(plane, probe.origin);
  if (slope.value == 0 && slope.error == 0) return {};
  if (!knows_sign(slope) || !knows_sign(depth)) {
    return careful_landings(plane, probe.origin, probe.direction).roots();
  }
  const Root root = crossing({depth.value, depth.error + depth_slack(plane, probe.origin)},
                             {slope.value, slope.error + slope_slack(plane)}, slope.value < 0);
  if (!std::isfinite(root.t)) return {};
  return {1, {root, {}}};
}

Landing land(const PlanePrimitive& plane, Vec3 origin, Vec3 direction, const Root& root) {
  Landing landing{root, 0, 0, {}, plane.unit_normal};
  if (k_has_fused ? land_fused(plane, origin, direction, landing)
                  : land_split(plane, origin, direction, landing)) {
    set_slack(plane, origin, direction, landing);
    return landing;
  }
  const Landings exactly = careful_landings(plane, origin, direction);
  if (exactly.count == 1 && exactly.at[0].root.t > 0) {
    landing = exactly.at[0];
    snap(plane_of(plane), landing.point);
    return landing;
  }
  landing.root = root;
  set_slack(plane, origin, direction, landing);
  landing.point = project(plane, origin + direction * root.t);
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
