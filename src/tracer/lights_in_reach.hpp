#pragma once
// Lights that nothing in the scene would show.

#include <vector>

#include "tracer/extent.hpp"
#include "tracer/inventory.hpp"

namespace lancer::tracer {

/// Lights that shine on nothing: black ones, and spots with nothing in their cones (not looked for without an
/// extent). In order.
std::vector<scene::Index> dark_lights(const scene::Scene& scene, const Extent* extent);

/// The most that a ray can see of light that comes to surfaces with intensity 1: diffuse and specular at
/// their most, in all surfaces that it sees, one in another, to the depth.
double most_sent(const scene::Scene& scene, const Inventory& has, int depth);

}  // namespace lancer::tracer
