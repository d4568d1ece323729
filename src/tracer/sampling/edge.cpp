#include "tracer/sampling/edge.hpp"

#include <algorithm>
#include <cmath>

namespace lancer::tracer {
namespace {

// Light is a side's where it differs from that by no more than this part of the contrast.
constexpr double k_likeness = 0.2;
// Parts of the error, that each of these may take: where the edge meets the pixel's sides, its being bent in
// between, and how the light changes on either side. They do not add up: all are bounds, and independent.
constexpr double k_ends = 0.7, k_bulge = 0.7, k_shading = 0.5;
// So many of the 25 samples of the first look in and around the pixel must lie on the right side of the line.
constexpr int k_agree = 21;
constexpr double k_farthest = 0.25;  // from the line, where its bend is looked for, pixels

constexpr std::array<std::size_t, 4> k_clockwise{0, 1, 3, 2};
constexpr std::array<ScreenPoint, 4> k_corner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

double distance(Color a, Color b) {
  const Color d = a - b;
  return std::sqrt(d.r * d.r + d.g * d.g + d.b * d.b);
}

double shown_distance(const Display& display, Color a, Color b) {
  const auto of = [&](double x, double y) {
    return std::fabs(
        static_cast<double>(display.shown(static_cast<float>(x)) - display.shown(static_cast<float>(y))));
  };
  return std::max({of(a.r, b.r), of(a.g, b.g), of(a.b, b.b)});
}

}  // namespace

Edge::Side Edge::side_of(Color color) const {
  const double near = k_likeness * distance(a_, b_);
  if (distance(color, a_) <= near) return Side::a;
  return distance(color, b_) <= near ? Side::b : Side::neither;
}

/// Two corners that differ the most stand for the sides.
bool Edge::find_sides(const std::array<Color, 4>& corners) {
  for (std::size_t i = 0; i < 4; ++i) around_[i] = corners[k_clockwise[i]];
  double most = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) {
      const double apart = distance(around_[i], around_[j]);
      if (apart <= most) continue;
      most = apart;
      a_ = around_[i];
      b_ = around_[j];
    }
  }
  if (most == 0) return false;
  std::size_t crossed = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    labels_[i] = side_of(around_[i]);
    if (labels_[i] == Side::neither) return false;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    if (labels_[i] == labels_[next]) continue;
    if (crossed == 2) return false;
    const bool from_a = labels_[i] == Side::a;
    const std::size_t a = from_a ? i : next, b = from_a ? next : i;
    sides_[crossed] = i;
    crossings_[crossed++] = {k_corner[a], k_corner[b], around_[a], around_[b], 1};
  }
  return true;
}

void Edge::begin(const PixelKey& pixel, const Surroundings& around, const Demand& demand) {
  pixel_ = pixel;
  stage_ = Stage::failed;
  wanted_ = 0;
  if (!find_sides(around.own_corners())) return;
  if (side_of(around.own_middle()) == Side::neither) return;
  surroundings_ = around;
  if (shown_distance(*demand.display, a_, b_) > demand.error) stage_ = Stage::bisecting;
}

void Edge::want(ScreenPoint at, std::vector<ScreenPoint>& points) {
  points.push_back({pixel_.column + at.x, pixel_.row + at.y});
  ++wanted_;
}

/// How much the pixel changes, display units, where so much of its area is taken for the other side's.
double Edge::loss(double area, const Display& display) const {
  const double part = area_of_a();
  const auto of = [&](double a, double b) {
    return static_cast<double>(display.change(a * part + b * (1 - part), std::fabs(a - b) * area));
  };
  return std::max({of(a_.r, b_.r), of(a_.g, b_.g), of(a_.b, b_.b)});
}

/// Asks for the middle of the wider crossings. False: they are small enough.
bool Edge::bisect(const Demand& demand, std::vector<ScreenPoint>& points) {
  const double unsure = (crossings_[0].width + crossings_[1].width) / 4;
  const double lost = loss(unsure, *demand.display);
  if (lost <= k_ends * demand.error) {
    allowed_ = lost > 0 ? unsure * demand.error / lost : 1;
    return false;
  }
  const double widest = std::max(crossings_[0].width, crossings_[1].width);
  for (std::size_t i = 0; i < 2; ++i) {
    if (crossings_[i].width < widest) continue;
    bisected_[wanted_] = i;
    want(crossings_[i].middle(), points);
  }
  return true;
}

/// Asks on both sides of the line's middle, as far away as it may be bent.
void Edge::check_middle(std::vector<ScreenPoint>& points) {
  const ScreenPoint p = crossings_[0].middle(), q = crossings_[1].middle();
  const double dx = q.x - p.x, dy = q.y - p.y, length = std::sqrt(dx * dx + dy * dy);
  const double bulge = std::min(k_farthest, 1.5 * k_bulge * allowed_ / length);
  const ScreenPoint normal{-dy / length * bulge, dx / length * bulge};
  const ScreenPoint middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
  // Towards the first side.
  const ScreenPoint to_a{crossings_[0].a.x - crossings_[0].b.x, crossings_[0].a.y - crossings_[0].b.y};
  const double turn = to_a.x * normal.x + to_a.y * normal.y >= 0 ? 1 : -1;
  want({middle.x + turn * normal.x, middle.y + turn * normal.y}, points);
  want({middle.x - turn * normal.x, middle.y - turn * normal.y}, points);
}

Edge::State Edge::refine(const Demand& demand, std::vector<ScreenPoint>& points) {
  const bool was_checking = stage_ == Stage::checking;
  wanted_ = 0;
  if (stage_ == Stage::failed) return State::other;
  if (was_checking) return conclude(demand);
  if (bisect(demand, points)) return State::asking;
  stage_ = Stage::checking;
  check_middle(points);
  return State::asking;
}

void Edge::take(std::span<const Color> colors) {
  if (stage_ == Stage::checking) {
    if (side_of(colors[0]) != Side::a || side_of(colors[1]) != Side::b) stage_ = Stage::failed;
    return;
  }
  for (std::size_t i = 0; i < wanted_; ++i) {
    Crossing& crossing = crossings_[bisected_[i]];
    const Side side = side_of(colors[i]);
    if (side == Side::neither) stage_ = Stage::failed;
    (side == Side::a ? crossing.a : crossing.b) = crossing.middle();
    (side == Side::a ? crossing.at_a : crossing.at_b) = colors[i];
    crossing.width /= 2;
  }
}

/// Of the polygon on the first side (by the shoelace formula).
double Edge::area_of_a() const {
  std::array<ScreenPoint, 6> polygon;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (labels_[i] == Side::a) polygon[count++] = k_corner[i];
    for (std::size_t k = 0; k < 2; ++k) {
      if (sides_[k] == i) polygon[count++] = crossings_[k].middle();
    }
  }
  double twice = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const ScreenPoint p = polygon[i], q = polygon[(i + 1) % count];
    twice += p.x * q.y - q.x * p.y;
  }
  return std::fabs(twice) / 2;
}

/// Do the samples of the first look lie on the sides of the line that they should lie on? The pixel's own
/// must, and most of those around it.
bool Edge::goes_on_around() const {
  const ScreenPoint p = crossings_[0].middle(), q = crossings_[1].middle();
  const double dx = q.x - p.x, dy = q.y - p.y, length = std::sqrt(dx * dx + dy * dy);
  const auto beyond = [&](ScreenPoint r) { return (dx * (r.y - p.y) - dy * (r.x - p.x)) / length; };
  const double turn = beyond(crossings_[0].a) >= beyond(crossings_[0].b) ? 1 : -1;
  int agree = 0;
  const auto agrees = [&](ScreenPoint at, Color color) {
    const Side side = side_of(color);
    const double off = side == Side::a ? -turn * beyond(at) : turn * beyond(at);
    return side != Side::neither && off <= allowed_;
  };
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      agree += agrees({x - 1.0, y - 1.0}, surroundings_.corners[static_cast<std::size_t>(4 * y + x)]) ? 1 : 0;
      if (x == 3 || y == 3) continue;
      const ScreenPoint in = point_in({pixel_.column + x - 1, pixel_.row + y - 1}, {});
      const bool right =
          agrees({x - 1 + in.x, y - 1 + in.y}, surroundings_.middles[static_cast<std::size_t>(3 * y + x)]);
      if (x == 1 && y == 1 && !right) return false;
      agree += right ? 1 : 0;
    }
  }
  return agree >= k_agree;
}

/// The mean light on a side, from the corners and the places on the pixel's sides that are known to be on it;
/// none where it differs by too much for the side's part of the pixel.
std::optional<Color> Edge::light_on(Side side, double part, const Demand& demand) const {
  const auto at = [&](const Crossing& crossing) { return side == Side::a ? crossing.at_a : crossing.at_b; };
  Color sum;
  int count = 0;
  double range = 0;
  const auto add = [&](Color color) {
    sum += color;
    ++count;
    range = std::max(range, shown_distance(*demand.display, color, at(crossings_[0])));
  };
  for (std::size_t i = 0; i < 4; ++i) {
    if (labels_[i] == side) add(around_[i]);
  }
  for (const Crossing& crossing : crossings_) add(at(crossing));
  if (range / 2 * part > k_shading * demand.error) return std::nullopt;
  return sum * (1.0 / count);
}

Edge::State Edge::conclude(const Demand& demand) {
  const double area = area_of_a();
  const std::optional<Color> a = light_on(Side::a, area, demand), b = light_on(Side::b, 1 - area, demand);
  if (!a || !b || !goes_on_around()) return State::other;
  mean_ = *a * area + *b * (1 - area);
  return State::found;
}

}  // namespace lancer::tracer
