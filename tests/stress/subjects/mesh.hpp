#pragma once
// Closed meshes to shoot at.

#include "scene/scene.hpp"

namespace lancer::stress::flat {

/// 20 * 4^levels facets around the origin, corners on the unit sphere, convex, wound outwards, solid.
scene::Mesh icosphere(int levels);

}  // namespace lancer::stress::flat
