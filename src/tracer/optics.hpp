#pragma once
// What light does at the boundary of two media.

#include <optional>

#include "base/vec.hpp"

namespace lancer::tracer {

/// The mirror direction of d at the normal n; both of unit length.
inline Vec3 mirrored(Vec3 d, Vec3 n) { return normalize(d - n * (2 * dot(d, n))); }

/// The direction after Snell's law, from index `from` to index `to`; n faces the ray, n . d < 0, both of unit
/// length. None under total reflection. Equal indices leave every bit of d as it was.
std::optional<Vec3> refracted(Vec3 d, Vec3 n, double from, double to);

/// The reflectance of unpolarised light between dielectrics, by Fresnel's formulas; 1 under total reflection,
/// 0 where the indices are equal.
double fresnel(Vec3 d, Vec3 n, double from, double to);

}  // namespace lancer::tracer
