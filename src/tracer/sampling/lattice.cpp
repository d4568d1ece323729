#include "tracer/sampling/lattice.hpp"

#include "tracer/sampling/stratum.hpp"

namespace lancer::tracer {

Lattice::Lattice(const Region& region)
    : left_(region.x0 - 1),
      top_(region.y0 - 1),
      columns_(region.x1 - region.x0 + 3),
      rows_(region.y1 - region.y0 + 3),
      corners_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)),
      middles_(corners_.size()) {}

void Lattice::sample(int x0, int y0, int x1, int y1, ViewTracer& tracer) {
  std::vector<ScreenPoint> points;
  std::vector<Light*> into;
  for (int y = top_ + y0; y < top_ + y1; ++y) {
    for (int x = left_ + x0; x < left_ + x1; ++x) {
      points.push_back({static_cast<double>(x), static_cast<double>(y)});
      into.push_back(&corners_[place(x, y)]);
      if (x == left_ + columns_ - 1 || y == top_ + rows_ - 1) continue;
      const ScreenPoint inside = point_in({x, y}, {});
      points.push_back({x + inside.x, y + inside.y});
      into.push_back(&middles_[place(x, y)]);
    }
  }
  std::vector<Color> colors(points.size());
  tracer.radiances(points, colors);
  for (std::size_t i = 0; i < colors.size(); ++i) *into[i] = to_light(colors[i]);
}

Color Surroundings::differences() const {
  Color sum;
  int count = 0;
  const auto add = [&](Color a, Color b) {
    sum += (a - b) * (a - b);
    ++count;
  };
  for (std::size_t y = 0; y < 4; ++y) {
    for (std::size_t x = 0; x < 4; ++x) {
      const std::size_t corner = 4 * y + x;
      if (x < 3) add(corners[corner], corners[corner + 1]);
      if (y < 3) add(corners[corner], corners[corner + 4]);
      if (x == 3 || y == 3) continue;
      add(middles[3 * y + x], corners[corner]);
      add(middles[3 * y + x], corners[corner + 5]);
    }
  }
  return sum * (1.0 / count);
}

Surroundings Lattice::around(int column, int row) const {
  Surroundings out;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      const int x = column - 1 + i, y = row - 1 + j;
      out.corners[static_cast<std::size_t>(4 * j + i)] = to_color(corner(x, y));
      if (i < 3 && j < 3) out.middles[static_cast<std::size_t>(3 * j + i)] = to_color(middle(x, y));
    }
  }
  return out;
}

}  // namespace lancer::tracer
