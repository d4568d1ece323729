#pragma once
// Bodies of every kind for rays to leave and to arrive at, at all scales and places.

#include <string>

#include "base/transform.hpp"
#include "scene/scene.hpp"
#include "stress/contest/line.hpp"

namespace lancer::stress::flat {

enum class Body { sphere, plane, ellipsoid, box, mesh };

/// A body about one unit across, moved, then scaled.
struct Cell {
  Body body;
  double scale = 1, away = 0;

  std::string name() const;
  Affine map() const;
};

/// Larger by `grown` of its size on either side.
void add_body(scene::Scene& scene, const Cell& cell, double grown);

/// From three sizes away at a point within.
Line arriving(const Cell& cell, Random& random);

/// On the side of n that `sign` says, in half of the cases nearly along the surface.
Vec3 leaving(Vec3 n, double sign, Random& random);

/// Towards the middle of the body, from anywhere on it.
Vec3 inwards(const Cell& cell, Vec3 from, Vec3 n, Random& random);

}  // namespace lancer::stress::flat
