// Trigonometry in degrees. Turns are taken off exactly before anything is rounded, which is why degrees can
// be exact where radians cannot.

#include <cmath>
#include <limits>

#include "base/math.hpp"
#include "base/math_kernels.hpp"
#include "base/math_tables.hpp"

namespace lancer::math {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_tiny = 0x1p-100;  // below it an angle, its sine and its tangent differ by a factor alone

constexpr DoubleDouble k_third{0x1.5555555555555p-2, 0x1.5555555555555p-56};
constexpr DoubleDouble k_fifth{0x1.999999999999ap-3, -0x1.999999999999ap-57};
constexpr DoubleDouble k_seventh{0x1.2492492492492p-3, 0x1.2492492492492p-57};
constexpr DoubleDouble k_sixth{0x1.5555555555555p-3, 0x1.5555555555555p-57};
constexpr DoubleDouble k_24th{0x1.5555555555555p-5, 0x1.5555555555555p-59};
constexpr DoubleDouble k_120th{0x1.1111111111111p-7, 0x1.1111111111111p-63};

/// Sine and cosine of |degrees| <= 45 (and a rounding more), relative error about 2^-100.
SinCos sin_cos(double degrees) {
  constexpr double k_step = 1.40625;  // 45 / 32
  const double size = std::fabs(degrees);
  const double j = nearest_whole(size / k_step);
  const DoubleDouble a = k_degree * (size - j * k_step);  // the difference is exact; |a| <= 0.0123
  const DoubleDouble z = a * a;
  const double h = z.hi;
  const double sin_tail = 1.0 / 5040 - h * (1.0 / 362880 - h * (1.0 / 39916800));
  const DoubleDouble sin_a = a - a * z * (k_sixth - z * (k_120th + -h * sin_tail));
  const double cos_tail = 1.0 / 720 - h * (1.0 / 40320 - h * (1.0 / 3628800 - h * (1.0 / 479001600)));
  const DoubleDouble cos_a = 1.0 - z * (0.5 - z * (k_24th + -h * cos_tail));
  const SinCos& at = k_sin_cos[static_cast<std::size_t>(j)];
  const DoubleDouble s = at.sin * cos_a + at.cos * sin_a;
  return {degrees < 0 ? -s : s, at.cos * cos_a - at.sin * sin_a};
}

/// An angle as `quarters` (mod 4) quarter turns and a rest within 45 degrees, exactly.
struct Reduced {
  int quarters;
  double rest;
};

Reduced reduce(double degrees) {
  const double turn = std::fabs(degrees) <= 180 ? degrees : std::remainder(degrees, 360.0);
  const double quarters = nearest_whole(turn / 90);
  return {static_cast<int>(quarters) & 3, turn - 90 * quarters};
}

double sin_of(Reduced angle) {
  const SinCos v = sin_cos(angle.rest);
  const double s = (angle.quarters & 1) != 0 ? v.cos.hi : v.sin.hi;
  return ((angle.quarters & 2) != 0 ? -s : s) + 0.0;  // -0 + 0 is 0
}

/// value * factor for |value| < k_tiny, whose products would lose their last bits among the denormals.
double scaled_product(double value, DoubleDouble factor) {
  return round_once({factor * (value * 0x1p600), -600});
}

/// value * factor, for any value.
double product(double value, DoubleDouble factor) {
  const double size = std::fabs(value);
  if (size < k_tiny) return scaled_product(value, factor);
  if (size > 0x1p900) return round_once({factor * (value * 0x1p-600), 600});
  return (factor * value).hi;
}

/// The angle in degrees of the point (x, y) in the first quadrant, of a size near 1; y or x may be 0, not
/// both.
DoubleDouble first_quadrant(DoubleDouble y, DoubleDouble x) {
  if (y.hi > x.hi) return 90.0 - first_quadrant(x, y);
  const double j = nearest_whole(64 * (y.hi / x.hi));
  const double c = j / 64;
  const DoubleDouble t = (y - x * c) / (x + y * c);
  const DoubleDouble z = t * t;
  const double h = z.hi;
  const double tail = 1.0 / 9 - h * (1.0 / 11 - h * (1.0 / 13 - h * (1.0 / 15)));
  const DoubleDouble rest = t - t * z * (k_third - z * (k_fifth - z * (k_seventh + -h * tail)));
  return k_atan_degrees[static_cast<std::size_t>(j)] + rest * k_radian;
}

/// sqrt(1 - s^2) for |s| <= 1.
DoubleDouble other_leg(double s) { return sqrt(two_sum(1, -s) * two_sum(1, s)); }

/// atan2 for finite y > 0 and x > 0.
double positive_atan2(double y, double x, bool left) {
  const int y_exponent = std::ilogb(y);
  const int x_exponent = std::ilogb(x);
  const double ys = std::scalbn(y, -y_exponent);
  const double xs = std::scalbn(x, -x_exponent);
  const int gap = y_exponent - x_exponent;
  if (gap > 110) return 90;
  if (gap < -110) {
    if (left) return 180;
    return round_once({DoubleDouble{ys, 0} / DoubleDouble{xs, 0} * k_radian, gap});
  }
  const DoubleDouble angle = first_quadrant({std::scalbn(ys, gap), 0}, {xs, 0});
  return left ? (180.0 - angle).hi : angle.hi;
}

}  // namespace

double sin_deg(double degrees) {
  if (!std::isfinite(degrees)) return k_nan;
  if (std::fabs(degrees) < k_tiny) return scaled_product(degrees, k_degree) + 0.0;
  return sin_of(reduce(degrees));
}

double cos_deg(double degrees) {
  if (!std::isfinite(degrees)) return k_nan;
  Reduced angle = reduce(degrees);
  angle.quarters = (angle.quarters + 1) & 3;
  return sin_of(angle);
}

double tan_deg(double degrees) {
  if (!std::isfinite(degrees)) return k_nan;
  if (std::fabs(degrees) < k_tiny) return scaled_product(degrees, k_degree) + 0.0;
  const Reduced angle = reduce(degrees);
  const bool odd = (angle.quarters & 1) != 0;
  if (angle.rest == 0) {
    if (!odd) return 0;
    return angle.quarters == 1 ? std::numeric_limits<double>::infinity()
                               : -std::numeric_limits<double>::infinity();
  }
  const SinCos v = sin_cos(angle.rest);
  return odd ? -(v.cos / v.sin).hi : (v.sin / v.cos).hi;
}

double asin_deg(double s) {
  if (!(std::fabs(s) <= 1)) return k_nan;
  if (std::fabs(s) < k_tiny) return scaled_product(s, k_radian) + 0.0;
  return std::copysign(first_quadrant({std::fabs(s), 0}, other_leg(s)).hi, s);
}

double acos_deg(double c) {
  if (!(std::fabs(c) <= 1)) return k_nan;
  const DoubleDouble angle = first_quadrant(other_leg(c), {std::fabs(c), 0});
  return c < 0 ? (180.0 - angle).hi : angle.hi;
}

double atan_deg(double t) {
  if (std::isnan(t)) return t;
  const double size = std::fabs(t);
  if (size < k_tiny) return scaled_product(t, k_radian) + 0.0;
  if (size > 1 / k_tiny) return std::copysign(90.0, t);
  return std::copysign(first_quadrant({size, 0}, {1, 0}).hi, t);
}

double atan2_deg(double y, double x) {
  if (std::isnan(y) || std::isnan(x)) return k_nan;
  if (std::isinf(y) || std::isinf(x)) {
    y = std::copysign(std::isinf(y) ? 1.0 : 0.0, y);
    x = std::copysign(std::isinf(x) ? 1.0 : 0.0, x);
  }
  if (y == 0) return x < 0 ? 180 : 0;
  if (x == 0) return std::copysign(90.0, y);
  return std::copysign(positive_atan2(std::fabs(y), std::fabs(x), x < 0), y);
}

double radians(double degrees) { return std::isfinite(degrees) ? product(degrees, k_degree) : degrees; }
double degrees(double radians) { return std::isfinite(radians) ? product(radians, k_radian) : radians; }

}  // namespace lancer::math
