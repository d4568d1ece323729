#include "lang/geometry_checks.hpp"

#include <algorithm>
#include <cmath>

#include "base/double_double.hpp"

namespace lancer::lang {
namespace {

constexpr double k_half_ulp = 0x1p-53;

Vec3 magnitude(Vec3 v) { return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}; }

/// Brings the value's largest component into [1, 2).
UncertainVec scaled(const UncertainVec& v) {
  const int exponent = -std::ilogb(max_abs(v.value));
  return {times_power_of_two(v.value, exponent), times_power_of_two(v.error, exponent)};
}

/// a b - c d, rounded once but for a few 2^-105 of the larger product.
double difference_of_products(double a, double b, double c, double d) {
  const DoubleDouble difference = two_product(a, b) - two_product(c, d);
  return difference.hi + difference.lo;
}

}  // namespace

UncertainVec written_direction(Vec3 v) { return {v, magnitude(v) * k_half_ulp}; }

UncertainVec direction_between(Vec3 a, Vec3 b) {
  // Halved, so that the difference of two finite points is finite. Its own rounding is no larger than the
  // uncertainty of the points.
  const Vec3 from = a * 0.5, to = b * 0.5;
  return {to - from, (magnitude(from) + magnitude(to)) * (2 * k_half_ulp)};
}

bool are_parallel(const UncertainVec& a, const UncertainVec& b) {
  if (max_abs(a.value) == 0 || max_abs(b.value) == 0) return true;
  const UncertainVec p = scaled(a), q = scaled(b);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double cross = difference_of_products(p.value[j], q.value[k], p.value[k], q.value[j]);
    const double error = std::fabs(p.value[j]) * q.error[k] + p.error[j] * std::fabs(q.value[k]) +
                         std::fabs(p.value[k]) * q.error[j] + p.error[k] * std::fabs(q.value[j]);
    if (std::fabs(cross) > error) return false;
  }
  return true;
}

bool are_on_a_line(Vec3 a, Vec3 b, Vec3 c) {
  const UncertainVec ab = direction_between(a, b), ac = direction_between(a, c), bc = direction_between(b, c);
  return are_parallel(ab, ac) && are_parallel(ab, bc);
}

Vec3 scaled_to_one(Vec3 v) { return max_abs(v) == 0 ? v : times_power_of_two(v, -std::ilogb(max_abs(v))); }

Vec3 normal_of(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 p = scaled_to_one(b * 0.5 - a * 0.5), q = scaled_to_one(c * 0.5 - a * 0.5);
  Vec3 n;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    n[i] = difference_of_products(p[j], q[k], p[k], q[j]);
  }
  return scaled_to_one(n);
}

}  // namespace lancer::lang
