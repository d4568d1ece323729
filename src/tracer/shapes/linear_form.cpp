#include "tracer/shapes/linear_form.hpp"

#include <algorithm>
#include <limits>

namespace lancer::tracer {

void spread(double depth_slack, double slope, double slope_slack, Landing& landing) {
  const double t = landing.root.t;
  const double steep = std::fabs(slope);
  landing.spread(depth_slack / steep + 2 * k_u * std::fabs(t));
  const double least = steep + slope_slack, most = steep - slope_slack;
  if (most > 0) {
    landing.low -= std::fabs(t) * (slope_slack / least);
    landing.high += std::fabs(t) * (slope_slack / most);
  } else {
    // The ray may be parallel to the surface: all that is known is where it cannot yet have come near it.
    landing.low = std::min(std::max(0.0, std::fabs(t) * steep - depth_slack) / least, landing.low);
    landing.high = std::numeric_limits<double>::infinity();
  }
}

}  // namespace lancer::tracer
