#include "base/vec.hpp"

namespace lancer {
namespace {

/// `a` divided by the power of two that brings its largest component into [1, 2); `exponent` is that power.
Vec3 scaled(Vec3 a, int& exponent) {
  exponent = std::ilogb(max_abs(a));
  return times_power_of_two(a, -exponent);
}

/// Neither zero nor beyond what numbers hold.
bool is_scalable(Vec3 a) { return max_abs(a) != 0 && is_finite(a); }

}  // namespace

double scaled_length(Vec3 a) {
  if (!is_scalable(a)) return std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z);  // 0, infinite or NaN
  int exponent = 0;
  const Vec3 s = scaled(a, exponent);
  return std::scalbn(std::sqrt(dot(s, s)), exponent);
}

Vec3 scaled_normalize(Vec3 a) {
  if (!is_scalable(a)) return a;
  int exponent = 0;
  const Vec3 s = scaled(a, exponent);
  return s / std::sqrt(dot(s, s));
}

}  // namespace lancer
