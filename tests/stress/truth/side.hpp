#pragma once
// On which side of a surface a point lies, by exact signs.

#include "tracer/world.hpp"

namespace lancer::stress::flat {

/// -1: within the world's first primitive, or behind it where it is a plane; 0: exactly on it; 1: outside.
/// 0 too for a facet, which has no inside.
int true_side(const tracer::World& world, Vec3 p);

}  // namespace lancer::stress::flat
