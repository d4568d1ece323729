#pragma once
// Four rays' numbers side by side. Every operation is that of the single number, in the same order, so that a
// lane has the bits that its ray would have alone. Compiled in the namespace LANCER_TARGET; see
// shapes/lanes.hpp.

#include <cstdint>

#include "tracer/shapes/lanes.hpp"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace lancer::tracer::LANCER_TARGET {

// In memory they are numbers one after the other.
using StoredLanes [[gnu::vector_size(32), gnu::may_alias]] = double;
using StoredMask [[gnu::vector_size(32), gnu::may_alias]] = long long;
LANCER_INLINE Lanes load(const double* aligned) { return *reinterpret_cast<const StoredLanes*>(aligned); }
LANCER_INLINE Mask load(const long long* aligned) { return *reinterpret_cast<const StoredMask*>(aligned); }
LANCER_INLINE void store(double* aligned, Lanes a) { *reinterpret_cast<StoredLanes*>(aligned) = a; }
LANCER_INLINE void store(long long* aligned, Mask a) { *reinterpret_cast<StoredMask*>(aligned) = a; }

LANCER_INLINE Mask masks(long long bits) { return Mask{bits, bits, bits, bits}; }

LANCER_INLINE Lanes select(Mask where, Lanes yes, Lanes no) {
#if defined(__AVX2__)
  return static_cast<Lanes>(_mm256_blendv_pd(no, yes, reinterpret_cast<Lanes>(where)));
#else
  return reinterpret_cast<Lanes>((where & reinterpret_cast<Mask>(yes)) |
                                 (~where & reinterpret_cast<Mask>(no)));
#endif
}
LANCER_INLINE Mask select(Mask where, Mask yes, Mask no) { return (where & yes) | (~where & no); }

LANCER_INLINE bool any(Mask m) { return bits(m) != 0; }

/// As std::min and std::max.
LANCER_INLINE Lanes lesser(Lanes a, Lanes b) { return select(mask(b < a), b, a); }
LANCER_INLINE Lanes greater(Lanes a, Lanes b) { return select(mask(a < b), b, a); }

LANCER_INLINE Lanes square_root(Lanes a) {
#if defined(__AVX2__)
  return static_cast<Lanes>(_mm256_sqrt_pd(a));
#else
  return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}

LANCER_INLINE Mask is_finite(Lanes a) { return mask(abs(a) <= lanes(1.7976931348623157e308)); }
/// Where the sign's bit is set.
LANCER_INLINE Mask is_negative(Lanes a) { return mask(reinterpret_cast<Mask>(a) < masks(0)); }

struct Vectors {
  Lanes x, y, z;

  LANCER_INLINE Lanes operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

LANCER_INLINE Vectors vectors(Vec3 v) { return {lanes(v.x), lanes(v.y), lanes(v.z)}; }
LANCER_INLINE Vectors operator+(const Vectors& a, const Vectors& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
LANCER_INLINE Vectors operator-(const Vectors& a, const Vectors& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
LANCER_INLINE Vectors operator-(const Vectors& a) { return {-a.x, -a.y, -a.z}; }
LANCER_INLINE Vectors operator*(const Vectors& a, Lanes s) { return {a.x * s, a.y * s, a.z * s}; }
LANCER_INLINE Lanes dot(const Vectors& a, const Vectors& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
LANCER_INLINE Lanes sum_abs(const Vectors& a) { return abs(a.x) + abs(a.y) + abs(a.z); }
LANCER_INLINE Lanes largest(const Vectors& a) { return greater(abs(a.x), greater(abs(a.y), abs(a.z))); }
LANCER_INLINE Vectors select(Mask where, const Vectors& yes, const Vectors& no) {
  return {select(where, yes.x, no.x), select(where, yes.y, no.y), select(where, yes.z, no.z)};
}

/// Sums hi + lo.
struct Twice {
  Lanes hi, lo;
};

/// Vectors as sums.
struct Vectors2 {
  Vectors hi, lo;
};
LANCER_INLINE Vectors2 exact_difference(const Vectors& a, const Vectors& b) {
  const Sum<Lanes> x = exact_sum(a.x, -b.x), y = exact_sum(a.y, -b.y), z = exact_sum(a.z, -b.z);
  return {{x.hi, y.hi, z.hi}, {x.lo, y.lo, z.lo}};
}

/// Where length() and normalize() may work with the vector as it is: taking a power of two out would change
/// no bit, as nothing over- or underflows that counts.
LANCER_INLINE Mask is_plain(const Vectors& a) {
  const Lanes size = largest(a);
  return mask(size > lanes(0x1p-400)) & mask(size < lanes(0x1p400));
}
LANCER_INLINE Vectors normalized(const Vectors& a) {
  const Lanes length = square_root(dot(a, a));
  return {a.x / length, a.y / length, a.z / length};
}

}  // namespace lancer::tracer::LANCER_TARGET
