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

/// ln x = exponent ln 2 + coarse + fine + ln(1 + r), r exact and |r| <= 2^-13.
struct LogParts {
  int exponent;
  DoubleDouble coarse, fine, r;

  /// Without the exponent: of a significand in [0.7, 1.42).
  DoubleDouble log() const { return coarse + fine + log1p_series(r); }
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
  return {exponent, coarse.minus_log, fine, quick_two_sum(nearer.hi - 1, nearer.lo)};
}

/// x in steps of ln 2 / 4096, and the rest.
struct ExpParts {
  int steps;
  DoubleDouble rest;

  const DoubleDouble& coarse() const { return k_exp_coarse[static_cast<std::size_t>((steps >> 6) & 63)]; }
  const DoubleDouble& fine() const { return k_exp_fine[static_cast<std::size_t>(steps & 63)]; }
};

ExpParts exp_parts(DoubleDouble x) {
  constexpr double k_steps = 5909.278887481194;  // 4096 / ln 2
  const double n = nearest_whole(x.hi * k_steps);
  return {static_cast<int>(n), ((x.hi - n * k_exp_step_head) + -(k_exp_step_rest * n)) + x.lo};
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
  const ExpParts parts = exp_parts(x);
  const DoubleDouble power = parts.coarse() * parts.fine();
  return {power + power * expm1_series(parts.rest), parts.steps >> 12};
}

Scaled quick_exp(DoubleDouble x) {
  const ExpParts parts = exp_parts(x);
  const DoubleDouble power = parts.coarse() * parts.fine();
  const double r = parts.rest.hi;
  const double expm1 = r + (parts.rest.lo + r * r * (0.5 + r * (1.0 / 6 + r * (1.0 / 24))));
  return {quick_two_sum(power.hi, power.lo + power.hi * expm1), parts.steps >> 12};
}

DoubleDouble log_kernel(double x) {
  const LogParts parts = log_parts(x);
  if (parts.exponent == 0) return parts.log();
  return parts.exponent * k_ln2_head + (parts.exponent * k_ln2_rest + parts.log());
}

DoubleDouble quick_log(double x) {
  const LogParts parts = log_parts(x);
  const double r = parts.r.hi;
  const double series = r * r * (-0.5 + r * (1.0 / 3 - r * (0.25 - r * 0.2)));
  const DoubleDouble a = two_sum(parts.exponent * k_ln2_head, parts.coarse.hi);
  const DoubleDouble b = two_sum(a.hi, parts.fine.hi);
  const DoubleDouble c = two_sum(b.hi, r);
  const double tables = parts.exponent * k_ln2_rest.hi + (parts.coarse.lo + parts.fine.lo);
  return quick_two_sum(c.hi, series + (a.lo + b.lo + c.lo + tables + parts.r.lo));
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
  return (parts.exponent + parts.log() * k_log2_e).hi;
}

double log10(double x) {
  const double special = log_special(x);
  return special == 1 ? (log_kernel(x) * k_log10_e).hi : special;
}

}  // namespace lancer::math
