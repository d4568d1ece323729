#pragma once
// From a shape in its own space to primitives in the world.

#include <cstdint>

namespace lancer::tracer {

struct World;

/// Appends the primitives of Scene::shapes[shape].
void add_primitives(World& world, std::uint32_t shape);

}  // namespace lancer::tracer
