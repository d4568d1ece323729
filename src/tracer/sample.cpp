#include "tracer/sample.hpp"

#include <algorithm>
#include <cmath>

#include "tracer/hash.hpp"

namespace lancer::tracer {
namespace {

/// The place of i, 0 <= i < size, in the permutation of that many that `key` chooses: a keyed bijection of
/// the next power of two, walked until it falls within the size (Kensler 2013).
Word permuted(Word i, Word size, Word key) {
  Word mask = size - 1;
  for (Word shift = 1; shift < 32; shift *= 2) mask |= mask >> shift;
  const Word a = mixed(key), b = mixed(a + 1), c = mixed(b + 1);
  do {
    i = (i ^ a) & mask;
    i = (i * ((b << 1) | 1)) & mask;
    i ^= (i >> 1) & mask;
    i = (i + c) & mask;
    i = (i * 0x6935FA69U) & mask;
    i ^= ((i & mask) >> 2) & mask;
    i = (i ^ (b >> 16)) & mask;
    i = (i * ((c << 1) | 1)) & mask;
    i ^= i >> 1;
  } while (i >= size);
  return (i + key) % size;
}

}  // namespace

PixelPoint pixel_point(int column, int row, int index, int count) {
  if (count <= 1) return {};
  const auto n = static_cast<Word>(count);
  const Word key = hash(static_cast<Word>(column), static_cast<Word>(row));
  const auto across = std::max(Word{1}, static_cast<Word>(std::sqrt(static_cast<double>(n))));
  const Word down = (n + across - 1) / across;
  const Word s = permuted(static_cast<Word>(index), n, hash(key, 1));
  const Word sx = permuted(s % across, across, hash(key, 2));
  const Word sy = permuted(s / across, down, hash(key, 3));
  const double jitter_x = fraction(hash(s, hash(key, 4)));
  const double jitter_y = fraction(hash(s, hash(key, 5)));
  const double x = (sx + (sy + jitter_x) / down) / across;
  const double y = (s + jitter_y) / n;
  constexpr double k_below_one = 1 - 0x1p-53;
  return {std::min(x, k_below_one), std::min(y, k_below_one)};
}

}  // namespace lancer::tracer
