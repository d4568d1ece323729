#include "tracer/shapes/box.hpp"

#include <limits>

#include "tracer/shapes/careful.hpp"
#include "tracer/shapes/linear_form.hpp"
#include "tracer/shapes/planar.hpp"

namespace lancer::tracer {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// A ray in the frame of the test, with bounds of what each component is off.
struct Local {
  Vec3 origin, direction;
  Vec3 origin_error, direction_error;
};

Local to_frame(const BoxPrimitive& box, Vec3 origin, Vec3 direction) {
  if (box.aligned) return {origin, direction, {}, {}};
  const Vec3 offset = origin - box.center;
  return {apply(box.to_own, offset), apply(box.to_own, direction), apply_abs(box.to_own, offset) * (6 * k_u),
          apply_abs(box.to_own, direction) * (4 * k_u)};
}

Vec3 row(const BoxPrimitive& box, int axis) {
  if (!box.aligned) return box.to_own[static_cast<std::size_t>(axis)];
  Vec3 n;
  n[axis] = 1;
  return n;
}

/// Where the ray crosses a side, as computed.
struct Side {
  double t = 0, error = 0;
  int face = 0;
};

Side side_crossing(const BoxPrimitive& box, const Local& ray, int axis, bool upper) {
  const double gap = (upper ? box.hi[axis] : box.lo[axis]) - ray.origin[axis];
  const double t = gap / ray.direction[axis];
  const double moved = (ray.origin_error[axis] + std::fabs(t) * ray.direction_error[axis]) * (4.0 / 3);
  return {t, moved / std::fabs(ray.direction[axis]) + 2 * k_u * std::fabs(t), 2 * axis + (upper ? 1 : 0)};
}

enum class Answer : std::uint8_t { no, yes, unknown };

/// The part of a ray inside the box, by its sides, and what is known of it. Bounds are those of each side.
class Clip {
 public:
  Clip(const BoxPrimitive& box, const Local& ray) : box_(box), ray_(ray) {
    for (int axis = 0; axis < 3; ++axis) {
      // A direction that may point either way across a pair of sides is left for the end.
      if (std::fabs(ray.direction[axis]) <= 4 * ray.direction_error[axis]) continue;
      const bool upwards = ray.direction[axis] > 0;
      add(side_crossing(box, ray, axis, !upwards), side_crossing(box, ray, axis, upwards));
    }
  }

  const Side& enter() const { return enter_; }
  const Side& leave() const { return leave_; }

  /// Is the ray inside the box anywhere on its line?
  Answer hits() const {
    if (enter_.t - enter_.error > leave_.t + leave_.error) return Answer::no;
    Answer answer = enter_.t + enter_.error < leave_.t - leave_.error ? Answer::yes : Answer::unknown;
    for (int axis = 0; axis < 3; ++axis) {
      if (std::fabs(ray_.direction[axis]) > 4 * ray_.direction_error[axis]) continue;
      const Answer within = stays_within(axis);
      if (within == Answer::no) return within;
      if (within == Answer::unknown) answer = within;
    }
    return answer;
  }

  /// Is it certain through which sides?
  bool knows_faces() const { return !enter_tied_ && !leave_tied_; }

 private:
  void add(const Side& in, const Side& out) {
    const bool later = in.t > enter_.t, sooner = out.t < leave_.t;
    const bool close_in = std::fabs(in.t - enter_.t) <= in.error + enter_.error;
    const bool close_out = std::fabs(out.t - leave_.t) <= out.error + leave_.error;
    enter_tied_ = close_in || (enter_tied_ && !later);
    leave_tied_ = close_out || (leave_tied_ && !sooner);
    if (later) enter_ = in;
    if (sooner) leave_ = out;
  }

  /// Between the other sides, along a direction that is all but parallel to the sides of `axis`?
  Answer stays_within(int axis) const {
    const double farthest = std::fmax(std::fabs(enter_.t) + enter_.error, std::fabs(leave_.t) + leave_.error);
    const double drift = (std::fabs(ray_.direction[axis]) + ray_.direction_error[axis]) * farthest;
    const double doubt = ray_.origin_error[axis] + drift * (1 + 4 * k_u);
    const double at = ray_.origin[axis], lo = box_.lo[axis], hi = box_.hi[axis];
    if (at < lo - doubt || at > hi + doubt) return Answer::no;
    return at >= lo + doubt && at <= hi - doubt ? Answer::yes : Answer::unknown;
  }

  const BoxPrimitive& box_;
  const Local& ray_;
  Side enter_{-k_infinity, 0, 0}, leave_{k_infinity, 0, 0};
  bool enter_tied_ = false, leave_tied_ = false;
};

bool knows_sign(const Side& side) { return side.error == 0 || std::fabs(side.t) > side.error; }

/// How far a side may be off in the frame of the test, and the slope of a ray across it, for the rounding of
/// the box and of its way into the world.
double depth_slack(const BoxPrimitive& box, int face) {
  return box.aligned ? box.slack : sum_abs(row(box, face / 2)) * box.slack;
}
double slope_slack(const BoxPrimitive& box, int face, Vec3 direction) {
  return box.aligned ? 0 : 8 * k_u * dot(abs(row(box, face / 2)), abs(direction));
}

void set_slack(const BoxPrimitive& box, Vec3 direction, Landing& landing) {
  const int face = landing.root.face;
  spread(depth_slack(box, face), dot(row(box, face / 2), direction), slope_slack(box, face, direction),
         landing);
}

Root root_at(const BoxPrimitive& box, const Side& side, bool entering, const Local& ray, Vec3 direction) {
  const double steep = 1 / std::fabs(ray.direction[side.face / 2]);
  const double doubt = slope_slack(box, side.face, direction);
  const double slack = (depth_slack(box, side.face) + 2 * doubt * std::fabs(side.t)) * steep;
  return {side.t, side.error + slack, entering, doubt * steep > 0.5, static_cast<std::uint8_t>(side.face)};
}

Landings careful_landings(const BoxPrimitive& box, Vec3 origin, Vec3 direction) {
  Landings found = careful(box, origin, direction);
  for (Landing& landing : found.at) set_slack(box, direction, landing);
  return found;
}

/// The plane of a side, its normal to the upper side.
Planar plane_of(const BoxPrimitive& box, int face) {
  const int axis = face / 2;
  const double level = face % 2 == 0 ? box.lo[axis] : box.hi[axis];
  if (!box.aligned) return planar(row(box, axis), level, box.center);
  Vec3 at;
  at[axis] = level;
  return planar(row(box, axis), 0, at);
}

LANCER_FUSED bool land_fused(const BoxPrimitive& box, Vec3 origin, Vec3 direction, Landing& landing) {
  return land_by<Fused>(plane_of(box, landing.root.face), origin, direction, landing);
}
bool land_split(const BoxPrimitive& box, Vec3 origin, Vec3 direction, Landing& landing) {
  return land_by<Split>(plane_of(box, landing.root.face), origin, direction, landing);
}

/// Where no direction is in doubt and no two sides are near each other on the ray, which is nearly always.
Answer quick_test(const BoxPrimitive& box, const Local& ray, Side& enter, Side& leave) {
  double in[3], out[3], doubt[3];
  int first = 0, last = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis];
    if (std::fabs(d) <= 4 * ray.direction_error[axis]) return Answer::unknown;
    const double inverse = 1 / d;
    const double lower = (box.lo[axis] - ray.origin[axis]) * inverse;
    const double upper = (box.hi[axis] - ray.origin[axis]) * inverse;
    in[axis] = std::min(lower, upper);
    out[axis] = std::max(lower, upper);
    const double t = std::max(std::fabs(lower), std::fabs(upper));
    doubt[axis] = (ray.origin_error[axis] + t * ray.direction_error[axis]) * std::fabs(inverse) * (4.0 / 3) +
                  4 * k_u * t;
    if (in[axis] > in[first]) first = axis;
    if (out[axis] < out[last]) last = axis;
  }
  if (in[first] - doubt[first] > out[last] + doubt[last]) return Answer::no;
  if (!(in[first] + doubt[first] < out[last] - doubt[last])) return Answer::unknown;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis != first && !(in[axis] + doubt[axis] < in[first] - doubt[first])) return Answer::unknown;
    if (axis != last && !(out[axis] - doubt[axis] > out[last] + doubt[last])) return Answer::unknown;
  }
  enter = {in[first], doubt[first], 2 * first + (ray.direction[first] < 0 ? 1 : 0)};
  leave = {out[last], doubt[last], 2 * last + (ray.direction[last] > 0 ? 1 : 0)};
  return Answer::yes;
}

}  // namespace

Roots roots(const BoxPrimitive& box, const Probe& probe) {
  const Local ray = to_frame(box, probe.origin, probe.direction);
  Side in, out;
  Answer hits = quick_test(box, ray, in, out);
  if (hits == Answer::no) return {};
  if (hits == Answer::unknown) {
    const Clip clip(box, ray);
    hits = clip.hits();
    if (hits == Answer::no) return {};
    in = clip.enter();
    out = clip.leave();
    if (!clip.knows_faces()) hits = Answer::unknown;
  }
  if (hits == Answer::yes && knows_sign(in) && knows_sign(out)) {
    return {2,
            {root_at(box, in, true, ray, probe.direction), root_at(box, out, false, ray, probe.direction)}};
  }
  return careful_landings(box, probe.origin, probe.direction).roots();
}

Root exit(const BoxPrimitive& box, Vec3 origin, Vec3 direction) {
  const Local ray = to_frame(box, origin, direction);
  const Clip clip(box, ray);
  if (!clip.knows_faces()) {
    const Landings exactly = careful_landings(box, origin, direction);
    if (exactly.count == 2 && exactly.at[1].root.t > 0) return exactly.at[1].root;
  }
  Root leave = root_at(box, clip.leave(), false, ray, direction);
  leave.t = std::fmax(leave.t, 0);
  return leave;
}

Landing land(const BoxPrimitive& box, Vec3 origin, Vec3 direction, const Root& root) {
  Landing landing{root, 0, 0, {}, normal(box, root.face)};
  const bool settled =
      k_has_fused ? land_fused(box, origin, direction, landing) : land_split(box, origin, direction, landing);
  if (settled && landing.root.t > 0) {
    set_slack(box, direction, landing);
    return landing;
  }
  const Landings exactly = careful_landings(box, origin, direction);
  const Landing& found = exactly.at[root.entering ? 0 : 1];
  if (exactly.count == 2 && found.root.t > 0) {
    landing = found;
    snap(plane_of(box, landing.root.face), landing.point);
    return landing;
  }
  landing.root = root;
  set_slack(box, direction, landing);
  landing.point = project(box, origin + direction * root.t, root.face);
  return landing;
}

Vec3 normal(const BoxPrimitive& box, int face) {
  const Vec3 upper = box.aligned ? row(box, face / 2) : box.normals[static_cast<std::size_t>(face / 2)];
  return face % 2 == 0 ? -upper : upper;
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
  const Local at = to_frame(box, p, {});
  double out = -k_infinity, doubt = 0;
  for (int axis = 0; axis < 3; ++axis) {
    out = std::fmax(out, std::fmax(box.lo[axis] - at.origin[axis], at.origin[axis] - box.hi[axis]));
    doubt = std::fmax(doubt, at.origin_error[axis] + k_u * std::fabs(at.origin[axis]));
  }
  return std::fabs(out) > doubt || box.aligned ? out : careful_side(box, p);
}

}  // namespace lancer::tracer
