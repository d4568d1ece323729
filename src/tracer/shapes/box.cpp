#include "tracer/shapes/box.hpp"

#include <limits>

#include "tracer/shapes/linear_form.hpp"
#include "tracer/shapes/linear_map.hpp"

namespace lancer::tracer {
namespace {

/// A ray in the frame of the test, with bounds of what each component is off.
struct Local {
  Vec3 origin, direction;
  Vec3 origin_error, direction_error;
};

Local to_frame(const BoxPrimitive& box, Vec3 origin, Vec3 direction) {
  if (box.aligned) return {origin, direction, {box.slack, box.slack, box.slack}, {}};
  const Vec3 offset = origin - box.center;
  Local local{apply(box.to_own, offset), apply(box.to_own, direction),
              apply_abs(box.to_own, offset) * (8 * k_u), apply_abs(box.to_own, direction) * (8 * k_u)};
  for (int axis = 0; axis < 3; ++axis)
    local.origin_error[axis] += sum_abs(box.to_own[static_cast<std::size_t>(axis)]) * box.slack;
  return local;
}

/// Where the ray crosses the side of `axis`; the axis' direction component is not 0.
Root side_crossing(const BoxPrimitive& box, const Local& ray, int axis, bool upper) {
  const double gap = (upper ? box.hi[axis] : box.lo[axis]) - ray.origin[axis];
  const double d = ray.direction[axis];
  Root root = crossing({gap, k_u * std::fabs(gap) + ray.origin_error[axis]}, {d, 0},
                       ray.direction_error[axis], upper == (d < 0));
  root.face = static_cast<std::uint8_t>(2 * axis + (upper ? 1 : 0));
  return root;
}

}  // namespace

Roots roots(const BoxPrimitive& box, const Probe& probe) {
  const Local ray = to_frame(box, probe.origin, probe.direction);
  constexpr double k_infinity = std::numeric_limits<double>::infinity();
  Root enter = plain_root(-k_infinity, 0, true);
  Root leave = plain_root(k_infinity, 0, false);
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis];
    if (d == 0) {
      if (ray.origin[axis] < box.lo[axis] || ray.origin[axis] > box.hi[axis]) return {};
      continue;
    }
    const Root in = side_crossing(box, ray, axis, d < 0);
    const Root out = side_crossing(box, ray, axis, d > 0);
    if (in.t > enter.t) enter = in;
    if (out.t < leave.t) leave = out;
  }
  if (!(enter.t <= leave.t)) return {};
  return {2, {enter, leave}};
}

Root exit(const BoxPrimitive& box, Vec3 origin, Vec3 direction) {
  const Local ray = to_frame(box, origin, direction);
  Root leave = plain_root(std::numeric_limits<double>::infinity(), 0, false);
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) continue;
    const Root out = side_crossing(box, ray, axis, ray.direction[axis] > 0);
    if (out.t < leave.t) leave = out;
  }
  leave.t = std::fmax(leave.t, 0);
  leave.high = std::fmax(leave.high, leave.t);
  return leave;
}

Vec3 normal(const BoxPrimitive& box, int face) {
  const int axis = face / 2;
  const double sign = face % 2 == 0 ? -1 : 1;
  if (!box.aligned) return normalize(box.to_own[static_cast<std::size_t>(axis)] * sign);
  Vec3 n;
  n[axis] = sign;
  return n;
}

Vec3 project(const BoxPrimitive& box, Vec3 p, int face) {
  Vec3 own = box.aligned ? p : apply(box.to_own, p - box.center);
  for (int axis = 0; axis < 3; ++axis)
    own[axis] = std::fmin(std::fmax(own[axis], box.lo[axis]), box.hi[axis]);
  own[face / 2] = face % 2 == 0 ? box.lo[face / 2] : box.hi[face / 2];
  return box.aligned ? own : box.center + apply(box.to_world, own);
}

Aabb bounds(const BoxPrimitive& box) {
  if (box.aligned) return Aabb{box.lo, box.hi}.padded(box.slack);
  const Vec3 half = apply_abs(box.to_world, box.hi);
  return Aabb{box.center - half, box.center + half}.padded(box.slack + 8 * k_u * max_abs(half));
}

double side(const BoxPrimitive& box, Vec3 p) {
  const Vec3 own = box.aligned ? p : apply(box.to_own, p - box.center);
  double out = -std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    out = std::fmax(out, std::fmax(box.lo[axis] - own[axis], own[axis] - box.hi[axis]));
  }
  return out;
}

}  // namespace lancer::tracer
