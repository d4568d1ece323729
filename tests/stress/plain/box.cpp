#include "tracer/shapes/box.hpp"

namespace lancer::tracer {
namespace {

/// The slab test; false: missed.
bool clip(const BoxPrimitive& box, Vec3 o, Vec3 d, Root& enter, Root& leave) {
  if (!box.aligned) {
    o = apply(box.to_own, o - box.center);
    d = apply(box.to_own, d);
  }
  enter = Root{-k_infinity, 0, true};
  leave = Root{k_infinity, 0, false};
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0) {
      if (o[axis] < box.lo[axis] || o[axis] > box.hi[axis]) return false;
      continue;
    }
    const double inverse = 1 / d[axis];
    const int up = d[axis] > 0 ? 1 : 0;
    const double in = ((up ? box.lo : box.hi)[axis] - o[axis]) * inverse;
    const double out = ((up ? box.hi : box.lo)[axis] - o[axis]) * inverse;
    if (in > enter.t) {
      enter = Root{in, 0, true};
      enter.face = static_cast<std::uint8_t>(2 * axis + 1 - up);
    }
    if (out < leave.t) {
      leave = Root{out, 0, false};
      leave.face = static_cast<std::uint8_t>(2 * axis + up);
    }
  }
  return enter.t <= leave.t;
}

}  // namespace

Roots roots(const BoxPrimitive& box, const Probe& probe) {
  Roots found{2, {}};
  if (!clip(box, probe.origin, probe.direction, found.root[0], found.root[1])) return {};
  return found;
}

Root exit(const BoxPrimitive& box, Vec3 origin, Vec3 direction) {
  Root enter, leave;
  clip(box, origin, direction, enter, leave);
  leave.t = std::fmax(leave.t, 0);
  return leave;
}

Landing land(const BoxPrimitive& box, Vec3 origin, Vec3 direction, const Root& root) {
  return {root, 0, 0, origin + direction * root.t, normal(box, root.face)};
}

Vec3 normal(const BoxPrimitive& box, int face) {
  const double sign = face % 2 == 0 ? -1 : 1;
  Vec3 n;
  n[face / 2] = sign;
  if (box.aligned) return n;
  n = box.to_own[static_cast<std::size_t>(face / 2)] * sign;
  return n / std::sqrt(dot(n, n));
}

Vec3 project(const BoxPrimitive&, Vec3 p, int) { return p; }

Aabb bounds(const BoxPrimitive& box) {
  if (box.aligned) return Aabb{box.lo, box.hi}.padded(box.slack);
  const Vec3 half = apply_abs(box.to_world, box.hi);
  return Aabb{box.center - half, box.center + half}.padded(box.slack);
}

double side(const BoxPrimitive& box, Vec3 p) {
  const Vec3 own = box.aligned ? p : apply(box.to_own, p - box.center);
  double out = -k_infinity;
  for (int axis = 0; axis < 3; ++axis)
    out = std::fmax(out, std::fmax(box.lo[axis] - own[axis], own[axis] - box.hi[axis]));
  return out;
}

}  // namespace lancer::tracer
