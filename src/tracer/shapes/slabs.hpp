#pragma once
// The slab test of a box in full: with a bound for each side on its own, and for rays that may or may not be
// parallel to a pair of sides. The quick test of box.cpp leaves few rays to it.

#include <algorithm>

#include "tracer/shapes/box.hpp"
#include "tracer/shapes/linear_form.hpp"

namespace lancer::tracer {

/// A ray in the frame of the test, with bounds of what each component is off.
struct Local {
  Vec3 origin, direction;
  Vec3 origin_error, direction_error;
};

inline Local to_frame(const BoxPrimitive& box, Vec3 origin, Vec3 direction) {
  if (box.aligned) return {origin, direction, {}, {}};
  const Vec3 offset = origin - box.center;
  return {apply(box.to_own, offset), apply(box.to_own, direction), box.reach * (6 * k_u * largest(offset)),
          box.reach * (4 * k_u)};
}

inline Vec3 row(const BoxPrimitive& box, int axis) {
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

inline Side side_crossing(const BoxPrimitive& box, const Local& ray, int axis, bool upper) {
  const double gap = (upper ? box.hi[axis] : box.lo[axis]) - ray.origin[axis];
  const double t = gap / ray.direction[axis];
  const double moved = (ray.origin_error[axis] + std::fabs(t) * ray.direction_error[axis]) * (4.0 / 3);
  return {t, moved / std::fabs(ray.direction[axis]) + 2 * k_u * std::fabs(t), 2 * axis + (upper ? 1 : 0)};
}

/// The part of a ray inside the box, by its sides, and what is known of it, with a bound for each side.
class Clip {
 public:
  Clip(const BoxPrimitive& box, const Local& ray) : box_(box), ray_(ray) {
    for (int axis = 0; axis < 3; ++axis) {
      // A direction that may point either way across a pair of sides is left for the end.
      if (is_doubtful(axis)) continue;
      const bool upwards = ray.direction[axis] > 0;
      in_[count_] = side_crossing(box, ray, axis, !upwards);
      out_[count_] = side_crossing(box, ray, axis, upwards);
      if (in_[count_].t > in_[first_].t) first_ = count_;
      if (out_[count_].t < out_[last_].t) last_ = count_;
      ++count_;
    }
  }

  const Side& enter() const { return in_[first_]; }
  const Side& leave() const { return out_[last_]; }

  /// Is the ray inside the box anywhere on its line?
  Answer hits() const {
    if (enter().t - enter().error > leave().t + leave().error) return Answer::no;
    Answer answer = enter().t + enter().error < leave().t - leave().error ? Answer::yes : Answer::unknown;
    for (int axis = 0; axis < 3; ++axis) {
      if (!is_doubtful(axis)) continue;
      const Answer within = stays_within(axis);
      if (within == Answer::no) return within;
      if (within == Answer::unknown) answer = within;
    }
    return answer;
  }

  /// Is it certain through which sides?
  bool knows_faces() const {
    for (int i = 0; i < count_; ++i) {
      if (i != first_ && !(in_[i].t + in_[i].error < enter().t - enter().error)) return false;
      if (i != last_ && !(out_[i].t - out_[i].error > leave().t + leave().error)) return false;
    }
    return true;
  }

 private:
  bool is_doubtful(int axis) const {
    return std::fabs(ray_.direction[axis]) <= 4 * ray_.direction_error[axis];
  }

  /// Between the other sides, along a direction that is all but parallel to the sides of `axis`?
  Answer stays_within(int axis) const {
    const double farthest =
        std::max(std::fabs(enter().t) + enter().error, std::fabs(leave().t) + leave().error);
    const double drift = (std::fabs(ray_.direction[axis]) + ray_.direction_error[axis]) * farthest;
    const double doubt = ray_.origin_error[axis] + drift * (1 + 4 * k_u);
    const double at = ray_.origin[axis], lo = box_.lo[axis], hi = box_.hi[axis];
    if (at < lo - doubt || at > hi + doubt) return Answer::no;
    return at >= lo + doubt && at <= hi - doubt ? Answer::yes : Answer::unknown;
  }

  const BoxPrimitive& box_;
  const Local& ray_;
  Side in_[3], out_[3];
  int count_ = 0, first_ = 0, last_ = 0;
};

}  // namespace lancer::tracer
