#pragma once
// Lights that nothing in the scene would show.

#include <vector>

#include "tracer/extent.hpp"
#include "tracer/inventory.hpp"

namespace lancer::tracer {

/// Lights that shine on nothing: black ones, and spots with nothing in their cones (not looked for without an
/// extent). In order.
std::vector<scene::Index> dark_lights(const scene::Scene& scene, const Extent* extent);

/// Lights with falloff so far from all surfaces that together they add less than `allowed` to what a ray
/// sees, surfaces in surfaces to the depth included. In order.
std::vector<scene::Index> faint_lights(const scene::Scene& scene, const Inventory& has, const Extent& extent,
                                       int depth, double allowed);

}  // namespace lancer::tracer
