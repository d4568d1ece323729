#include "tracer/shapes/planar.hpp"

namespace lancer::tracer {
namespace {

/// What the equation leaves at a distance along the ray: level - n . (origin + t direction - at).
double residual(const Planar& plane, const Triple2& from, Vec3 direction, DoubleDouble t) {
  Accurate sum;
  sum.add(plane.level);
  for (std::size_t i = 0; i < 3; ++i) {
    const DoubleDouble& n = plane.n[i];
    const DoubleDouble w = advance(from[i], direction[static_cast<int>(i)], t);
    sum.add_product(-n.hi, w.hi);
    sum.add_small(-(n.hi * w.lo + n.lo * w.hi));
  }
  return sum.value();
}

/// The distance near t at which the residual vanishes.
Distance solve(const Planar& plane, const Triple2& from, Vec3 direction, double t) {
  const Vec3 n = rounded(plane.n);
  const double slope = dot(n, direction);
  const double terms = dot(plane.n_terms, abs(direction));
  const double doubt = 4 * k_u * terms / std::fabs(slope);  // relative, of the slope
  Distance at{{t, 0}, 0};
  for (int step = 0; step < 3; ++step) {
    const double correction = residual(plane, from, direction, at.t) / slope;
    at.t = at.t + correction;
    const double unknown = 32 * k_u * k_u / std::fabs(slope) *
                           (std::fabs(plane.level) + dot(plane.n_terms, abs(rounded(from))) +
                            terms * (std::fabs(at.t.hi) + std::fabs(correction)));
    const double left = std::fabs(correction) * (doubt + 2 * k_u);
    at.error = unknown + left;
    if (left <= unknown) break;
  }
  return at;
}

}  // namespace

bool land(const Planar& plane, Vec3 origin, Vec3 direction, double t, Landing& landing) {
  const Triple2 from = exact_difference(origin, plane.at);
  const Distance distance = solve(plane, from, direction, t);
  if (!settles(distance)) return false;
  const Triple2 start{DoubleDouble{origin.x, 0}, DoubleDouble{origin.y, 0}, DoubleDouble{origin.z, 0}};
  landing.point = rounded(advance(start, direction, distance.t));
  Vec3 error = advance_error(origin, direction, distance);
  for (int i = 0; i < 3; ++i) {
    if (plane.n_terms[(i + 1) % 3] == 0 && plane.n_terms[(i + 2) % 3] == 0) error[i] = 0;
  }
  if (!settles(landing.point, error)) return false;
  snap(plane, landing.point);
  landing.root.t = distance.t.hi;
  landing.normal = unit(plane.n);
  return true;
}

void snap(const Planar& plane, Vec3& point) {
  for (int i = 0; i < 3; ++i) {
    if (plane.n_terms[(i + 1) % 3] != 0 || plane.n_terms[(i + 2) % 3] != 0) continue;
    const DoubleDouble n = plane.n[static_cast<std::size_t>(i)];
    point[i] = plane.level == 0 ? plane.at[i] : (plane.at[i] + DoubleDouble{plane.level, 0} / n).hi;
  }
}

}  // namespace lancer::tracer
