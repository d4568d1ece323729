#pragma once
// Ways to test a ray against a sphere of any centre, and what they share with ellipsoids.

#include <vector>

#include "stress/harness.hpp"

namespace lancer::stress {

/// A root of a quadratic that a test took for the first hit.
struct Found {
  bool hit = false;
  bool entering = true;
  double t = 0;
};

/// The roots t0 <= t1 as the first one beyond `least`.
inline Found first_beyond(double t0, double t1, double least) {
  if (t0 > least) return {true, true, t0};
  if (t1 > least) return {true, false, t1};
  return {};
}

/// The smallest distance that counts as a hit, where a program has such a thing.
inline constexpr double k_epsilon = 1e-6;

/// b^2 - 4 a c, as in every textbook. f: from the centre to the start.
Found naive_quadratic(Vec3 f, Vec3 d, double radius, double least);
/// Hearn and Baker's discriminant, and roots without cancellation between them (Haines, Guenther,
/// Akenine-Moeller, Ray Tracing Gems, chapter 7).
Found gems_quadratic(Vec3 f, Vec3 d, double radius);

std::vector<Method> sphere_methods();

}  // namespace lancer::stress
