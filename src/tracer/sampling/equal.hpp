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
  ViewTracer& tracer_;
  int samples_;
  std::vector<ScreenPoint> points_;
  std::vector<Color> colors_;
};

}  // namespace lancer::tracer
