#pragma once
// A hit made ready for shading: colours at the point, and the normal that faces the ray.

#include "tracer/intersect.hpp"
#include "tracer/plan.hpp"

namespace lancer::tracer {

struct Surface {
  Vec3 normal;  // unit length, smooth where the shape is, turned to face the ray
  Color ambient, diffuse, specular, reflection, transmission;
  double shininess = 1;
  bool fresnel = false;
};

/// Only the colours that are needed are worked out, the last two only where rays go on (`follow`); others are
/// black where they depend on the point.
Surface surface_at(const World& world, const MaterialNeeds& needs, const Ray& ray, const Hit& hit,
                   bool follow, Stats& stats);

}  // namespace lancer::tracer
