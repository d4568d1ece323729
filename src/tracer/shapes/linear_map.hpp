#pragma once
// 3 x 3 matrices in rows, for shapes that are tested in a space of their own.

#include <array>

#include "tracer/numeric.hpp"

namespace lancer::tracer {

using Rows = std::array<Vec3, 3>;

inline Vec3 apply(const Rows& m, Vec3 v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }
inline Vec3 apply_transposed(const Rows& m, Vec3 v) { return m[0] * v.x + m[1] * v.y + m[2] * v.z; }
/// |M| |v|, component by component: what rounding errors of M v are multiples of.
inline Vec3 apply_abs(const Rows& m, Vec3 v) { return apply({abs(m[0]), abs(m[1]), abs(m[2])}, abs(v)); }

/// The inverse, each entry within an ulp as far as the determinant lets twice the precision tell.
Rows accurate_inverse(const Rows& m);

}  // namespace lancer::tracer
