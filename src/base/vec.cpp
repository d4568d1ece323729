#include "base/vec.hpp"

namespace lancer {
namespace {

/// `a` divided by the power of two that brings its largest component into [1, 2); `exponent` is that power.
Vec3 scaled(Vec3 a, int& exponent) {
  exponent = std::ilogb(max_abs(a));
  return {std::scalbn(a.x, -exponent), std::scalbn(a.y, -exponent), std::scalbn(a.z, -exponent)};
}

}  // namespace

double length(Vec3 a) {
  if (max_abs(a) == 0) return 0;
  int exponent = 0;
  const Vec3 s = scaled(a, exponent);
  return std::scalbn(std::sqrt(dot(s, s)), exponent);
}

Vec3 normalize(Vec3 a) {
  if (max_abs(a) == 0) return a;
  int exponent = 0;
  const Vec3 s = scaled(a, exponent);
  return s / std::sqrt(dot(s, s));
}

}  // namespace lancer
