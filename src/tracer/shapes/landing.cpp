#include "tracer/shapes/landing.hpp"

namespace lancer::tracer {
namespace {

/// The exponents within which squares and what rounding leaves of them neither over- nor underflow.
constexpr int k_safe_exponent = 400;

/// a.hi + a.lo over b, rounded.
double quotient(DoubleDouble a, DoubleDouble b) {
  const double q = a.hi / b.hi;
  const DoubleDouble product = two_product(q, b.hi);
  const double rest = ((a.hi - product.hi) - product.lo) + (a.lo - q * b.lo);
  return q + rest / b.hi;
}

Triple2 near_one(const Triple2& v) {
  const int exponent = std::ilogb(max_abs(rounded(v)));
  if (exponent > -k_safe_exponent && exponent < k_safe_exponent) return v;
  Triple2 scaled;
  for (std::size_t i = 0; i < 3; ++i)
    scaled[i] = {std::scalbn(v[i].hi, -exponent), std::scalbn(v[i].lo, -exponent)};
  return scaled;
}

}  // namespace

bool settles(Vec3 value, Vec3 error) {
  const double least = max_abs(value) * 0x1p-40;
  for (int i = 0; i < 3; ++i) {
    if (!(error[i] <= std::fmax(std::fabs(value[i]), least) * (k_u / 16))) return false;
  }
  return true;
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

}  // namespace lancer::tracer
