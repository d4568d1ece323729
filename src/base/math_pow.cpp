// Powers, the cube root, and the curve of sRGB, which is a power.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "base/math.hpp"
#include "base/math_kernels.hpp"

namespace lancer::math {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

/// base^n, base > 0, n > 0, where the odd part of the result has at most 64 bits. All results that are exact
/// or halfway between two doubles are among them.
std::optional<Scaled> exact_whole_power(double base, double n) {
  int exponent = 0;
  const double fraction = std::frexp(base, &exponent);
  auto odd = static_cast<std::uint64_t>(std::scalbn(fraction, 53));
  const int zeros = std::countr_zero(odd);
  odd >>= zeros;
  if (odd > 1 && n > 40) return std::nullopt;  // 3^41 > 2^64
  std::uint64_t product = 1;
  for (int i = 0; odd > 1 && i < static_cast<int>(n); ++i) {
    if (product > std::numeric_limits<std::uint64_t>::max() / odd) return std::nullopt;
    product *= odd;
  }
  const std::uint64_t low = product & 0x7FF;
  const DoubleDouble value = quick_two_sum(static_cast<double>(product - low), static_cast<double>(low));
  const int top = std::ilogb(value.hi);
  const double two = n * (exponent - 53 + zeros) + top;  // the caller knows that it is in range
  return Scaled{{std::scalbn(value.hi, -top), std::scalbn(value.lo, -top)}, static_cast<int>(two)};
}

/// x^y, x > 0, where the result is dyadic: y = n / 2^f and x a 2^f-th power, or x a power of two.
std::optional<Scaled> exact_power(double x, double y) {
  for (int f = 0; f <= 10; ++f) {
    if (y == std::floor(y)) {
      if (y > 0) return exact_whole_power(x, y);
      // A reciprocal is dyadic for powers of two alone.
      int exponent = 0;
      if (std::frexp(x, &exponent) != 0.5) return std::nullopt;
      return Scaled{{1, 0}, static_cast<int>((exponent - 1) * y)};
    }
    const double root = std::sqrt(x);
    if (std::fma(root, root, -x) != 0) return std::nullopt;
    x = root;
    y *= 2;
  }
  return std::nullopt;
}

/// x^y from the quick kernels, where their error cannot change the rounding and the result is a normal
/// number. After A. Ziv, "Fast evaluation of elementary mathematical functions with correctly rounded last
/// bit" (1991).
std::optional<double> quick_power(double x, double y) {
  const DoubleDouble log = quick_log(x);
  const double size = log.hi * y;
  if (!(std::fabs(size) < 700 && std::fabs(size) > 0x1p-60)) return std::nullopt;
  const Scaled power = quick_exp(log * y);
  const double hi = power.significand.hi;
  const double lo = power.significand.lo;
  const double error = hi * (0x1p-63 + std::fabs(size) * 0x1p-63);
  const double result = hi + (lo - error);
  if (result != hi + (lo + error)) return std::nullopt;
  return result * power_of_two(power.exponent);
}

/// x^y for finite x > 0.
double positive_power(double x, double y) {
  if (const std::optional<double> quick = quick_power(x, y)) return *quick;
  const DoubleDouble log = log_kernel(x);
  const double size = log.hi * y;
  if (size > 710) return k_infinity;
  if (size < -746) return 0;
  if (std::fabs(size) < 0x1p-60) return 1;
  Scaled result = exp_kernel(log * y);
  const double hi = result.significand.hi;
  const double lo = result.significand.lo;
  // Halfway between two doubles the last bits of the kernel would toss a coin.
  const bool near_tie = hi + lo * (1 + 0x1p-30) != hi;
  if (near_tie || size < -707) result = exact_power(x, y).value_or(result);
  return round_once(result);
}

bool is_whole(double y) { return y == std::floor(y); }
bool is_odd(double y) { return std::fabs(y) < 0x1p53 && std::fmod(y, 2) != 0; }

/// pow where x or y is infinite or x is 0; y is not 0.
double limit_power(double x, double y) {
  const double size = std::fabs(x);
  if (std::isinf(y)) {
    if (size == 1) return 1;
    return (size > 1) == (y > 0) ? k_infinity : 0;
  }
  const double result = (size > 1) == (y > 0) ? k_infinity : 0;
  return is_whole(y) && is_odd(y) ? std::copysign(result, x) : result;
}

/// ln of a double-double > 0.
DoubleDouble log_of(DoubleDouble x) { return log_kernel(x.hi) + x.lo / x.hi; }

constexpr DoubleDouble k_offset{0x1.c28f5c28f5c29p-5, -0x1.47ae147ae147bp-62};   // 0.055
constexpr DoubleDouble k_gain{0x1.0e147ae147ae1p+0, 0x1.1eb851eb851ecp-54};      // 1.055
constexpr DoubleDouble k_slope{0x1.9d70a3d70a3d7p+3, 0x1.47ae147ae147bp-54};     // 12.92
constexpr DoubleDouble k_exponent{0x1.3333333333333p+1, 0x1.999999999999ap-54};  // 2.4

}  // namespace

double pow(double x, double y) {
  if (y == 0 || x == 1) return 1;
  if (std::isnan(x) || std::isnan(y)) return k_nan;
  if (x == 0 || std::isinf(x) || std::isinf(y)) return limit_power(x, y);
  if (x > 0) return positive_power(x, y);
  if (!is_whole(y)) return k_nan;
  const double result = positive_power(-x, y);
  return is_odd(y) ? -result : result;
}

double cbrt(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  int exponent = 0;
  double m = 2 * std::frexp(std::fabs(x), &exponent);
  exponent -= 1;
  const int third = (exponent - ((exponent % 3) + 3) % 3) / 3;
  m = std::scalbn(m, exponent - 3 * third);  // in [1, 8)
  // The parabola through (1, 1), (1.5^3, 1.5) and (8, 2), then the iteration of Halley, which triples the
  // digits.
  double y = 1 + (m - 1) * (0.2105263157894737 - 0.014629049111807733 * (m - 3.375));
  for (int i = 0; i < 3; ++i) {
    const double cube = y * y * y;
    y *= (cube + 2 * m) / (2 * cube + m);
  }
  const DoubleDouble rest = -(two_product(y, y) * y) + m;
  const DoubleDouble root = quick_two_sum(y, (rest.hi + rest.lo) / (3 * y * y));
  return std::copysign(std::scalbn(root.hi, third), x);
}

double srgb_to_linear(double value) {
  if (value <= 0.04045) return (DoubleDouble{value, 0} / k_slope).hi;
  const DoubleDouble base = (value + k_offset) / k_gain;
  return round_once(exp_kernel(log_of(base) * k_exponent));
}

double linear_to_srgb(double light) {
  if (light <= 0.0031308) return (light * k_slope).hi;
  const Scaled root = exp_kernel(log_kernel(light) / k_exponent);
  const double two = power_of_two(root.exponent);
  const DoubleDouble power{root.significand.hi * two, root.significand.lo * two};
  return (power * k_gain - k_offset).hi;
}

}  // namespace lancer::math
