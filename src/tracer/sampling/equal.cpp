#include "tracer/sampling/equal.hpp"

#include "tracer/sample.hpp"
#include "tracer/sampling/put.hpp"

namespace lancer::tracer {

void EqualDrawer::draw(const Tile& tile, image::Image& image) {
  const Region& region = tracer_.job().region;
  const auto n = static_cast<std::size_t>(samples_);
  points_.resize(n);
  colors_.resize(n);
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      const int column = region.x0 + x, row = region.y0 + y;
      for (int i = 0; i < samples_; ++i) {
        const PixelPoint at = pixel_point(column, row, i, samples_);
        points_[static_cast<std::size_t>(i)] = {column + at.x, row + at.y};
      }
      tracer_.radiances(points_, colors_);
      // A pixel that was cut short stays black.
      if (tracer_.job().tracing.cancelled()) return;
      Color sum;
      for (const Color& color : colors_) sum += color;
      put(image, x, y, {sum.r / samples_, sum.g / samples_, sum.b / samples_});
    }
  }
}

}  // namespace lancer::tracer
