#pragma once
// The values that the functions of math.hpp start from. The definitions are made by make_math_tables.py.

#include <array>

#include "base/double_double.hpp"

namespace lancer::math {

extern const DoubleDouble k_log2_e;   // 1 / ln 2
extern const DoubleDouble k_log10_e;  // 1 / ln 10
extern const DoubleDouble k_degree;   // pi / 180
extern const DoubleDouble k_radian;   // 180 / pi

// ln 2 in two parts; the head is short enough for exact products with exponents.
extern const double k_ln2_head;
extern const DoubleDouble k_ln2_rest;

// ln 2 / 4096 in two parts; the head is short enough for exact products with whole numbers below 2^23.
extern const double k_exp_step_head;
extern const DoubleDouble k_exp_step_rest;

extern const std::array<DoubleDouble, 64> k_exp_coarse;  // [i]: 2^(i/64)
extern const std::array<DoubleDouble, 64> k_exp_fine;    // [i]: 2^(i/4096)

/// A short reciprocal c of the middle of a part of [1, 2), and -ln c.
struct LogEntry {
  double reciprocal;
  DoubleDouble minus_log;
};
extern const std::array<LogEntry, 128> k_log_coarse;    // of part i of [1, 2); from 53 on, of [1/2, 1)
extern const std::array<DoubleDouble, 129> k_log_fine;  // [64 + j]: -ln(1 - j/8192)

struct SinCos {
  DoubleDouble sin, cos;
};
extern const std::array<SinCos, 33> k_sin_cos;             // [i]: of i * 45/32 degrees
extern const std::array<DoubleDouble, 65> k_atan_degrees;  // [i]: atan(i/64)

}  // namespace lancer::math
