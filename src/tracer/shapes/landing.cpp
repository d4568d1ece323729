#include "tracer/shapes/newton.hpp"

namespace lancer::tracer {
namespace {

/// a.hi + a.lo over b, rounded.
double quotient(DoubleDouble a, DoubleDouble b) {
  const double q = a.hi / b.hi;
  const DoubleDouble product = two_product(q, b.hi);
  const double rest = ((a.hi - product.hi) - product.lo) + (a.lo - q * b.lo);
  return q + rest / b.hi;
}

}  // namespace

Span Landing::span() const {
  const double far = std::fabs(root.t);
  if (tilt < 1) return {root.error + far * tilt / (1 + tilt), root.error + far * tilt / (1 - tilt)};
  // The ray may be parallel to the surface: all that is known is where it cannot yet have come near it.
  const double nearest = std::fmax(0, far - root.error) / (1 + tilt);
  return {std::fmax(root.t - nearest, root.error), k_infinity};
}

Triple2 near_one(const Triple2& v) {
  const double size = max_abs(rounded(v));
  if (!(size > 0)) return v;
  const int exponent = std::ilogb(size);
  Triple2 scaled;
  for (std::size_t i = 0; i < 3; ++i)
    scaled[i] = {std::scalbn(v[i].hi, -exponent), std::scalbn(v[i].lo, -exponent)};
  return scaled;
}

Vec3 unit(const Triple2& v) {
  const Triple2 n = near_one(v);
  Accurate square;
  for (const DoubleDouble& x : n) {
    square.add_product(x.hi, x.hi);
    square.add_small(2 * x.hi * x.lo);
  }
  const DoubleDouble length = sqrt(square.sum());
  return {quotient(n[0], length), quotient(n[1], length), quotient(n[2], length)};
}

void snap_across(const Planar& plane, int axis, Vec3& point) {
  const DoubleDouble off = DoubleDouble{plane.level, 0} / DoubleDouble{plane.n[axis], 0};
  point[axis] = plane.level == 0 ? plane.at[axis] : (plane.at[axis] + off).hi;
}

}  // namespace lancer::tracer
