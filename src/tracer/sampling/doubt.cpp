#include "tracer/sampling/doubt.hpp"

#include <algorithm>
#include <cmath>

#include "tracer/sampling/stratum.hpp"

namespace lancer::tracer {
namespace {

constexpr std::size_t k_channels = 3;
constexpr int k_most = 4;  // uneven pixels around one that is sure all the same

Light shown(const Display& display, const Light& light) {
  return {display.shown(light[0]), display.shown(light[1]), display.shown(light[2])};
}

}  // namespace

void Doubt::read(const Lattice& lattice, const Tile& tile) {
  left_ = tile.x0 - 1;
  top_ = tile.y0 - 1;
  for (int y = top_; y <= tile.y1 + 1; ++y) {
    for (int x = left_; x <= tile.x1 + 1; ++x) {
      corners_[place(x, y)] = shown(display_, lattice.corner(x, y));
      middles_[place(x, y)] = shown(display_, lattice.middle(x, y));
    }
  }
}

/// How far the side from that corner on is from being continued before or after it, whichever is less.
float Doubt::misfit(std::size_t from, std::size_t step) const {
  float most = 0;
  for (std::size_t c = 0; c < k_channels; ++c) {
    const float before = corners_[from - step][c], begin = corners_[from][c], end = corners_[from + step][c],
                after = corners_[from + 2 * step][c];
    most = std::max(most, std::min(std::fabs(end - 2 * begin + before), std::fabs(after - 2 * end + begin)));
  }
  return most;
}

/// Does one of the pixel's sides fit neither neighbour?
bool Doubt::is_edge(std::size_t corner) const {
  return misfit(corner, k_across) > limit_ || misfit(corner + k_down, k_across) > limit_ ||
         misfit(corner, k_down) > limit_ || misfit(corner + k_across, k_down) > limit_;
}

/// Are the four corners those of a bilinear function?
bool Doubt::is_twisted(std::size_t corner) const {
  for (std::size_t c = 0; c < k_channels; ++c) {
    const float twist = corners_[corner][c] - corners_[corner + k_across][c] - corners_[corner + k_down][c] +
                        corners_[corner + k_down + k_across][c];
    if (std::fabs(twist) > limit_) return true;
  }
  return false;
}

/// Is what is seen inside what the corners say, interpolated?
bool Doubt::fits_inside(std::size_t corner, int column, int row) const {
  const ScreenPoint at = point_in({column, row}, {});
  const float x = static_cast<float>(at.x), y = static_cast<float>(at.y);
  for (std::size_t c = 0; c < k_channels; ++c) {
    const float above = corners_[corner][c] + x * (corners_[corner + k_across][c] - corners_[corner][c]);
    const float below = corners_[corner + k_down][c] +
                        x * (corners_[corner + k_down + k_across][c] - corners_[corner + k_down][c]);
    if (std::fabs(middles_[corner][c] - (above + y * (below - above))) > limit_) return false;
  }
  return true;
}

/// Is there something inside that is unlike all corners?
bool Doubt::hides_something(std::size_t corner) const {
  for (std::size_t c = 0; c < k_channels; ++c) {
    const auto [low, high] =
        std::minmax({corners_[corner][c], corners_[corner + k_across][c], corners_[corner + k_down][c],
                     corners_[corner + k_down + k_across][c]});
    if (middles_[corner][c] < low - limit_ || middles_[corner][c] > high + limit_) return true;
  }
  return false;
}

/// Are so many of the eight pixels around uneven that this one may be even by chance? Along a straight edge
/// there are at most three beside one.
bool Doubt::is_lucky(std::size_t corner) const {
  int count = 0;
  for (const std::size_t row : {corner - k_down, corner, corner + k_down}) {
    count += uneven_[row - 1] + uneven_[row] + uneven_[row + 1];
  }
  return count - uneven_[corner] >= k_most;
}

void Doubt::look(const Lattice& lattice, const Tile& tile) {
  read(lattice, tile);
  doubtful_.fill(false);
  for (int y = top_; y <= tile.y1; ++y) {
    for (int x = left_; x <= tile.x1; ++x) {
      const std::size_t corner = place(x, y);
      uneven_[corner] = is_twisted(corner) || !fits_inside(corner, x, y) ? 1 : 0;
    }
  }
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      const std::size_t corner = place(x, y);
      doubtful_[corner] = uneven_[corner] != 0 || is_edge(corner) || is_lucky(corner);
    }
  }
  for (int y = top_; y <= tile.y1; ++y) {
    for (int x = left_; x <= tile.x1; ++x) {
      if (hides_something(place(x, y))) spread(x, y, tile);
    }
  }
}

/// To the pixel and those around it.
void Doubt::spread(int column, int row, const Tile& tile) {
  for (int y = std::max(row - 1, tile.y0); y <= std::min(row + 1, tile.y1 - 1); ++y) {
    for (int x = std::max(column - 1, tile.x0); x <= std::min(column + 1, tile.x1 - 1); ++x) {
      doubtful_[place(x, y)] = true;
    }
  }
}

}  // namespace lancer::tracer
