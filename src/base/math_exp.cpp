// Exponentials and logarithms: an argument is brought near 1 (or 0) by two steps of tables, then a short
// series.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/math.hpp"
#include "base/math_kernels.hpp"
#include "base/math_tables.hpp"

namespace lancer::math {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr DoubleDouble k_third{0x1.5555555555555p-2, 0x1.5555555555555p-56};
constexpr DoubleDouble k_sixth{0x1.5555555555555p-3, 0x1.5555555555555p-57};

/// ln(1 + r) for |r| <= 2^-13; terms are in double-double as far as they matter.
DoubleDouble log1p_series(DoubleDouble r) {
  const double h = r.hi;
  const double tail = 1.0 / 5 - h * (1.0 / 6 - h * (1.0 / 7 - h * (1.0 / 8)));
  const DoubleDouble fourth = quick_two_sum(-0.25, h * tail);
  return r + r * r * (-0.5 + r * (k_third + r * fourth));
}

/// e^r - 1 for |r| <= 2^-13.5.
DoubleDouble expm1_series(DoubleDouble r) {
  const double h = r.hi;
  const double tail = 1.0 / 24 + h * (1.0 / 120 + h * (1.0 / 720 + h * (1.0 / 5040)));
  const DoubleDouble third = k_sixth + h * tail;
  return r + r * r * (0.5 + r * third);
}

/// x as 2^exponent times a significand in [0.7, 1.42), and ln of that significand.
struct LogParts {
  int exponent;
  DoubleDouble log;
};

LogParts log_parts(double x) {
  int exponent = 0;
  if (x < std::numeric_limits<double>::min()) {
    x *= 0x1p54;
    exponent = -54;
  }
  const auto bits = std::bit_cast<std::uint64_t>(x);
  exponent += static_cast<int>(bits >> 52) - 1023;
  double significand = std::bit_cast<double>((bits & 0xFFFFFFFFFFFFF) | 0x3FF0000000000000);
  const auto part = static_cast<std::size_t>((bits >> 45) & 127);
  if (part >= 53) {
    significand *= 0.5;
    exponent += 1;
  }
  // Both products are exact: 53 + 9 + 13 bits.
  const LogEntry& coarse = k_log_coarse[part];
  const DoubleDouble near_one = two_product(significand, coarse.reciprocal);
  const double j = nearest_whole(((near_one.hi - 1) + near_one.lo) * 8192);
  const DoubleDouble nearer = near_one * (1 - j / 8192);
  const DoubleDouble& fine = k_log_fine[static_cast<std::size_t>(64 + static_cast<int>(j))];
  return {exponent, coarse.minus_log + fine + log1p_series(nearer + -1.0)};
}

/// What the logarithms are where they are not finite, or 1 for the others.
double log_special(double x) {
  if (x > 0) return x == k_infinity ? x : 1;
  return x == 0 ? -k_infinity : k_nan;
}

}  // namespace

double round_once(Scaled value) {
  const double hi = value.significand.hi;
  const double lo = value.significand.lo;
  if (hi == 0) return hi;
  const int top = std::ilogb(hi) + value.exponent;
  if (top >= -1022) return std::scalbn(hi, value.exponent);
  if (top < -1080) return std::copysign(0.0, hi);
  // A denormal has fewer bits than hi: round at its last one, with lo deciding the ties.
  const double unit = std::scalbn(1.0, -1074 - value.exponent);
  double units = std::nearbyint(hi / unit);
  const double rest = hi - units * unit;
  if (rest == 0.5 * unit && lo > 0) units += 1;
  if (rest == -0.5 * unit && lo < 0) units -= 1;
  return std::copysign(std::scalbn(units, -1074), hi);
}

Scaled exp_kernel(DoubleDouble x) {
  constexpr double k_steps = 5909.278887481194;  // 4096 / ln 2
  const double n = nearest_whole(x.hi * k_steps);
  const DoubleDouble r = ((x.hi - n * k_exp_step_head) + -(k_exp_step_rest * n)) + x.lo;
  const int steps = static_cast<int>(n);
  const DoubleDouble power = k_exp_coarse[static_cast<std::size_t>((steps >> 6) & 63)] *
                             k_exp_fine[static_cast<std::size_t>(steps & 63)];
  return {power + power * expm1_series(r), steps >> 12};
}

DoubleDouble log_kernel(double x) {
  const LogParts parts = log_parts(x);
  if (parts.exponent == 0) return parts.log;
  return parts.exponent * k_ln2_head + (parts.exponent * k_ln2_rest + parts.log);
}

double exp(double x) {
  if (std::isnan(x)) return x;
  if (x > 710) return k_infinity;
  if (x < -746) return 0;
  if (std::fabs(x) < 0x1p-60) return 1;
  return round_once(exp_kernel({x, 0}));
}

double log(double x) {
  const double special = log_special(x);
  return special == 1 ? log_kernel(x).hi : special;
}

double log2(double x) {
  const double special = log_special(x);
  if (special != 1) return special;
  const LogParts parts = log_parts(x);
  return (parts.exponent + parts.log * k_log2_e).hi;
}

double log10(double x) {
  const double special = log_special(x);
  return special == 1 ? (log_kernel(x) * k_log10_e).hi : special;
}

}  // namespace lancer::math
