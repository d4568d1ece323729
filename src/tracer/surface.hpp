#pragma once
// A hit made ready for shading: colours at the point, and the normal that faces the ray.

#include "tracer/intersect.hpp"

namespace lancer::tracer {

struct Surface {
  Vec3 normal;  // unit length, smooth where the shape is, turned to face the ray
  Color ambient, diffuse, specular, reflection, transmission;
  double shininess = 1;
  bool fresnel = false;
};

Surface surface_at(const World& world, const Ray& ray, const Hit& hit);

}  // namespace lancer::tracer
