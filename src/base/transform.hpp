#pragma once
// Affine maps of space, p -> M p + t, and pairs of such a map with its inverse.

#include <array>
#include <optional>

#include "base/vec.hpp"

namespace lancer {

/// A point to twice the precision of a double: at + rest, the rest below the last bits of `at`.
struct Place {
  Vec3 at, rest;

  /// The way here from `origin`; its `at` is that rounded once.
  Place from(Vec3 origin) const;
};

/// p -> M p + t, M in rows.
struct Affine {
  std::array<Vec3, 3> rows = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 translation;
  Vec3 rest{};  // of the translation, below its last bits: what rounding would take from far moves

  friend bool operator==(const Affine&, const Affine&) = default;
  Vec3 vector(Vec3 v) const { return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)}; }
  Vec3 point(Vec3 p) const { return vector(p) + translation; }
  Place place(const Place& p) const;
  /// M^T v: how normals travel when called on the inverse map.
  Vec3 transposed(Vec3 v) const { return rows[0] * v.x + rows[1] * v.y + rows[2] * v.z; }
};

/// The rows divided by the power of two that brings their largest entry into [1, 2); `exponent` is that
/// power. Not all of them are 0.
std::array<Vec3, 3> near_one(const std::array<Vec3, 3>& rows, int& exponent);

bool is_identity(const Affine& a);
bool is_finite(const Affine& a);
double determinant(const Affine& a);

/// The map that applies `first`, then `second`.
Affine then(const Affine& first, const Affine& second);

Affine translation(Vec3 offset);
Affine scaling(Vec3 factors);
/// About x by angles.x, then about y, then about z, right-handed, in degrees; exact for multiples of 90.
Affine rotation(Vec3 angles);
/// About `axis` (any length but zero), right-handed, in degrees.
Affine rotation(Vec3 axis, double angle);

/// The inverse; nothing when it does not exist or is not finite.
std::optional<Affine> inverse(const Affine& a);

/// A map of an object's own space to the world, with its inverse.
struct Transform {
  Affine to_world;
  Affine to_object;

  Vec3 normal_to_world(Vec3 n) const { return to_object.transposed(n); }
};

}  // namespace lancer
