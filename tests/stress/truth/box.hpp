#pragma once
// The truth about a ray and a box: hit or miss and which side by exact signs, everything else in MPFR.

#include <array>

#include "stress/truth/facet.hpp"
#include "tracer/shapes/box.hpp"

namespace lancer::stress::flat {

/// The points x with lo <= x <= hi, or, where it is turned, those with lo_i <= to_own_i . (x - center) <=
/// hi_i.
struct BoxNumbers {
  Vec3 lo, hi;
  bool turned = false;
  Vec3 center;
  std::array<Vec3, 3> to_own{};
};
inline BoxNumbers numbers_of(const tracer::BoxPrimitive& b) {
  return {b.lo, b.hi, !b.aligned, b.center, b.to_own};
}

/// Rays through edges and corners hit, and so do such as lie in a side's plane. Of two sides that are met at
/// exactly the same distance, that of the lower axis. What lies at the start or behind it is not met; from
/// inside, the way out is.
Truth box_truth(const BoxNumbers& box, Vec3 origin, Vec3 direction);

/// Where the line of the ray leaves the box, ahead of its start, wherever that lies.
Truth box_way_out(const BoxNumbers& box, Vec3 origin, Vec3 direction);

/// Might the ray do otherwise, were each number of the ray and the box off by up to 4 ulp?
bool box_in_band(const BoxNumbers& box, Vec3 origin, Vec3 direction);

}  // namespace lancer::stress::flat
