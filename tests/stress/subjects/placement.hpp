#pragma once
// Ways to put a thing somewhere else: turned, thin, far away and scaled.

#include "base/transform.hpp"
#include "stress/random.hpp"

namespace lancer::stress {

/// About each axis by any angle.
inline Affine any_turn(Random& random) { return rotation(random.in_cube(180)); }

}  // namespace lancer::stress

namespace lancer::stress::flat {

/// Turned, and moved by up to `away`.
Affine turned(Random& random, double away);

/// As thin as `share`, then turned, moved by `away` of its size, and scaled.
Affine placement(double share, double away, double scale);

/// The point itself where nothing is moved, without rounding.
inline Vec3 placed(const Affine& map, Vec3 p) { return is_identity(map) ? p : map.point(p); }

}  // namespace lancer::stress::flat
