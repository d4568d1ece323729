#include "tracer/shapes/box.hpp"

#include "tracer/shapes/careful.hpp"
#include "tracer/shapes/linear_form.hpp"
#include "tracer/shapes/newton.hpp"
#include "tracer/shapes/slabs.hpp"

namespace lancer::tracer {
namespace {

bool knows_sign(const Side& side) { return side.error == 0 || std::fabs(side.t) > side.error; }

/// How far a side may be off in the frame of the test, and the slope of a ray across it, for the rounding of
/// the box and of its way into the world.
double depth_slack(const BoxPrimitive& box, int face) { return box.reach[face / 2] * box.slack; }
double slope_slack(const BoxPrimitive& box, int face) {
  return box.aligned ? 0 : 8 * k_u * box.reach[face / 2];
}

void set_slack(const BoxPrimitive& box, const Vec3& direction, Landing& landing) {
  const int face = landing.root.face;
  set_bounds(depth_slack(box, face), dot(row(box, face / 2), direction), slope_slack(box, face), landing);
}

[[gnu::noinline, gnu::cold]] Landings careful_landings(const BoxPrimitive& box, Vec3 origin, Vec3 direction,
                                                       Detail detail) {
  Landings found = careful(box, origin, direction, detail);
  for (Landing& landing : found.at) set_slack(box, direction, landing);
  return found;
}

/// The plane of a side, its normal to the upper side.
Planar plane_of(const BoxPrimitive& box, int face) {
  const int axis = face / 2;
  const double level = face % 2 == 0 ? box.lo[axis] : box.hi[axis];
  if (!box.aligned) return {row(box, axis), level, box.center};
  Vec3 at;
  at[axis] = level;
  return {row(box, axis), 0, at};
}

/// The pairs of sides on a ray, where no direction is in doubt, with a bound for each pair.
struct Pairs {
  double in[3], out[3], doubt[3];
  bool upwards[3];

  void set(int axis, double lower, double upper, double error, bool up) {
    in[axis] = std::min(lower, upper);
    out[axis] = std::max(lower, upper);
    doubt[axis] = error + 4 * k_u * (std::fabs(lower) + std::fabs(upper));
    upwards[axis] = up;
  }
};

bool find_pairs_aligned(const BoxPrimitive& box, Vec3 origin, Vec3 direction, Vec3 inverse, Pairs& pairs) {
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0) return false;
    const double by = inverse[axis], o = origin[axis];
    pairs.set(axis, (box.lo[axis] - o) * by, (box.hi[axis] - o) * by, 0, by > 0);
  }
  return true;
}

bool find_pairs_turned(const Local& ray, Pairs& pairs) {
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis];
    if (std::fabs(d) <= 4 * ray.direction_error[axis]) return false;
    const double inverse = 1 / d, o = ray.origin[axis];
    const double lower = (-1 - o) * inverse, upper = (1 - o) * inverse;
    const double farther = std::fabs(lower) + std::fabs(upper);
    const double moved = ray.origin_error[axis] + farther * ray.direction_error[axis];
    pairs.set(axis, lower, upper, 1.5 * moved * std::fabs(inverse), d > 0);
  }
  return true;
}

/// Tells where no two of them are near each other, which is nearly always.
Answer decide(const Pairs& p, Side& enter, Side& leave) {
  int first = p.in[1] > p.in[0] ? 1 : 0, last = p.out[1] < p.out[0] ? 1 : 0;
  first = p.in[2] > p.in[first] ? 2 : first;
  last = p.out[2] < p.out[last] ? 2 : last;
  const double doubt = p.doubt[first] + p.doubt[last];
  if (p.in[first] > p.out[last] + doubt) return Answer::no;
  if (!(p.in[first] + doubt < p.out[last])) return Answer::unknown;
  const double near = p.in[first] - p.doubt[first], far = p.out[last] + p.doubt[last];
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != first && !(p.in[axis] + p.doubt[axis] < near)) return Answer::unknown;
    if (axis != last && !(p.out[axis] - p.doubt[axis] > far)) return Answer::unknown;
  }
  enter = {p.in[first], p.doubt[first], 2 * first + (p.upwards[first] ? 0 : 1)};
  leave = {p.out[last], p.doubt[last], 2 * last + (p.upwards[last] ? 1 : 0)};
  return Answer::yes;
}

Root root_at(const BoxPrimitive& box, const Side& side, bool entering, double slope) {
  const double steep = 1 / std::fabs(slope);
  const double doubt = slope_slack(box, side.face);
  const double slack = (depth_slack(box, side.face) + 2 * doubt * std::fabs(side.t)) * steep;
  return {side.t, side.error + slack, entering, doubt * steep > 0.5, static_cast<std::uint8_t>(side.face)};
}

Roots roots_at(const BoxPrimitive& box, const Side& in, const Side& out, Vec3 own_direction) {
  return {2,
          {root_at(box, in, true, own_direction[in.face / 2]),
           root_at(box, out, false, own_direction[out.face / 2])}};
}

/// For the few rays that those leave open.
[[gnu::noinline, gnu::cold]] Roots roots_by_clip(const BoxPrimitive& box, const Local& ray,
                                                 const Probe& probe) {
  const Clip clip(box, ray);
  const Answer hits = clip.hits();
  if (hits == Answer::no) return {};
  const Side &in = clip.enter(), &out = clip.leave();
  if (hits == Answer::yes && clip.knows_faces() && knows_sign(in) && knows_sign(out)) {
    return roots_at(box, in, out, ray.direction);
  }
  return careful_landings(box, probe.origin, probe.direction, Detail::distances).roots();
}

/// The same for a ray's way out of the box.
[[gnu::noinline, gnu::cold]] Root exit_by_clip(const BoxPrimitive& box, const Local& ray, Vec3 origin,
                                               Vec3 direction) {
  const Clip clip(box, ray);
  if (!clip.knows_faces()) {
    const Landings exactly = careful_landings(box, origin, direction, Detail::places);
    if (exactly.count == 2 && exactly.at[1].root.t > 0) return exactly.at[1].root;
  }
  Root leave = root_at(box, clip.leave(), false, ray.direction[clip.leave().face / 2]);
  leave.t = std::max(leave.t, 0.0);
  return leave;
}

[[gnu::noinline, gnu::cold]] void land_carefully(const BoxPrimitive& box, Vec3 origin, Vec3 direction,
                                                 const Root& root, Landing& landing) {
  if (take(careful_landings(box, origin, direction, Detail::places), root.entering, landing)) {
    snap(plane_of(box, landing.root.face), landing.point);
  } else {
    landing.root = root;
    set_slack(box, direction, landing);
    landing.point = project(box, origin + direction * root.t, root.face);
  }
}

}  // namespace

Roots roots(const BoxPrimitive& box, const Probe& probe) {
  Pairs pairs;
  Side in, out;
  if (box.aligned) {
    if (find_pairs_aligned(box, probe.origin, probe.direction, probe.inverse, pairs)) {
      const Answer hits = decide(pairs, in, out);
      if (hits == Answer::no) return {};
      if (hits == Answer::yes && knows_sign(in) && knows_sign(out)) {
        return roots_at(box, in, out, probe.direction);
      }
    }
    return roots_by_clip(box, to_frame(box, probe.origin, probe.direction), probe);
  }
  const Local ray = to_frame(box, probe.origin, probe.direction);
  if (find_pairs_turned(ray, pairs)) {
    const Answer hits = decide(pairs, in, out);
    if (hits == Answer::no) return {};
    if (hits == Answer::yes && knows_sign(in) && knows_sign(out))
      return roots_at(box, in, out, ray.direction);
  }
  return roots_by_clip(box, ray, probe);
}

Root exit(const BoxPrimitive& box, Vec3 origin, Vec3 direction) {
  Pairs pairs;
  Side in, out;
  if (box.aligned) {
    const Vec3 inverse{1 / direction.x, 1 / direction.y, 1 / direction.z};
    const bool found = find_pairs_aligned(box, origin, direction, inverse, pairs) &&
                       decide(pairs, in, out) == Answer::yes && out.t > 0;
    return found ? root_at(box, out, false, direction[out.face / 2])
                 : exit_by_clip(box, to_frame(box, origin, direction), origin, direction);
  }
  const Local ray = to_frame(box, origin, direction);
  const bool found = find_pairs_turned(ray, pairs) && decide(pairs, in, out) == Answer::yes && out.t > 0;
  return found ? root_at(box, out, false, ray.direction[out.face / 2])
               : exit_by_clip(box, ray, origin, direction);
}

Landing land(const BoxPrimitive& box, Vec3 origin, Vec3 direction, const Root& root) {
  const int axis = root.face / 2;
  Landing landing{root, 0, 0, {}, normal(box, root.face)};
  bool settled;
  if (box.aligned) {
    const double at = root.face % 2 == 0 ? box.lo[axis] : box.hi[axis];
    settled = land_quickly(Across{axis, at}, origin, direction, landing);
  } else {
    const Planar plane = plane_of(box, root.face);
    settled = land_quickly(plane, origin, direction, landing);
    snap(plane, landing.point);
  }
  if (settled && landing.root.t > 0) {
    set_slack(box, direction, landing);
  } else {
    land_carefully(box, origin, direction, root, landing);
  }
  return landing;
}

Vec3 normal(const BoxPrimitive& box, int face) {
  const Vec3 upper = box.aligned ? row(box, face / 2) : box.normals[static_cast<std::size_t>(face / 2)];
  return face % 2 == 0 ? -upper : upper;
}

Vec3 project(const BoxPrimitive& box, Vec3 p, int face) {
  Vec3 own = box.aligned ? p : apply(box.to_own, p - box.center);
  for (int axis = 0; axis < 3; ++axis) own[axis] = std::min(std::max(own[axis], box.lo[axis]), box.hi[axis]);
  own[face / 2] = face % 2 == 0 ? box.lo[face / 2] : box.hi[face / 2];
  return box.aligned ? own : box.center + apply(box.to_world, own);
}

Aabb bounds(const BoxPrimitive& box) {
  if (box.aligned) return Aabb{box.lo, box.hi}.padded(box.slack);
  const Vec3 half = apply_abs(box.to_world, box.hi);
  return Aabb{box.center - half, box.center + half}.padded(box.slack + 8 * k_u * max_abs(half));
}

double side(const BoxPrimitive& box, Vec3 p) {
  const Local at = to_frame(box, p, {});
  double out = -k_infinity, doubt = 0;
  for (int axis = 0; axis < 3; ++axis) {
    out = std::max(out, std::max(box.lo[axis] - at.origin[axis], at.origin[axis] - box.hi[axis]));
    doubt = std::max(doubt, at.origin_error[axis] + k_u * std::fabs(at.origin[axis]));
  }
  return std::fabs(out) > doubt || box.aligned ? out : careful_side(box, p);
}

}  // namespace lancer::tracer
