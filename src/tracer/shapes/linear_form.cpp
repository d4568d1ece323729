#include "tracer/shapes/linear_form.hpp"

#include <algorithm>
#include <limits>

namespace lancer::tracer {

Root crossing(Bounded depth, Bounded slope, double doubt, bool entering) {
  const double t = depth.value / slope.value;
  const double steep = std::fabs(slope.value);
  const double error = (depth.error + std::fabs(t) * slope.error) / steep + 2 * k_u * std::fabs(t);
  const double least = steep + slope.error + doubt;
  const double most = steep - slope.error - doubt;
  if (!(most > 0)) {
    // The ray may be parallel to the surface: all that is known is where it cannot yet have come near it.
    const double low = std::max(0.0, std::fabs(depth.value) - depth.error) / least;
    return {t, error, std::min(low, t - error), std::numeric_limits<double>::infinity(), entering, 0};
  }
  const double nearest = t - error - std::fabs(t) * (doubt / least);
  return {t, error, nearest, t + error + std::fabs(t) * (doubt / most), entering, 0};
}

}  // namespace lancer::tracer
