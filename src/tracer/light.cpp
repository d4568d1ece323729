#include "tracer/light.hpp"

#include <cmath>

#include "base/math.hpp"
#include "tracer/numeric.hpp"

namespace lancer::tracer {

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

}  // namespace lancer::tracer
