#pragma once
// The arithmetic of a landing, in two versions of the same bits: with the processor's fused multiply-add
// where it has one, else by Dekker's splitting. Everything is inlined into the two.

#include "tracer/shapes/landing.hpp"

#define LANCER_INLINE [[gnu::always_inline]] inline
#if defined(__x86_64__)
#define LANCER_FUSED [[gnu::target("fma")]]
#else
#define LANCER_FUSED
#endif

namespace lancer::tracer {

struct Split {
  LANCER_INLINE static DoubleDouble product(double a, double b) { return two_product(a, b); }
};
struct Fused {
  LANCER_INLINE static DoubleDouble product(double a, double b) {
    const double p = a * b;
    return {p, __builtin_fma(a, b, -p)};
  }
};

#if defined(__x86_64__)
inline const bool k_has_fused = __builtin_cpu_supports("fma") != 0;
#elif defined(__aarch64__)
inline constexpr bool k_has_fused = true;
#else
inline constexpr bool k_has_fused = false;
#endif

/// A distance as an unevaluated sum, and how far it may be off.
struct Distance {
  DoubleDouble t;
  double error = 0;
};

/// from + t d, off by 8 u^2 (|from| + |t d|) at most.
template <class P>
LANCER_INLINE DoubleDouble advance(DoubleDouble from, double d, DoubleDouble t) {
  const DoubleDouble way = P::product(t.hi, d);
  const DoubleDouble sum = two_sum(from.hi, way.hi);
  return two_sum(sum.hi, sum.lo + (way.lo + t.lo * d + from.lo));
}
template <class P>
LANCER_INLINE Triple2 advance(const Triple2& from, Vec3 d, DoubleDouble t) {
  return {advance<P>(from[0], d.x, t), advance<P>(from[1], d.y, t), advance<P>(from[2], d.z, t)};
}

/// A sum of products as if in twice the precision (Ogita, Rump, Oishi: Dot2).
template <class P>
struct Total {
  double high = 0, low = 0;

  LANCER_INLINE void add(double value) {
    const DoubleDouble sum = two_sum(high, value);
    high = sum.hi;
    low += sum.lo;
  }
  LANCER_INLINE void add_product(double a, double b) {
    const DoubleDouble product = P::product(a, b);
    add(product.hi);
    low += product.lo;
  }
  LANCER_INLINE void add_square(DoubleDouble x) {
    add_product(x.hi, x.hi);
    low += 2 * x.hi * x.lo;
  }
  LANCER_INLINE double value() const { return high + low; }
};

/// (a.hi + a.lo) / b within 0.51 ulp.
template <class P>
LANCER_INLINE double quotient(DoubleDouble a, double b, double inverse) {
  const double q = a.hi * inverse;
  const DoubleDouble product = P::product(q, b);
  return q + (((a.hi - product.hi) - product.lo) + a.lo) * inverse;
}

/// Are these errors far below the last bits of the values, or of `least`?
LANCER_INLINE bool settles(double value, double error, double least = 0) {
  return error <= std::fmax(std::fabs(value), least) * (k_u / 16);
}
LANCER_INLINE bool settles(Vec3 value, Vec3 error) {
  const Vec3 size = abs(value);
  const double least = (size.x + size.y + size.z) * 0x1p-41;
  return settles(size.x, error.x, least) && settles(size.y, error.y, least) &&
         settles(size.z, error.z, least);
}

/// What the coordinates of from + t d may be off.
LANCER_INLINE Vec3 advance_error(Vec3 from, Vec3 d, const Distance& distance) {
  const Vec3 way = abs(d) * std::fabs(distance.t.hi);
  return (abs(from) + way) * (8 * k_u * k_u) + abs(d) * distance.error;
}

}  // namespace lancer::tracer
