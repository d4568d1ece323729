#pragma once
// So many samples in every pixel.

#include <vector>

#include "image/image.hpp"
#include "tracer/threads.hpp"

namespace lancer::tracer {

/// One thread's.
class EqualDrawer {
 public:
  EqualDrawer(ViewTracer& tracer, int samples) : tracer_(tracer), samples_(samples) {}

  /// Draws the pixels of a tile of the region; with nothing of use where the job is cancelled.
  void draw(const Tile& tile, image::Image& image);

 private:
  struct Pixel {
    int x = 0, y = 0;
  };

  /// The tile's pixels, in squares, so that those of rays that go together are near each other.
  void arrange(const Tile& tile);

  ViewTracer& tracer_;
  int samples_;
  // One for each pixel of the tile.
  std::vector<Pixel> pixels_;
  std::vector<ScreenPoint> points_;
  std::vector<Color> colors_, sums_;
};

}  // namespace lancer::tracer
