#pragma once
// Vectors whose dot product all but cancels, far beyond twice the precision.

#include "stress/random.hpp"

namespace lancer::stress::flat {

/// Doubles n, some 2^52 long, and d, one long.
struct Across {
  Vec3 n, d;
};

/// n . d is `target` times some 2^-78, exactly.
Across all_but_orthogonal(Random& random, int target);

}  // namespace lancer::stress::flat
