#pragma once
// Vectors in twice the precision, their components side by side in one register where the processor has such.
// Compiled once for every processor and once for those with AVX2 and fused multiply-add, each in a namespace
// of its own, LANCER_TARGET; the bits are the same. Nothing here may be left to the linker to choose from
// either, so everything is inlined.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#if defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>
#endif

#include "tracer/numeric.hpp"

#define LANCER_INLINE [[gnu::always_inline]] inline

namespace lancer::tracer::LANCER_TARGET {

/// The three components of a vector, and one more number.
using Lanes [[gnu::vector_size(32)]] = double;

/// Sums hi + lo, component by component; lo may be as large as the rounding of what hi was summed from.
struct Lanes2 {
  Lanes hi, lo;
};

/// All bits of a lane are set, or none.
using Mask [[gnu::vector_size(32)]] = long long;

LANCER_INLINE Lanes lanes(Vec3 v, double more = 0) { return Lanes{v.x, v.y, v.z, more}; }
LANCER_INLINE Lanes lanes(double s) { return Lanes{s, s, s, s}; }
LANCER_INLINE Vec3 vec(Lanes v) { return {v[0], v[1], v[2]}; }
LANCER_INLINE Lanes abs(Lanes v) {
  using Bits [[gnu::vector_size(32)]] = long long;
  constexpr long long k_but_sign = 0x7FFFFFFFFFFFFFFF;
  return reinterpret_cast<Lanes>(reinterpret_cast<Bits>(v) &
                                 Bits{k_but_sign, k_but_sign, k_but_sign, k_but_sign});
}
template <class Comparison>
LANCER_INLINE Mask mask(Comparison comparison) {
  return reinterpret_cast<Mask>(comparison);
}
/// A bit for each lane.
LANCER_INLINE unsigned bits(Mask m) {
#if defined(__AVX2__)
  return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<Lanes>(m)));
#else
  // Of an array, as GCC 12's UBSan goes astray in a vector that a variable indexes.
  unsigned out = 0;
  const auto lanes_of = std::bit_cast<std::array<long long, 4>>(m);
  for (std::size_t i = 0; i < 4; ++i) out |= lanes_of[i] != 0 ? 1U << i : 0U;
  return out;
#endif
}

/// Of the three components.
LANCER_INLINE double sum(Lanes v) { return v[0] + v[1] + v[2]; }
LANCER_INLINE double least(Lanes v) { return std::min(v[0], std::min(v[1], v[2])); }

/// a + b exactly.
template <class T>
struct Sum {
  T hi, lo;
};
template <class T>
LANCER_INLINE Sum<T> exact_sum(T a, T b) {
  const T s = a + b;
  const T t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

#if defined(__AVX2__) && defined(__FMA__)
LANCER_INLINE Sum<double> exact_product(double a, double b) {
  const double p = a * b;
  return {p, __builtin_fma(a, b, -p)};
}
LANCER_INLINE Sum<Lanes> exact_product(Lanes a, Lanes b) {
  const Lanes p = a * b;
  return {p, static_cast<Lanes>(_mm256_fmsub_pd(a, b, p))};
}
#else
LANCER_INLINE double constant(double s, double) { return s; }
LANCER_INLINE Lanes constant(double s, Lanes) { return lanes(s); }
/// By Dekker's splitting of the factors.
template <class T>
LANCER_INLINE Sum<T> exact_product(T a, T b) {
  const T splitter = constant(134217729, a);  // 2^27 + 1
  const T p = a * b;
  const T as = a * splitter, bs = b * splitter;
  const T a1 = as - (as - a), b1 = bs - (bs - b);
  const T a0 = a - a1, b0 = b - b1;
  return {p, ((a1 * b1 - p) + a1 * b0 + a0 * b1) + a0 * b0};
}
#endif

/// a - b exactly, and one more number.
LANCER_INLINE Lanes2 exact_difference(Vec3 a, Vec3 b, double more = 0) {
  const Sum<Lanes> d = exact_sum(lanes(a, more), -lanes(b));
  return {d.hi, d.lo};
}

using Pair [[gnu::vector_size(16)]] = double;
LANCER_INLINE Pair lower(Lanes v) { return __builtin_shufflevector(v, v, 0, 1); }
LANCER_INLINE Pair upper(Lanes v) { return __builtin_shufflevector(v, v, 2, 3); }

/// The sum of four numbers and of what is small beside them.
LANCER_INLINE DoubleDouble total(Lanes hi, Lanes low) {
  const Sum<Pair> halves = exact_sum(lower(hi), upper(hi));
  const Sum<double> all = exact_sum(halves.hi[0], halves.hi[1]);
  const Pair rest = lower(low) + upper(low);
  return {all.hi, all.lo + (halves.lo[0] + halves.lo[1]) + (rest[0] + rest[1])};
}
/// The sum of the four products a b as if in twice the precision (Ogita, Rump, Oishi: Dot2), off by
/// 8 u^2 |a| |b| and the rounding of their low parts.
LANCER_INLINE DoubleDouble total(Lanes2 a, Lanes2 b) {
  const Sum<Lanes> product = exact_product(a.hi, b.hi);
  return total(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi) + a.lo * b.lo);
}

/// A distance as an unevaluated sum, and how far it may be off.
struct Distance {
  double hi = 0, lo = 0;
  double error = 0;

  LANCER_INLINE void add(double correction) {
    const Sum<double> s = exact_sum(hi, lo + correction);
    hi = s.hi;
    lo = s.lo;
  }
};

/// from + t d, off by 8 u^2 (|from| + |t d|) at most.
LANCER_INLINE Lanes2 advance(Lanes2 from, Lanes d, const Distance& t) {
  const Sum<Lanes> way = exact_product(lanes(t.hi), d);
  const Sum<Lanes> s = exact_sum(from.hi, way.hi);
  return {s.hi, s.lo + (way.lo + lanes(t.lo) * d + from.lo)};
}
/// What it may be off, and more simply a bound for all components.
LANCER_INLINE Lanes advance_error(Lanes from, Lanes d, const Distance& t) {
  return (abs(from) + abs(d) * lanes(std::fabs(t.hi))) * lanes(8 * k_u * k_u) + abs(d) * lanes(t.error);
}
LANCER_INLINE double advance_bound(double reach, const Distance& t) {
  return (reach + std::fabs(t.hi)) * (8 * k_u * k_u) + t.error;
}

/// from + v.hi + v.lo.
LANCER_INLINE Vec3 moved(Vec3 from, Lanes2 v) {
  const Sum<Lanes> s = exact_sum(lanes(from), v.hi);
  return vec(s.hi + (s.lo + v.lo));
}

/// Is the error far below the last bit of the value, or of `size`?
LANCER_INLINE bool settles(double value, double error, double size = 0) {
  return error <= std::max(std::fabs(value), size) * (k_u / 16);
}
LANCER_INLINE bool settles(const Distance& t) { return std::isfinite(t.hi) && settles(t.hi, t.error); }
/// Are all these errors below the last bits of the components, or of the largest component times 2^-40?
LANCER_INLINE bool settles(Lanes value, Lanes error) {
  const Lanes size = abs(value);
  const double enough = sum(size) * 0x1p-41;
  return settles(size[0], error[0], enough) && settles(size[1], error[1], enough) &&
         settles(size[2], error[2], enough);
}
LANCER_INLINE bool settles(Lanes value, double error) {
  const Lanes size = abs(value);
  return settles(least(size), error, sum(size) * 0x1p-41);
}

}  // namespace lancer::tracer::LANCER_TARGET
