#pragma once
// The hard rays for spheres and for ellipsoids, made where the solid is the unit ball and carried into the
// world by the map that makes the solid of it.

#include <functional>
#include <string>
#include <vector>

#include "stress/contest/harness.hpp"

namespace lancer::stress {

/// A solid that is to be met.
struct Placed {
  Affine to_world;  // of the unit ball
  Affine to_ball;
  double size = 1;  // the largest half axis
};

/// How large, and how far from the origin in sizes.
struct Placing {
  double least = 1, most = 1;
  double moved = 0;
  bool whole =
      false;  // its axes along those of the world, all of its numbers small whole ones or powers of two
};

/// What differs between the kinds: adding the solid to a scene, somewhere at random.
struct RoundKind {
  std::string name;  // "sphere"
  std::function<Placed(Random&, scene::Scene&, const Placing&)> add;
};

/// Adds the rows of the kind.
void add_round_rows(Rows& rows, const RoundKind& kind, const std::vector<Method>& methods,
                    const Oracle& oracle);

}  // namespace lancer::stress
