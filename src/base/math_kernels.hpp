#pragma once
// What the files of math.hpp share: the exponential and the logarithm in double-double, and the one rounding
// at the end.

#include <bit>
#include <cstdint>

#include "base/double_double.hpp"

namespace lancer::math {

/// The nearest whole number, for |x| < 2^51.
inline double nearest_whole(double x) {
  constexpr double k_shift = 6755399441055744;  // 1.5 * 2^52
  return (x + k_shift) - k_shift;
}

/// 2^exponent, for exponents from -1022 to 1023.
inline double power_of_two(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// significand * 2^exponent, the significand about 1 to 2.
struct Scaled {
  DoubleDouble significand;
  int exponent = 0;
};

/// The double nearest to the value, denormals included; infinity where it is too large.
double round_once(Scaled value);

/// e^x for |x| <= 800, relative error about 2^-96.
Scaled exp_kernel(DoubleDouble x);

/// ln x for a finite x > 0, relative error about 2^-103.
DoubleDouble log_kernel(double x);

// The same with fewer bits, faster: relative errors below 2^-64.
Scaled quick_exp(DoubleDouble x);
DoubleDouble quick_log(double x);

}  // namespace lancer::math
