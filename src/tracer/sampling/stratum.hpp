#pragma once
// The squares that a pixel is cut into, and where each has its sample.

#include "tracer/hash.hpp"
#include "tracer/view_tracer.hpp"

namespace lancer::tracer {

/// One of 4^level equal squares of a pixel.
struct Stratum {
  int level = 0;
  int column = 0, row = 0;  // from 0 to 2^level - 1

  double side() const { return 1.0 / static_cast<double>(1 << level); }
};

/// A pixel of the whole view, and what makes its random numbers its own.
struct PixelKey {
  int column = 0, row = 0;
  Word key = 0;

  PixelKey(int column_in, int row_in)
      : column(column_in), row(row_in), key(hash(static_cast<Word>(column_in), static_cast<Word>(row_in))) {}
};

/// A point of the square, from the pixel's corner, uniformly distributed: a hash of pixel and square.
inline ScreenPoint point_in(const PixelKey& pixel, const Stratum& s) {
  const Word place =
      static_cast<Word>(s.level) << 28 | static_cast<Word>(s.row) << 14 | static_cast<Word>(s.column);
  const Word x = hash(place, pixel.key), y = mixed(x ^ 0x68E31DA4U);
  return {(s.column + fraction(x)) * s.side(), (s.row + fraction(y)) * s.side()};
}

}  // namespace lancer::tracer
