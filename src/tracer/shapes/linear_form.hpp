#pragma once
// n . v with a bound of its error: plain arithmetic where that is good enough, twice the precision where
// terms cancel.

#include <cstdint>

#include "tracer/numeric.hpp"
#include "tracer/shapes/landing.hpp"

namespace lancer::tracer {

/// What a bound lets tell.
enum class Answer : std::uint8_t { no, yes, unknown };

struct Bounded {
  double value = 0, error = 0;
};

inline bool knows_sign(const Bounded& value) {
  return std::fabs(value.value) > value.error || value.error == 0;
}

/// depth / slope.
inline Root crossing(Bounded depth, Bounded slope, bool entering) {
  const double inverse = 1 / slope.value;
  const double t = depth.value * inverse;
  const double steep = std::fabs(inverse);
  const double error = (depth.error + 2 * std::fabs(t) * slope.error) * steep + 4 * k_u * std::fabs(t);
  return {t, error, entering, slope.error * steep > 0.5};
}

/// The bounds of a landing on a plane that may be off by `depth_slack` where the ray starts, and whose slope
/// may be off by `slope_slack`.
inline void set_bounds(double depth_slack, double slope, double slope_slack, Landing& landing) {
  landing.root.error = 2 * k_u * std::fabs(landing.root.t);
  if (depth_slack == 0 && slope_slack == 0) return;
  const double steep = std::fabs(1 / slope);
  landing.root.error = depth_slack * steep + 2 * k_u * std::fabs(landing.root.t);
  landing.tilt = slope_slack * steep;
}

/// n . d.
inline Bounded bounded_dot(Vec3 n, Vec3 d) {
  const Vec3 terms{n.x * d.x, n.y * d.y, n.z * d.z};
  const double plain = terms.x + terms.y + terms.z;
  const double magnitude = sum_abs(terms);
  if (std::fabs(plain) >= magnitude * 0.25) return {plain, 3 * k_u * magnitude};
  Accurate sum;
  for (int axis = 0; axis < 3; ++axis) sum.add_product(n[axis], d[axis]);
  return {sum.value(), 2 * k_u * std::fabs(sum.value()) + 16 * k_u * k_u * magnitude};
}

/// level - n . (p - from).
inline Bounded bounded_depth(double level, Vec3 n, Vec3 p, Vec3 from) {
  const Vec3 offset = p - from;
  const Vec3 terms{n.x * offset.x, n.y * offset.y, n.z * offset.z};
  const double plain = level - (terms.x + terms.y + terms.z);
  const double magnitude = sum_abs(terms) + std::fabs(level);
  if (std::fabs(plain) >= magnitude * 0.25) return {plain, 5 * k_u * magnitude};
  Accurate sum;
  sum.add(level);
  for (int axis = 0; axis < 3; ++axis) {
    const DoubleDouble exact = two_sum(p[axis], -from[axis]);
    sum.add_product(-n[axis], exact.hi);
    sum.add_small(-n[axis] * exact.lo);
  }
  return {sum.value(), 2 * k_u * std::fabs(sum.value()) + 32 * k_u * k_u * magnitude};
}

}  // namespace lancer::tracer
