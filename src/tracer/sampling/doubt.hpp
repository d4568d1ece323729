#pragma once
// Which pixels the first look does not settle.

#include <array>
#include <vector>

#include "tracer/sampling/display.hpp"
#include "tracer/sampling/lattice.hpp"
#include "tracer/threads.hpp"

namespace lancer::tracer {

/// Looks at a tile of pixels. A pixel is in doubt where what is shown
/// - along one of its sides fits neither what comes before nor what comes after (an edge that passes between
///   two corners fits neither, a slope fits one of them even beside an edge: as in essentially
///   non-oscillatory interpolation, Harten and others 1987),
/// - is uneven: at the corners no bilinear function, or inside not what that says,
/// - inside a pixel, this one or one of the eight around, is unlike all four corners: something is smaller
/// than
///   a pixel, and samples may miss it,
/// - is uneven in so many of the pixels around that this one may be even by chance.
class Doubt {
 public:
  /// `limit`: differences in what is shown that do not matter.
  Doubt(const Display& display, float limit) : display_(display), limit_(limit) {}

  /// The pixels of the tile, in the whole view.
  void look(const Lattice& lattice, const Tile& tile);

  bool at(int column, int row) const { return doubtful_[place(column, row)]; }

 private:
  static constexpr std::size_t k_side = k_tile_side + 3;       // corners of the tile and a frame of one pixel
  static constexpr std::size_t k_across = 1, k_down = k_side;  // steps

  std::size_t place(int column, int row) const {
    return static_cast<std::size_t>(row - top_) * k_side + static_cast<std::size_t>(column - left_);
  }
  void read(const Lattice& lattice, const Tile& tile);
  float misfit(std::size_t from, std::size_t step) const;
  bool is_edge(std::size_t corner) const;
  bool is_twisted(std::size_t corner) const;
  bool is_lucky(std::size_t corner) const;
  void spread(int column, int row, const Tile& tile);
  bool fits_inside(std::size_t corner, int column, int row) const;
  bool hides_something(std::size_t corner) const;

  const Display& display_;
  float limit_;
  int left_ = 0, top_ = 0;
  std::array<Light, k_side * k_side> corners_{}, middles_{};  // as shown
  std::array<std::uint8_t, k_side * k_side> uneven_{};
  std::array<bool, k_side * k_side> doubtful_{};
};

}  // namespace lancer::tracer
