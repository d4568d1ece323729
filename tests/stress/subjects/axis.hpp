#pragma once
// Directions along an axis but for next to nothing.

#include "stress/random.hpp"

namespace lancer::stress {

/// 0, -0 or up to 1e-310.
inline double almost_nothing(Random& random) {
  constexpr double k_values[] = {0.0, 0x1p-1074, 1e-320, 1e-310};
  const double side = random.sign();
  return side * k_values[random.below(4)];
}

/// +-1 along the axis, almost nothing along the others.
inline Vec3 along_axis(Random& random, int axis) {
  Vec3 v;
  for (int i = 0; i < 3; ++i) v[i] = i == axis ? random.sign() : almost_nothing(random);
  return v;
}

}  // namespace lancer::stress
