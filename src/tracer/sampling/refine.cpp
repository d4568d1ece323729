#include "tracer/sampling/refine.hpp"

#include "tracer/sampling/put.hpp"

namespace lancer::tracer {
namespace {

// Differences of up to so many times the error do not matter in the first look: a pixel's mean is off by no
// more than about half the difference.
constexpr double k_limit = 1.5;

}  // namespace

RefiningDrawer::RefiningDrawer(ViewTracer& tracer, const Lattice& lattice, const Demand& demand)
    : tracer_(tracer),
      lattice_(lattice),
      demand_(demand),
      doubt_(*demand.display, static_cast<float>(k_limit * demand.error)) {}

void RefiningDrawer::draw(const Tile& tile, image::Image& image) {
  const Region& region = tracer_.job().region;
  const Tile in_view{tile.x0 + region.x0, tile.y0 + region.y0, tile.x1 + region.x0, tile.y1 + region.y0};
  doubt_.look(lattice_, in_view);
  open_ = 0;
  settle(in_view, image);
  refine_all();
  if (tracer_.job().tracing.cancelled()) return;
  Stats& stats = tracer_.stats();
  stats.refined_pixels += open_;
  for (std::size_t i = 0; i < open_; ++i) {
    const Open& pixel = pixels_[i];
    stats.edge_pixels += pixel.has_edge ? 1 : 0;
    put(image, pixel.column - region.x0, pixel.row - region.y0, pixel.mean());
  }
}

/// Colours the pixels that are in no doubt; opens the others.
void RefiningDrawer::settle(const Tile& tile, image::Image& image) {
  const Region& region = tracer_.job().region;
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      if (!doubt_.at(x, y)) {
        put(image, x - region.x0, y - region.y0, lattice_.mean_of_corners(x, y));
        continue;
      }
      Open& pixel = next_open();
      pixel.column = x;
      pixel.row = y;
      pixel.has_edge = true;
      pixel.edge.begin({x, y}, lattice_.around(x, y), demand_);
    }
  }
}

RefiningDrawer::Open& RefiningDrawer::next_open() {
  if (open_ == pixels_.size()) pixels_.emplace_back();
  return pixels_[open_++];
}

/// Puts the points that the pixel wants next into `points_`. False: it wants no more.
bool RefiningDrawer::refine(Open& pixel) {
  if (pixel.has_edge) {
    const Edge::State state = pixel.edge.refine(demand_, points_);
    if (state != Edge::State::other) return state == Edge::State::asking;
    pixel.has_edge = false;
    pixel.strata.begin({pixel.column, pixel.row}, lattice_.around(pixel.column, pixel.row));
  }
  return pixel.strata.refine(demand_, points_);
}

void RefiningDrawer::refine_all() {
  asking_.clear();
  for (std::size_t i = 0; i < open_; ++i) asking_.push_back(&pixels_[i]);
  while (!asking_.empty() && !tracer_.job().tracing.cancelled()) {
    points_.clear();
    std::erase_if(asking_, [&](Open* pixel) { return !refine(*pixel); });
    colors_.resize(points_.size());
    tracer_.radiances(points_, colors_);
    std::span<const Color> left(colors_);
    for (Open* pixel : asking_) {
      const std::size_t wanted = pixel->has_edge ? pixel->edge.wanted() : pixel->strata.wanted();
      pixel->has_edge ? pixel->edge.take(left.first(wanted)) : pixel->strata.take(left.first(wanted));
      left = left.subspan(wanted);
    }
  }
}

}  // namespace lancer::tracer
