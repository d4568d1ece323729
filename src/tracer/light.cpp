#include "tracer/light.hpp"

#include <cmath>
#include <limits>

#include "base/math.hpp"
#include "tracer/numeric.hpp"

namespace lancer::tracer {
namespace {

/// 1 within the half-angle a (1-s) / 2 of the axis, 0 beyond a / 2, the smoothstep of the angle in between.
double cone(const scene::Light& light, Vec3 towards) {
  const double outer = light.angle / 2;
  const double inner = light.angle * (1 - light.softness) / 2;
  const Vec3 axis = normalize(light.direction);
  const double cosine = -dot(axis, towards);
  // Most points are clearly in or out, and spared the angle itself.
  constexpr double k_margin = 8 * k_u;
  if (cosine < math::cos_deg(outer) - k_margin) return 0;
  if (cosine > math::cos_deg(inner) + k_margin) return 1;
  const double angle = math::atan2_deg(length(accurate_cross(axis, towards)), cosine);
  if (angle <= inner) return 1;
  if (angle >= outer) return angle > outer || light.softness > 0 ? 0 : 1;
  const double x = (outer - angle) / (outer - inner);
  return x * x * (3 - 2 * x);
}

}  // namespace

Incoming incoming(const scene::Light& light, Vec3 p) {
  if (light.kind == scene::LightKind::sun) {
    return {-normalize(light.direction), std::numeric_limits<double>::infinity(), light.color};
  }
  const Vec3 way = light.at - p;
  const double distance = length(way);
  if (distance == 0) return {};
  Incoming in{normalize(way), distance, light.color};
  if (light.falloff > 0) {
    const double ratio = light.falloff / distance;
    in.intensity = in.intensity * (ratio * ratio);
  }
  if (light.kind == scene::LightKind::spot) in.intensity = in.intensity * cone(light, in.towards);
  // Beyond what numbers hold, so that a surface that sends nothing back does so here too.
  constexpr double k_most = std::numeric_limits<double>::max();
  in.intensity = {std::fmin(in.intensity.r, k_most), std::fmin(in.intensity.g, k_most),
                  std::fmin(in.intensity.b, k_most)};
  return in;
}

}  // namespace lancer::tracer
