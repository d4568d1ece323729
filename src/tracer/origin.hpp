#pragma once
// Where the world's own space starts. Far from the scene's origin the coordinates of doubles are coarse, and
// what a ray meets on its way from mirror to mirror with them; next to the eye they are not.

#include "scene/scene.hpp"

namespace lancer::tracer {

/// The eye, on each axis along which everything that has a place there lies between half and twice as far as
/// it: then a - b is exact (Sterbenz, Floating-Point Computation, 1974), so that the move rounds nothing. On
/// others 0: what lies there is as large as it is far.
Vec3 world_origin(const scene::Scene& scene, Vec3 eye);

}  // namespace lancer::tracer
