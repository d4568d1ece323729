#pragma once
// Is it flat? Questions about written points and directions that must not depend on the size of the scene: a
// figure counts as flat when it cannot be told from a flat one, each coordinate being off by half a unit in
// its last place, as decimal fractions are.

#include "base/vec.hpp"

namespace lancer::lang {

/// A direction and by how much, at most, each of its components may be off.
struct UncertainVec {
  Vec3 value;
  Vec3 error;
};

/// As written.
UncertainVec written_direction(Vec3 v);
/// From `a` to `b`, both as written.
UncertainVec direction_between(Vec3 a, Vec3 b);

/// Also where one of them is zero.
bool are_parallel(const UncertainVec& a, const UncertainVec& b);
/// Also where two of the points coincide.
bool are_on_a_line(Vec3 a, Vec3 b, Vec3 c);

/// `v` times the power of two that brings its largest component into [1, 2), exactly but for underflow.
Vec3 scaled_to_one(Vec3 v);

/// (b-a) x (c-a), of any length, free of overflow: the normal of points that are not on a line.
Vec3 normal_of(Vec3 a, Vec3 b, Vec3 c);

}  // namespace lancer::lang
