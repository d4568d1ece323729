#include "tracer/shapes/plane.hpp"

#include "tracer/numeric.hpp"

namespace lancer::tracer {
namespace {

struct Bounded {
  double value = 0, error = 0;
};

/// level - normal . (p - point). Plain arithmetic where that is good to 64 ulp, else twice the precision.
Bounded depth_below(const PlanePrimitive& plane, Vec3 p) {
  const Vec3 offset = p - plane.point;
  const Vec3 terms{plane.normal.x * offset.x, plane.normal.y * offset.y, plane.normal.z * offset.z};
  const double plain = plane.level - (terms.x + terms.y + terms.z);
  const double magnitude = sum_abs(terms) + std::fabs(plane.level);
  if (std::fabs(plain) >= magnitude * 0.25) return {plain, 5 * k_u * magnitude};
  Accurate sum;
  sum.add(plane.level);
  for (int axis = 0; axis < 3; ++axis) {
    const Double2 exact = two_sum(p[axis], -plane.point[axis]);
    sum.add_product(-plane.normal[axis], exact.high);
    sum.add_small(-plane.normal[axis] * exact.low);
  }
  return {sum.value(), 2 * k_u * std::fabs(sum.value()) + 32 * k_u * k_u * magnitude};
}

/// normal . d, likewise.
Bounded slope(Vec3 normal, Vec3 d) {
  const Vec3 terms{normal.x * d.x, normal.y * d.y, normal.z * d.z};
  const double plain = terms.x + terms.y + terms.z;
  const double magnitude = sum_abs(terms);
  if (std::fabs(plain) >= magnitude * 0.25) return {plain, 3 * k_u * magnitude};
  Accurate sum;
  for (int axis = 0; axis < 3; ++axis) sum.add_product(normal[axis], d[axis]);
  return {sum.value(), 2 * k_u * std::fabs(sum.value()) + 16 * k_u * k_u * magnitude};
}

}  // namespace

Roots roots(const PlanePrimitive& plane, const Probe& probe) {
  const Bounded below = slope(plane.normal, probe.direction);
  if (below.value == 0) return {};
  const Bounded depth = depth_below(plane, probe.origin);
  const double t = depth.value / below.value;
  const double reach = sum_abs(probe.origin - plane.point) + std::fabs(t);
  const double off = depth.error + std::fabs(t) * below.error + plane.slack * sum_abs(plane.normal) +
                     plane.normal_error * sum_abs(plane.normal) * reach;
  const double error = off / std::fabs(below.value) + 2 * k_u * std::fabs(t);
  return {1, {{t, error, below.value < 0, 0}, {}}};
}

Vec3 normal(const PlanePrimitive& plane) { return normalize(plane.normal); }

Vec3 project(const PlanePrimitive& plane, Vec3 p) {
  return p + plane.normal * (depth_below(plane, p).value / dot(plane.normal, plane.normal));
}

double side(const PlanePrimitive& plane, Vec3 p) { return -depth_below(plane, p).value; }

}  // namespace lancer::tracer
