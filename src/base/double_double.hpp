#pragma once
// Numbers of about 106 bits: the sum of two doubles, hi + lo with |lo| <= ulp(hi) / 2. Every operation is
// made of roundings that IEEE 754 fixes, so the results are the same bits everywhere. Relative errors are a
// few 2^-105. After T. J. Dekker, "A floating-point technique for extending the available precision" (1971),
// and M. Joldes, J.-M. Muller, V. Popescu, "Tight and rigorous error bounds for basic building blocks of
// double-word arithmetic" (2017).

#include <cmath>

namespace lancer {

struct DoubleDouble {
  double hi = 0, lo = 0;
};

/// a + b exactly, where |a| >= |b| or a is 0.
inline DoubleDouble quick_two_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// a + b exactly.
inline DoubleDouble two_sum(double a, double b) {
  const double s = a + b;
  const double t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

/// a * b exactly, where nothing over- or underflows.
inline DoubleDouble two_product(double a, double b) {
  const double p = a * b;
#if defined(__FMA__) || defined(__aarch64__)
  return {p, std::fma(a, b, -p)};
#else
  // Where std::fma would be a call, Dekker's way to the same bits is faster.
  constexpr double k_splitter = 134217729;  // 2^27 + 1
  const double at = k_splitter * a;
  const double a1 = at - (at - a);
  const double a0 = a - a1;
  const double bt = k_splitter * b;
  const double b1 = bt - (bt - b);
  const double b0 = b - b1;
  return {p, ((a1 * b1 - p) + a1 * b0 + a0 * b1) + a0 * b0};
#endif
}

inline DoubleDouble operator-(DoubleDouble a) { return {-a.hi, -a.lo}; }

inline DoubleDouble operator+(DoubleDouble a, double b) {
  const DoubleDouble s = two_sum(a.hi, b);
  return quick_two_sum(s.hi, s.lo + a.lo);
}
inline DoubleDouble operator+(double a, DoubleDouble b) { return b + a; }

inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble s = two_sum(a.hi, b.hi);
  const DoubleDouble t = two_sum(a.lo, b.lo);
  const DoubleDouble v = quick_two_sum(s.hi, s.lo + t.hi);
  return quick_two_sum(v.hi, t.lo + v.lo);
}
inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }
inline DoubleDouble operator-(double a, DoubleDouble b) { return a + -b; }

inline DoubleDouble operator*(DoubleDouble a, double b) {
  const DoubleDouble p = two_product(a.hi, b);
  return quick_two_sum(p.hi, p.lo + a.lo * b);
}
inline DoubleDouble operator*(double a, DoubleDouble b) { return b * a; }

inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
  const DoubleDouble p = two_product(a.hi, b.hi);
  return quick_two_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
  const double q = a.hi / b.hi;
  const DoubleDouble r = a - b * q;
  return quick_two_sum(q, (r.hi + r.lo) / b.hi);
}

/// Of a positive number, or of 0.
inline DoubleDouble sqrt(DoubleDouble a) {
  const double s = std::sqrt(a.hi);
  if (s == 0) return {};
  const DoubleDouble r = a - two_product(s, s);
  return quick_two_sum(s, (r.hi + r.lo) / (2 * s));
}

}  // namespace lancer
