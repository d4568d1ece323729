#pragma once
// Where in a pixel its samples lie.

#include <cstdint>

namespace lancer::tracer {

/// A place in a pixel, both coordinates in [0, 1).
struct PixelPoint {
  double x = 0.5, y = 0.5;
};

/// Sample `index` of `count` in pixel (column, row) of the whole view. One sample is the pixel's centre; more
/// are correlated multi-jittered (Kensler 2013): stratified in x, in y and in both, for any count. Nothing
/// but integer hashes of the arguments goes into it.
PixelPoint pixel_point(int column, int row, int index, int count);

}  // namespace lancer::tracer
