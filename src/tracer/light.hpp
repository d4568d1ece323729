#pragma once
// Lights as a point of the scene sees them, shadows aside.

#include <limits>

#include "scene/scene.hpp"

namespace lancer::tracer {

/// The way from a point to a light.
struct Bearing {
  Vec3 towards;         // the light, unit length; zero for a light at the point itself
  double distance = 0;  // infinite for a sun
};

inline Bearing bearing(const scene::Light& light, Vec3 p) {
  if (light.kind == scene::LightKind::sun) {
    return {-normalize(light.direction), std::numeric_limits<double>::infinity()};
  }
  const Vec3 way = light.at - p;
  const double distance = length(way);
  return distance == 0 ? Bearing{} : Bearing{normalize(way), distance};
}

/// Does it grow weaker with the distance?
inline bool fades(const scene::Light& light) {
  return light.kind != scene::LightKind::sun && light.falloff > 0;
}

/// Of a spot: 1 within the half-angle a (1-s) / 2 of the axis, 0 beyond a / 2, the smoothstep of the angle in
/// between.
double cone(const scene::Light& light, Vec3 towards);

/// Colour times falloff and cone, for a point with that bearing of the light.
/// Black for a light at the point itself, and outside a spot's cone.
inline Color intensity(const scene::Light& light, const Bearing& from) {
  if (light.kind == scene::LightKind::sun) return light.color;
  if (from.distance == 0) return {};
  Color out = light.color;
  if (fades(light)) {
    const double ratio = light.falloff / from.distance;
    out = out * (ratio * ratio);
  }
  if (light.kind == scene::LightKind::spot) out = out * cone(light, from.towards);
  // Beyond what numbers hold, so that a surface that sends nothing back does so here too.
  constexpr double k_most = std::numeric_limits<double>::max();
  const auto limited = [](double level) { return level < k_most ? level : k_most; };
  return {limited(out.r), limited(out.g), limited(out.b)};
}

}  // namespace lancer::tracer
