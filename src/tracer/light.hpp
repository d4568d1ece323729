#pragma once
// Lights as a point of the scene sees them, shadows aside.

#include "scene/scene.hpp"

namespace lancer::tracer {

/// The way from a point to a light.
struct Bearing {
  Vec3 towards;         // the light, unit length; zero for a light at the point itself
  double distance = 0;  // infinite for a sun
};

Bearing bearing(const scene::Light& light, Vec3 p);
/// Colour times falloff and cone, for a point with that bearing of the light.
/// Black for a light at the point itself, and outside a spot's cone.
Color intensity(const scene::Light& light, const Bearing& from);

/// Does it grow weaker with the distance?
inline bool fades(const scene::Light& light) {
  return light.kind != scene::LightKind::sun && light.falloff > 0;
}

}  // namespace lancer::tracer
