#pragma once
// The test of planes, which searches take into themselves.

#include <cmath>

#include "tracer/shapes/plane.hpp"

namespace lancer::tracer {

/// Of a plane that lies across no axis.
Roots tilted_roots(const PlanePrimitive& plane, const Probe& probe);

/// Where the plane lies across an axis, every sign is certain.
inline Roots roots_across(const PlanePrimitive& plane, const Probe& probe, double height, double distance) {
  if (probe.direction[plane.across] == 0) return {};
  const double inverse = probe.inverse[plane.across];
  const double t = -height * inverse, steep = std::fabs(inverse);
  const double slack = plane.slack + plane.normal_error * (distance + 2 * std::fabs(t));
  const bool entering = std::signbit(inverse) != std::signbit(plane.normal[plane.across]);
  if (!std::isfinite(t)) return {};
  return {1,
          {Root{t, slack * steep + 4 * k_u * std::fabs(t), entering, plane.normal_error * steep > 0.5}, {}}};
}

inline Roots roots(const PlanePrimitive& plane, const Probe& probe) {
  if (plane.across < 0) return tilted_roots(plane, probe);
  const Vec3 offset = probe.origin - plane.point;
  return roots_across(plane, probe, offset[plane.across], sum_abs(offset));
}

}  // namespace lancer::tracer
