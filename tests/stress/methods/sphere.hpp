#pragma once
// Ways to test a ray against a sphere of any centre, and what they share with ellipsoids.

#include <vector>

#include "stress/methods/found.hpp"

namespace lancer::stress {

/// b^2 - 4 a c, as in every textbook. f: from the centre to the start.
Found naive_quadratic(Vec3 f, Vec3 d, double radius, double least);
/// Hearn and Baker's discriminant, and roots without cancellation between them (Haines, Guenther,
/// Akenine-Moeller, Ray Tracing Gems, chapter 7).
Found gems_quadratic(Vec3 f, Vec3 d, double radius);

std::vector<Method> sphere_methods();

}  // namespace lancer::stress
