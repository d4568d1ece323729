#include "tracer/sampling/strata.hpp"

#include <algorithm>
#include <cmath>

namespace lancer::tracer {
namespace {

constexpr int k_deepest = 7;  // level of the smallest squares
constexpr int k_first = 2;    // level that is reached everywhere before any square is left as it is
// How much the first look around counts in what is usual for the pixel, in leaves; and the usual, in a leaf's
// neighbours. Measured, as is the next: with less, pixels that were lucky with their first samples stay
// wrong.
constexpr double k_around = 4;
constexpr double k_usual = 1;
// So many standard deviations of a pixel's mean must be within the error: 99 pixels in 100 then are, though
// the estimate comes from few samples and is itself one.
constexpr double k_safety = 2.3;

Color squared(Color c) { return c * c; }

}  // namespace

void Strata::begin(const PixelKey& pixel, const Surroundings& around) {
  pixel_ = pixel;
  corners_ = around.own_corners();
  around_ = around.differences();
  leaves_.clear();
  leaves_.push_back({{}, point_in(pixel, {}), around.own_middle(), {}, {}});
  wanted_ = 0;
  deepest_ = 0;
}

void Strata::take(std::span<const Color> colors) {
  const std::size_t first = leaves_.size() - wanted_;
  for (std::size_t i = 0; i < wanted_; ++i) leaves_[first + i].color = colors[i];
}

Color Strata::mean() const {
  Color sum;
  for (const Leaf& leaf : leaves_) sum += leaf.color * (leaf.square.side() * leaf.square.side());
  return sum;
}

/// In four: one keeps the sample, the others want one.
void Strata::cut(std::size_t index, std::vector<ScreenPoint>& points) {
  const Leaf whole = leaves_[index];
  const int level = whole.square.level + 1;
  deepest_ = std::max(deepest_, level);
  const double parts = 1 << level;
  const Stratum own{level, static_cast<int>(whole.at.x * parts), static_cast<int>(whole.at.y * parts)};
  leaves_[index].square = own;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Stratum square{level, 2 * whole.square.column + quarter % 2, 2 * whole.square.row + quarter / 2};
    if (square.column == own.column && square.row == own.row) continue;
    const ScreenPoint at = point_in(pixel_, square);
    leaves_.push_back({square, at, {}, {}, {}});
    points.push_back({pixel_.column + at.x, pixel_.row + at.y});
    ++wanted_;
  }
}

void Strata::draw_map() {
  const std::size_t side = std::size_t{1} << deepest_;
  map_.resize(side * side);
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    const Stratum& s = leaves_[i].square;
    const int shift = deepest_ - s.level;
    const std::size_t size = std::size_t{1} << shift;
    const std::size_t x = static_cast<std::size_t>(s.column) << shift, y = static_cast<std::size_t>(s.row)
                                                                           << shift;
    for (std::size_t j = y; j < y + size; ++j) {
      const auto row = map_.begin() + static_cast<std::ptrdiff_t>(j * side + x);
      std::fill_n(row, size, static_cast<std::uint16_t>(i));
    }
  }
}

/// Mean square, from those across the middle of each side, and from the pixel's corner.
Color Strata::differences_of(std::size_t index) const {
  const Leaf& leaf = leaves_[index];
  const int side = 1 << deepest_, shift = deepest_ - leaf.square.level, size = 1 << shift;
  const int x = leaf.square.column << shift, y = leaf.square.row << shift, half = size / 2;
  Color sum;
  int count = 0;
  const auto compare = [&](int i, int j) {
    if (i < 0 || j < 0 || i >= side || j >= side) return;
    sum += squared(leaf.color - leaves_[map_[static_cast<std::size_t>(j * side + i)]].color);
    ++count;
  };
  compare(x - 1, y + half);
  compare(x + size, y + half);
  compare(x + half, y - 1);
  compare(x + half, y + size);
  const bool left = x == 0, right = x + size == side, top = y == 0, bottom = y + size == side;
  if ((left || right) && (top || bottom)) {
    sum += squared(leaf.color - corners_[(right ? 1U : 0U) + (bottom ? 2U : 0U)]);
    ++count;
  }
  return sum * (1.0 / count);
}

/// Half the mean square of the differences from the neighbours is the variance of a point at random in the
/// leaf and them together. A leaf that is like its few neighbours may be so by chance where other parts of
/// the pixel, and pixels around it, are not: their differences count as those of one more neighbour.
Color Strata::measure_spread() {
  Color all;
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    Leaf& leaf = leaves_[i];
    leaf.differences = differences_of(i);
    all += leaf.differences * (leaf.square.side() * leaf.square.side());
  }
  const auto count = static_cast<double>(leaves_.size());
  const Color usual = (all * count + around_ * k_around) * (1 / (count + k_around));
  Color variance;
  for (Leaf& leaf : leaves_) {
    const double area = leaf.square.side() * leaf.square.side();
    leaf.spread = (leaf.differences + usual * k_usual) * (area * area / 2 / (1 + k_usual));
    variance += leaf.spread;
  }
  return variance;
}

double Strata::estimate(const Display& display) {
  draw_map();
  const Color variance = measure_spread();
  const Color at = mean();
  const Color off{std::sqrt(variance.r), std::sqrt(variance.g), std::sqrt(variance.b)};
  const Color seen{display.change(at.r, off.r), display.change(at.g, off.g), display.change(at.b, off.b)};
  const auto slope = [](double shown, double variance_of) {
    return variance_of > 0 ? shown * shown / variance_of : 0;
  };
  const Color slopes{slope(seen.r, variance.r), slope(seen.g, variance.g), slope(seen.b, variance.b)};
  for (Leaf& leaf : leaves_) leaf.weight = max_component(slopes * leaf.spread);
  return max_component(seen);
}

/// Those leaves are cut whose part in the variance is above what is left for each of as many as count.
bool Strata::refine(const Demand& demand, std::vector<ScreenPoint>& points) {
  wanted_ = 0;
  if (leaves_.size() == 1) {
    cut(0, points);
    return true;
  }
  const double error = k_safety * estimate(*demand.display);
  if (error <= demand.error) return false;
  double sum = 0, squares = 0;
  for (const Leaf& leaf : leaves_) {
    sum += leaf.weight;
    squares += leaf.weight * leaf.weight;
  }
  const double part = demand.error / error;
  const double limit = part * part * squares / sum;
  const std::size_t count = leaves_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const int level = leaves_[i].square.level;
    if (level < k_first || (leaves_[i].weight > limit && level < k_deepest)) cut(i, points);
  }
  return wanted_ > 0;
}

}  // namespace lancer::tracer
