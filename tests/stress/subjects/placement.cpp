#include "stress/subjects/placement.hpp"

namespace lancer::stress::flat {

Affine turned(Random& random, double away) {
  const Affine turn = any_turn(random);
  return then(turn, translation(random.in_cube(away)));
}

Affine placement(double share, double away, double scale) {
  Affine map;
  if (share != 1) {
    map = then(scaling({1, 1, share}), rotation(Vec3{1, 2, 3}, 50));
  }
  if (away != 0) map = then(map, translation(normalize(Vec3{3, -2, 5}) * away));
  if (scale != 1) map = then(map, scaling({scale, scale, scale}));
  return map;
}

}  // namespace lancer::stress::flat
