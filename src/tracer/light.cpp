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

Bearing bearing(const scene::Light& light, Vec3 p) {
  if (light.kind == scene::LightKind::sun) {
    return {-normalize(light.direction), std::numeric_limits<double>::infinity()};
  }
  const Vec3 way = light.at - p;
  const double distance = length(way);
  return distance == 0 ? Bearing{} : Bearing{normalize(way), distance};
}

Color intensity(const scene::Light& light, const Bearing& from) {
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
  return {std::fmin(out.r, k_most), std::fmin(out.g, k_most), std::fmin(out.b, k_most)};
}

}  // namespace lancer::tracer
