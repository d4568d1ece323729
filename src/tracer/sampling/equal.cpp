#include "tracer/sampling/equal.hpp"

#include <algorithm>

#include "tracer/sample.hpp"
#include "tracer/sampling/put.hpp"

namespace lancer::tracer {

void EqualDrawer::draw(const Tile& tile, image::Image& image) {
  arrange(tile);
  sums_.assign(pixels_.size(), {});
  points_.resize(pixels_.size());
  colors_.resize(pixels_.size());
  const Region& region = tracer_.job().region;
  for (int sample = 0; sample < samples_; ++sample) {
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const int column = region.x0 + pixels_[i].x, row = region.y0 + pixels_[i].y;
      const PixelPoint at = pixel_point(column, row, sample, samples_);
      points_[i] = {column + at.x, row + at.y};
    }
    tracer_.radiances(points_, colors_);
    // A tile that was cut short stays black.
    if (tracer_.job().tracing.cancelled()) return;
    for (std::size_t i = 0; i < pixels_.size(); ++i) sums_[i] += colors_[i];
  }
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const Color sum = sums_[i];
    put(image, pixels_[i].x, pixels_[i].y, {sum.r / samples_, sum.g / samples_, sum.b / samples_});
  }
}

void EqualDrawer::arrange(const Tile& tile) {
  constexpr int k_square = 4;
  pixels_.clear();
  for (int y0 = tile.y0; y0 < tile.y1; y0 += k_square) {
    for (int x0 = tile.x0; x0 < tile.x1; x0 += k_square) {
      for (int y = y0; y < std::min(y0 + k_square, tile.y1); ++y)
        for (int x = x0; x < std::min(x0 + k_square, tile.x1); ++x) pixels_.push_back({x, y});
    }
  }
}

}  // namespace lancer::tracer
