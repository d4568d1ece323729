#pragma once
// Scenes with a bit of everything, drawn by lot: what a skip gets wrong anywhere shows in some of them.

#include "build.hpp"

namespace lancer::tracer::test {

/// The scene of a seed. Opaque, mirroring and clear materials, patterns in every coefficient, coefficients
/// and lights that are black, spots, suns, falloff, shapes that cast no shadow, transforms; the settings and
/// what kinds of thing there are vary with the seed, so that each skip has scenes in which it applies.
Scene random_scene(std::uint64_t seed);

/// Looks at the scene from outside, or from among its things.
scene::View random_view(std::uint64_t seed, int columns, int rows);

}  // namespace lancer::tracer::test
