#pragma once
// Lights as a point of the scene sees them, shadows aside.

#include "scene/scene.hpp"

namespace lancer::tracer {

struct Incoming {
  Vec3 towards;         // the light, unit length
  double distance = 0;  // infinite for a sun
  Color intensity;      // colour times falloff and cone
};

/// Black for a light at p itself, and outside a spot's cone.
Incoming incoming(const scene::Light& light, Vec3 p);

}  // namespace lancer::tracer
