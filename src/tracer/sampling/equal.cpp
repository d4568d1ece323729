#include "tracer/sampling/equal.hpp"

#include <algorithm>

#include "tracer/sample.hpp"
#include "tracer/sampling/put.hpp"

namespace lancer::tracer {

void EqualDrawer::draw(const Tile& tile, image::Image& image) {
  arrange(tile);
  points_.resize(pixels_.size());
  colors_.resize(pixels_.size());
  const Region& region = tracer_.job().region;
  sums_.assign(samples_ > 1 ? pixels_.size() : 0, {});
  for (int sample = 0; sample < samples_; ++sample) {
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const int column = region.x0 + pixels_[i].x, row = region.y0 + pixels_[i].y;
      const PixelPoint at = samples_ > 1 ? pixel_point(column, row, sample, samples_) : PixelPoint{};
      points_[i] = {column + at.x, row + at.y};
    }
    tracer_.radiances(points_, colors_);
    // A tile that was cut short stays black.
    if (tracer_.job().tracing.cancelled()) return;
    for (std::size_t i = 0; i < sums_.size(); ++i) sums_[i] += colors_[i];
  }
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const Color sum = sums_[i];
    colors_[i] = {sum.r / samples_, sum.g / samples_, sum.b / samples_};
  }
  for (std::size_t i = 0; i < pixels_.size(); ++i)
    put(image, pixels_[i].x, pixels_[i].y, Color{} + colors_[i]);
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
