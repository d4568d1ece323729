#pragma once
// Rounding, made visible: error-free sums and products, and the bounds that every intersection carries.
// Nothing here, nor anything that builds on it, knows a constant with the dimension of a length: all bounds
// are multiples of the unit roundoff times a quantity of the scene.

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/double_double.hpp"
#include "base/vec.hpp"

namespace lancer::tracer {

/// The unit roundoff of a double.
inline constexpr double k_u = 0x1p-53;
inline constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// The bound of the relative error of n rounded operations (Higham, Accuracy and Stability, section 3.1).
constexpr double gamma(int n) { return n * k_u / (1 - n * k_u); }

/// a b - c d within 1.5 ulp and of exact sign (Kahan; Jeannerod, Louvet, Muller 2013).
inline double difference_of_products(double a, double b, double c, double d) {
  const double cd = c * d;
  const double error = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + error;
}

/// A running sum of doubles and products as if in twice the precision (Ogita, Rump, Oishi: Dot2).
class Accurate {
 public:
  void add(double value) {
    const DoubleDouble sum = two_sum(high_, value);
    high_ = sum.hi;
    low_ += sum.lo;
  }
  void add_product(double a, double b) {
    const DoubleDouble product = two_product(a, b);
    add(product.hi);
    low_ += product.lo;
  }
  /// For terms far below the sum's own rounding.
  void add_small(double value) { low_ += value; }
  double value() const { return high_ + low_; }
  DoubleDouble sum() const { return two_sum(high_, low_); }

 private:
  double high_ = 0, low_ = 0;
};

/// a x b, each component within 1.5 ulp.
inline Vec3 accurate_cross(Vec3 a, Vec3 b) {
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

inline Vec3 abs(Vec3 a) { return {std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}; }
/// As max_abs, for numbers that are none of them NaN: one instruction a comparison.
inline double largest(Vec3 a) { return std::max(std::fabs(a.x), std::max(std::fabs(a.y), std::fabs(a.z))); }
inline double sum_abs(Vec3 a) { return std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z); }

}  // namespace lancer::tracer
