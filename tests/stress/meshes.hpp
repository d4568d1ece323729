#pragma once
// Closed meshes to shoot at.

#include <string>

#include "base/transform.hpp"
#include "scene/scene.hpp"

namespace lancer::stress::flat {

/// 20 * 4^levels facets around the origin, corners on the unit sphere, convex, wound outwards, solid.
scene::Mesh icosphere(int levels);

/// As thin as `share`, then turned, moved by `away` of its size, and scaled.
Affine placement(double share, double away, double scale);

}  // namespace lancer::stress::flat
