#pragma once
// A scene of every kind, for pictures at all scales and places.

#include <string>

#include "base/vec.hpp"

namespace lancer::stress {

/// About six units wide; each point p of it stands at p s + shift.
struct Standard {
  double s = 1;
  Vec3 shift;

  std::string text(int size) const;
  std::string point(double x, double y, double z) const;
};

}  // namespace lancer::stress
