#pragma once
// What the methods that meet facets and boxes are given and give: a ray, whether and where it hits, and what
// is reported of the hit.

#include <cmath>

#include "base/vec.hpp"

namespace lancer::stress::flat {

/// A ray with what tests want to know of it, worked out once.
struct Aim {
  Vec3 origin, direction;
  Vec3 inverse;
  int kx = 0, ky = 1, kz = 2;  // kz: the largest component of the direction
  double shear_x = 0, shear_y = 0, shear_z = 0;

  Aim() = default;
  Aim(Vec3 origin_in, Vec3 direction_in) : origin(origin_in), direction(direction_in) {
    inverse = {1 / direction.x, 1 / direction.y, 1 / direction.z};
    for (int axis = 0; axis < 3; ++axis) {
      if (std::fabs(direction[axis]) > std::fabs(direction[kz])) kz = axis;
    }
    kx = (kz + 1) % 3;
    ky = (kx + 1) % 3;
    shear_z = 1 / direction[kz];
    shear_x = direction[kx] / direction[kz];
    shear_y = direction[ky] / direction[kz];
  }
};

/// What a test says: the distance as an unevaluated sum, `low` 0 for all that work in plain arithmetic.
struct Answer {
  bool hit = false;
  double t = 0, low = 0;
  int face = 0;
};

/// What a hit is reported as.
struct Place {
  Vec3 point, normal;
};

}  // namespace lancer::stress::flat
