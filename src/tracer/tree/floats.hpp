#pragma once
// Eight floats side by side: in one register with AVX2, else in two. Compiled once for every processor and
// once for those with AVX2, each in a namespace of its own, LANCER_TARGET; the bits are the same, so products
// are rounded before they are added to. Nothing here may be left to the linker to choose from either, so
// everything is inlined.

#include <array>
#include <cstddef>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#define LANCER_INLINE [[gnu::always_inline]] inline

namespace lancer::tracer::LANCER_TARGET {

#if defined(__AVX2__)

struct Floats {
  __m256 v;
};

LANCER_INLINE Floats load(const float* aligned) { return {_mm256_load_ps(aligned)}; }
LANCER_INLINE void store(float* aligned, Floats a) { _mm256_store_ps(aligned, a.v); }
LANCER_INLINE Floats splat(float a) { return {_mm256_set1_ps(a)}; }
LANCER_INLINE Floats times_plus(Floats a, Floats b, Floats c) {
  return {_mm256_add_ps(_mm256_mul_ps(a.v, b.v), c.v)};
}
LANCER_INLINE Floats greater(Floats a, Floats b) { return {_mm256_max_ps(a.v, b.v)}; }
LANCER_INLINE Floats lesser(Floats a, Floats b) { return {_mm256_min_ps(a.v, b.v)}; }
/// A bit for each place where a <= b.
LANCER_INLINE unsigned at_most(Floats a, Floats b) {
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)));
}

#elif defined(__SSE2__)

struct Floats {
  __m128 low, high;
};

LANCER_INLINE Floats load(const float* aligned) { return {_mm_load_ps(aligned), _mm_load_ps(aligned + 4)}; }
LANCER_INLINE void store(float* aligned, Floats a) {
  _mm_store_ps(aligned, a.low);
  _mm_store_ps(aligned + 4, a.high);
}
LANCER_INLINE Floats splat(float a) { return {_mm_set1_ps(a), _mm_set1_ps(a)}; }
LANCER_INLINE Floats times_plus(Floats a, Floats b, Floats c) {
  return {_mm_add_ps(_mm_mul_ps(a.low, b.low), c.low), _mm_add_ps(_mm_mul_ps(a.high, b.high), c.high)};
}
LANCER_INLINE Floats greater(Floats a, Floats b) {
  return {_mm_max_ps(a.low, b.low), _mm_max_ps(a.high, b.high)};
}
LANCER_INLINE Floats lesser(Floats a, Floats b) {
  return {_mm_min_ps(a.low, b.low), _mm_min_ps(a.high, b.high)};
}
LANCER_INLINE unsigned at_most(Floats a, Floats b) {
  const auto bits = [](__m128 mask) { return static_cast<unsigned>(_mm_movemask_ps(mask)); };
  return bits(_mm_cmple_ps(a.low, b.low)) | bits(_mm_cmple_ps(a.high, b.high)) << 4;
}

#else

struct Floats {
  std::array<float, 8> v;
};

LANCER_INLINE Floats load(const float* a) {
  Floats out;
  for (std::size_t i = 0; i < 8; ++i) out.v[i] = a[i];
  return out;
}
LANCER_INLINE void store(float* to, const Floats& a) {
  for (std::size_t i = 0; i < 8; ++i) to[i] = a.v[i];
}
LANCER_INLINE Floats splat(float a) { return {{a, a, a, a, a, a, a, a}}; }
LANCER_INLINE Floats times_plus(Floats a, const Floats& b, const Floats& c) {
  for (std::size_t i = 0; i < 8; ++i) a.v[i] = a.v[i] * b.v[i] + c.v[i];
  return a;
}
LANCER_INLINE Floats greater(Floats a, const Floats& b) {
  for (std::size_t i = 0; i < 8; ++i) a.v[i] = a.v[i] > b.v[i] ? a.v[i] : b.v[i];
  return a;
}
LANCER_INLINE Floats lesser(Floats a, const Floats& b) {
  for (std::size_t i = 0; i < 8; ++i) a.v[i] = a.v[i] < b.v[i] ? a.v[i] : b.v[i];
  return a;
}
LANCER_INLINE unsigned at_most(const Floats& a, const Floats& b) {
  unsigned bits = 0;
  for (std::size_t i = 0; i < 8; ++i) bits |= (a.v[i] <= b.v[i] ? 1U : 0U) << i;
  return bits;
}

#endif

}  // namespace lancer::tracer::LANCER_TARGET
