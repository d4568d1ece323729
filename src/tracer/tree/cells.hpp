#pragma once
// Boxes as whole numbers of 16 bits, the cells of a grid that is laid over what is being built. They only
// decide how a tree is cut, which need not be exact; a box and its item's number fill one register of any
// processor.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace lancer::tracer {

/// Eight whole numbers.
struct Cells {
#if defined(__SSE2__)
  __m128i v;
#else
  std::array<std::int16_t, 8> v;
#endif
};

#if defined(__SSE2__)

inline Cells cells_from(const std::array<std::int16_t, 8>& from) {
  return {_mm_loadu_si128(reinterpret_cast<const __m128i*>(from.data()))};
}
inline std::array<std::int16_t, 8> values(Cells a) {
  std::array<std::int16_t, 8> out;
  _mm_storeu_si128(reinterpret_cast<__m128i*>(out.data()), a.v);
  return out;
}
inline Cells cells_of(std::int16_t value) { return {_mm_set1_epi16(value)}; }
inline Cells lesser(Cells a, Cells b) { return {_mm_min_epi16(a.v, b.v)}; }
inline Cells greater(Cells a, Cells b) { return {_mm_max_epi16(a.v, b.v)}; }
/// In the first three places half the sum of a box's sides, rounded.
inline Cells center(Cells box) {
  const __m128i half = _mm_srai_epi16(box.v, 1);
  return {_mm_sub_epi16(half, _mm_srli_si128(half, 6))};
}
/// (a - least) scale / 2^16 in the first three places, for a >= least.
inline std::array<std::size_t, 3> scaled(Cells a, Cells least, Cells scale) {
  const __m128i s = _mm_mulhi_epu16(_mm_sub_epi16(a.v, least.v), scale.v);
  return {static_cast<std::size_t>(_mm_extract_epi16(s, 0)),
          static_cast<std::size_t>(_mm_extract_epi16(s, 1)),
          static_cast<std::size_t>(_mm_extract_epi16(s, 2))};
}

#else

inline Cells cells_from(const std::array<std::int16_t, 8>& from) { return {from}; }
inline std::array<std::int16_t, 8> values(const Cells& a) { return a.v; }
inline Cells cells_of(std::int16_t value) {
  return {{value, value, value, value, value, value, value, value}};
}
inline Cells lesser(Cells a, const Cells& b) {
  for (std::size_t i = 0; i < 8; ++i) a.v[i] = std::min(a.v[i], b.v[i]);
  return a;
}
inline Cells greater(Cells a, const Cells& b) {
  for (std::size_t i = 0; i < 8; ++i) a.v[i] = std::max(a.v[i], b.v[i]);
  return a;
}
/// In the first three places half the sum of a box's sides, rounded.
inline Cells center(Cells box) {
  for (std::size_t i = 0; i < 3; ++i) {
    box.v[i] = static_cast<std::int16_t>((box.v[i] >> 1) - (box.v[i + 3] >> 1));
  }
  return box;
}
/// (a - least) scale / 2^16 in the first three places, for a >= least.
inline std::array<std::size_t, 3> scaled(const Cells& a, const Cells& least, const Cells& scale) {
  std::array<std::size_t, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto more = static_cast<std::uint16_t>(a.v[i] - least.v[i]);
    out[i] = std::size_t{more} * static_cast<std::uint16_t>(scale.v[i]) >> 16;
  }
  return out;
}

#endif

/// A box in cells. So that the lesser of two is what holds both, the upper sides have all their bits turned.
/// The last two places hold an item's number, or nothing.
struct CellBox {
  Cells cells = cells_of(INT16_MAX);

  void add(CellBox box) { cells = lesser(cells, box.cells); }
  /// How many cells it is wide, along each axis.
  std::array<float, 3> size() const {
    const auto v = values(cells);
    const auto width = [](int lo, int turned_hi) { return static_cast<float>(-1 - turned_hi - lo); };
    return {width(v[0], v[3]), width(v[1], v[4]), width(v[2], v[5])};
  }
  float half_area() const {
    const auto [x, y, z] = size();
    return x * y + y * z + z * x;
  }
};

}  // namespace lancer::tracer
