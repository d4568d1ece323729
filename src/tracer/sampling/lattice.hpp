#pragma once
// The first look at a picture: a sample at each corner of a pixel, which its neighbours share, and one
// somewhere inside. So a pixel that nothing happens in costs two samples and has been looked at in five
// places.

#include <array>
#include <vector>

#include "tracer/options.hpp"
#include "tracer/view_tracer.hpp"

namespace lancer::tracer {

using Light = std::array<float, 3>;  // linear, r g b

inline Light to_light(Color c) {
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

inline Color to_color(const Light& light) {
  return {static_cast<double>(light[0]), static_cast<double>(light[1]), static_cast<double>(light[2])};
}

/// What the first look knows in and around a pixel: the samples at the corners of 3 x 3 pixels and inside
/// them, row by row, the pixel in the middle.
struct Surroundings {
  std::array<Color, 16> corners;
  std::array<Color, 9> middles;

  /// The pixel's own: upper left, upper right, lower left, lower right.
  std::array<Color, 4> own_corners() const { return {corners[5], corners[6], corners[9], corners[10]}; }
  Color own_middle() const { return middles[4]; }
  /// The mean square between neighbouring corners, and between those and the samples inside.
  Color differences() const;
};

/// The samples of a region and of a frame of one pixel around it, so that what is said of a pixel is the same
/// in every region that it lies in.
class Lattice {
 public:
  explicit Lattice(const Region& region);

  /// Corners a row, and rows of them: the pixels of region and frame, and one more.
  int columns() const { return columns_; }
  int rows() const { return rows_; }

  /// Takes the samples of the corners [x0, x1) x [y0, y1), and those inside the pixels right and down of
  /// them. Different threads may take different ones at the same time.
  void sample(int x0, int y0, int x1, int y1, ViewTracer& tracer);

  /// The upper left corner of the pixel in that column and row of the whole view.
  const Light& corner(int column, int row) const { return corners_[place(column, row)]; }
  /// The sample inside it, which is at point_in(its key, {}).
  const Light& middle(int column, int row) const { return middles_[place(column, row)]; }

  Surroundings around(int column, int row) const;
  Color mean_of_corners(int column, int row) const {
    return (to_color(corner(column, row)) + to_color(corner(column + 1, row)) +
            to_color(corner(column, row + 1)) + to_color(corner(column + 1, row + 1))) *
           0.25;
  }

 private:
  std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(row - top_) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column - left_);
  }

  int left_, top_, columns_, rows_;
  std::vector<Light> corners_, middles_;
};

}  // namespace lancer::tracer
