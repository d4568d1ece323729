#pragma once
// Solids of every kind to be made of glass, as parts of a script.

#include <string>
#include <vector>

#include "base/vec.hpp"

namespace lancer::stress {

/// About the origin, two units wide, without the closing brace.
struct Solid {
  std::string name, begin, turn;

  /// Scaled, moved and clad.
  std::string placed(double scale, Vec3 to, double ior) const;
};

const std::vector<Solid>& solids();

/// An opaque room with light that differs from place to place.
std::string room(int depth);

}  // namespace lancer::stress
