#pragma once
// Lights as a point of the scene sees them, shadows aside.

#include "scene/scene.hpp"

namespace lancer::tracer {

struct Incoming {
  Vec3 towards;         // the light, unit length
  double distance = 0;  // infinite for a sun
  Color intensity;      // colour times falloff and cone
};

/// The way from a point to a light.
struct Bearing {
  Vec3 towards;         // the light, unit length; zero for a light at the point itself
  double distance = 0;  // infinite for a sun
};

Bearing bearing(const scene::Light& light, Vec3 p);
/// Colour times falloff and cone, for a point with that bearing of the light.
Color intensity(const scene::Light& light, const Bearing& from);

/// Both. Black for a light at p itself, and outside a spot's cone.
Incoming incoming(const scene::Light& light, Vec3 p);

}  // namespace lancer::tracer
