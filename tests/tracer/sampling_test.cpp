// Pictures that are drawn until an error is reached, and the ways in which a pixel comes to its samples.

#include <cmath>
#include <tbb/global_control.h>

#include "base/math.hpp"
#include "build.hpp"
#include "catch.hpp"
#include "tracer/sampling/edge.hpp"
#include "tracer/sampling/strata.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

Rendered to_error(const Scene& s, const scene::View& v, double error, int threads = 1) {
  Options options;
  options.samples = 0;
  options.error = error;
  options.threads = threads;
  return render(s, v, options);
}

scene::View front(int columns, int rows) {
  scene::View v = view({0, 0.8, 5}, {0, -0.15, -1});
  v.columns = columns;
  v.rows = rows;
  return v;
}

double shown(float light) { return math::linear_to_srgb(std::fmin(1, static_cast<double>(light))); }

/// The part of the pixels that are off by no more than the error, each by its worst channel.
double part_within(const image::Image& picture, const image::Image& truth, double error) {
  int within = 0;
  for (std::size_t i = 0; i < truth.data().size(); i += 3) {
    double worst = 0;
    for (std::size_t c = i; c < i + 3; ++c)
      worst = std::fmax(worst, std::fabs(shown(picture.data()[c]) - shown(truth.data()[c])));
    within += worst <= error ? 1 : 0;
  }
  return within / (static_cast<double>(truth.data().size()) / 3);
}

const Display k_display(1);

/// How a pixel at (0, 0) sees a picture: its first look, and then as `Way` (Edge or Strata) goes on.
template <class Picture>
Surroundings first_look(const Picture& light) {
  Surroundings out;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      out.corners[static_cast<std::size_t>(4 * y + x)] = light(ScreenPoint{x - 1.0, y - 1.0});
      if (x == 3 || y == 3) continue;
      const ScreenPoint in = point_in({x - 1, y - 1}, {});
      out.middles[static_cast<std::size_t>(3 * y + x)] = light(ScreenPoint{x - 1 + in.x, y - 1 + in.y});
    }
  }
  return out;
}

template <class Picture>
std::vector<Color> lights(const Picture& light, const std::vector<ScreenPoint>& points) {
  std::vector<Color> out;
  for (const ScreenPoint& p : points) out.push_back(light(p));
  return out;
}

struct Outcome {
  bool found = false;
  double mean = 0;
  std::size_t samples = 0;
};

template <class Picture>
Outcome by_edge(const Picture& light, double error) {
  const Demand demand{&k_display, error};
  Edge edge;
  edge.begin({0, 0}, first_look(light), demand);
  Outcome out;
  for (std::vector<ScreenPoint> points;; points.clear()) {
    const Edge::State state = edge.refine(demand, points);
    out.found = state == Edge::State::found;
    if (state != Edge::State::asking) break;
    out.samples += points.size();
    edge.take(lights(light, points));
  }
  out.mean = out.found ? edge.mean().r : 0;
  return out;
}

template <class Picture>
Outcome by_strata(const Picture& light, double error) {
  const Demand demand{&k_display, error};
  Strata strata;
  strata.begin({0, 0}, first_look(light));
  Outcome out{true, 0, 0};
  for (std::vector<ScreenPoint> points; strata.refine(demand, points); points.clear()) {
    out.samples += points.size();
    strata.take(lights(light, points));
  }
  out.mean = strata.mean().r;
  return out;
}

/// 0.8 below the line through (0, at) of that slope, 0.1 above it.
struct HalfPlane {
  double at = 0.5, slope = 0;
  Color operator()(ScreenPoint p) const { return grey(p.y > at + slope * p.x ? 0.8 : 0.1); }
};

}  // namespace

TEST_CASE("sampling: to an error the image is the same bytes for 1, 2 and 7 threads", "[sampling]") {
  const tbb::global_control seven(tbb::global_control::max_allowed_parallelism, 7);
  const Scene s = still_life();
  const Rendered one = to_error(s, front(75, 50), 0.05);
  for (const int threads : {2, 7}) {
    const Rendered many = to_error(s, front(75, 50), 0.05, threads);
    CHECK(many.image.data() == one.image.data());
    CHECK(many.stats.primary_rays == one.stats.primary_rays);
    CHECK(many.stats.refined_pixels == one.stats.refined_pixels);
  }
  CHECK(one.stats.pixels == 75U * 50U);
  CHECK(one.stats.refined_pixels < one.stats.pixels);
  CHECK(one.stats.edge_pixels > 0);
  CHECK(one.stats.edge_pixels < one.stats.refined_pixels);
}

TEST_CASE("sampling: a region is a cut-out of the whole", "[sampling]") {
  const Scene s = still_life();
  const Rendered whole = to_error(s, front(60, 40), 0.05);
  Options options;
  options.samples = 0;
  options.error = 0.05;
  options.region = Region{7, 0, 50, 39};
  const Rendered part = render(s, front(60, 40), options);
  REQUIRE(part.image.width() == 43);
  REQUIRE(part.image.height() == 39);
  for (int y = 0; y < 39; ++y) {
    for (int x = 0; x < 43; ++x) {
      for (std::size_t c = 0; c < 3; ++c)
        REQUIRE(part.image.pixel(x, y)[c] == whole.image.pixel(x + 7, y)[c]);
    }
  }
  options.region = Region{7, 5, 7, 9};
  CHECK(render(s, front(60, 40), options).image.data().empty());
}

TEST_CASE("sampling: where nothing happens, a pixel costs a corner and a look inside", "[sampling]") {
  Scene s;
  s.settings.background = grey(0.25);
  const Rendered out = to_error(s, front(20, 10), 0.02);
  for (const float value : out.image.data()) REQUIRE(value == 0.25F);
  CHECK(out.stats.refined_pixels == 0);
  // 23 x 13 corners and 22 x 12 pixels: the region and a frame of one pixel.
  CHECK(out.stats.primary_rays == 23 * 13 + 22 * 12);
  CHECK(least_samples(20, 10) == 23 * 13 + 22 * 12);
  CHECK(least_samples(0, 10) == 0);
}

TEST_CASE("sampling: of each picture at least 99 pixels in 100 are as near as was asked", "[sampling]") {
  const Scene s = still_life();
  const Rendered truth = picture(s, front(36, 24), 512);
  double cost = 0;
  for (const double error : {0.1, 0.05, 0.02}) {
    INFO(error);
    const Rendered out = to_error(s, front(36, 24), error);
    CHECK(part_within(out.image, truth.image, error) >= 0.99);
    const double samples = static_cast<double>(out.stats.primary_rays) / (36 * 24);
    CHECK(samples > cost);
    cost = samples;
  }
  // The mean of 16 samples in each pixel is not as near.
  CHECK(part_within(picture(s, front(36, 24), 16).image, truth.image, 0.02) < 0.99);
}

TEST_CASE("sampling: light beyond what is shown needs no samples", "[sampling]") {
  // A floor of checks that are all brighter than white.
  Scene s;
  s.settings.ambient = grey(1);
  s.settings.background = grey(3);
  Material floor = glowing(1);
  floor.ambient.pattern = 0;
  s.patterns.emplace_back();
  s.patterns[0].a = grey(2);
  s.patterns[0].b = grey(7);
  add_plane(s, {0, -1, 0}, {0, 1, 0}, floor);
  CHECK(to_error(s, front(30, 20), 0.02).stats.refined_pixels == 0);
  s.settings.exposure = 0.1;
  CHECK(to_error(s, front(30, 20), 0.02).stats.refined_pixels > 300);
}

TEST_CASE("sampling: cancelled before it starts it draws nothing", "[sampling]") {
  const std::atomic<bool> cancel{true};
  Options options;
  options.samples = 0;
  options.error = 0.05;
  const Rendered out = render(still_life(), front(40, 40), options, {&cancel, {}});
  CHECK(out.cancelled);
  CHECK(out.stats.primary_rays == 0);
}

TEST_CASE("sampling: a straight edge is found by a few samples on its sides", "[sampling]") {
  // Below the line: 1 - (at + slope / 2) of the pixel.
  for (const HalfPlane& edge : {HalfPlane{0.3, 0.2}, HalfPlane{0.77, 0}, HalfPlane{0.05, 0.9}}) {
    const double truth = 0.1 + 0.7 * (1 - edge.at - edge.slope / 2);
    const Outcome out = by_edge(edge, 0.01);
    REQUIRE(out.found);
    CHECK(std::fabs(shown(static_cast<float>(out.mean)) - shown(static_cast<float>(truth))) < 0.01);
    CHECK(out.samples <= 16);
  }
}

TEST_CASE("sampling: what is no straight edge is not taken for one", "[sampling]") {
  const auto checks = [](ScreenPoint p) {
    return grey((static_cast<int>(std::floor(p.x * 7.3) + std::floor(p.y * 5.9)) & 1) != 0 ? 0.8 : 0.1);
  };
  CHECK_FALSE(by_edge(checks, 0.02).found);
  // A ball a pixel wide.
  const auto ball = [](ScreenPoint p) {
    return grey((p.x - 0.9) * (p.x - 0.9) + (p.y - 0.9) * (p.y - 0.9) < 0.25 ? 0.8 : 0.1);
  };
  CHECK_FALSE(by_edge(ball, 0.02).found);
  // A second edge behind the first.
  const auto bar = [](ScreenPoint p) { return grey(p.y > 0.3 && p.y < 1.3 ? 0.8 : 0.1); };
  CHECK_FALSE(by_edge(bar, 0.02).found);
  // Nothing to see.
  CHECK_FALSE(by_edge([](ScreenPoint) { return grey(0.3); }, 0.02).found);
}

TEST_CASE("sampling: squares become smaller where they differ, until the error is reached", "[sampling]") {
  const HalfPlane edge{0.31, 0.43};
  const double truth = 0.1 + 0.7 * (1 - 0.31 - 0.215);
  std::size_t before = 0;
  for (const double error : {0.1, 0.03, 0.01, 0.003}) {
    const Outcome out = by_strata(edge, error);
    CHECK(std::fabs(shown(static_cast<float>(out.mean)) - shown(static_cast<float>(truth))) < error);
    CHECK(out.samples > before);
    before = out.samples;
  }
  // With equal squares the error along an edge falls with n^-3/4: 33 times less would cost 33^(4/3) = 106
  // times.
  CHECK(before < 106 * by_strata(edge, 0.1).samples);
  CHECK(by_strata([](ScreenPoint) { return grey(0.3); }, 0.003).samples == 3);
}

TEST_CASE("sampling: the place in a square is in it, and another in another pixel", "[sampling]") {
  for (int level = 0; level < 8; ++level) {
    const Stratum s{level, (1 << level) - 1, (1 << level) / 2};
    const ScreenPoint p = point_in({-1, 7}, s), q = point_in({0, 7}, s);
    CHECK(p.x >= s.column * s.side());
    CHECK(p.x < (s.column + 1) * s.side());
    CHECK(p.y >= s.row * s.side());
    CHECK(p.y < (s.row + 1) * s.side());
    CHECK(p.x != q.x);
    CHECK(p.y != q.y);
  }
}

TEST_CASE("sampling: light as shown is that of the curve", "[sampling]") {
  const Display half(0.5);
  for (int i = 0; i <= 1000; ++i) {
    const double light = i / 400.0;
    const double truth = math::linear_to_srgb(std::fmin(1, light / 2));
    REQUIRE(std::fabs(static_cast<double>(half.shown(static_cast<float>(light))) - truth) < 1e-4);
  }
  CHECK(half.shown(-1) == 0);
  CHECK(half.shown(std::nanf("")) == 0);
  CHECK(half.change(5, 1) == 0);
  CHECK(half.change(2, 1) > 0.2F);
}
