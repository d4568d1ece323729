#include "tracer/render.hpp"

#include <cstring>
#include <tbb/global_control.h>

#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

Scene lit_by_the_sun() {
  Scene s = still_life();
  s.lights.push_back(sun({1, -2, -1}, 0.3));
  return s;
}

scene::View front(int columns, int rows) {
  scene::View v = view({0, 0.8, 5}, {0, -0.15, -1});
  v.columns = columns;
  v.rows = rows;
  return v;
}

}  // namespace

TEST_CASE("render: the image is the same bytes for 1, 2 and 7 threads", "[render]") {
  const tbb::global_control seven(tbb::global_control::max_allowed_parallelism, 7);
  const Scene s = lit_by_the_sun();
  const Rendered one = picture(s, front(75, 50), 5, 1);
  for (const int threads : {2, 7}) {
    const Rendered many = picture(s, front(75, 50), 5, threads);
    CHECK(many.image.data() == one.image.data());
    CHECK(many.stats.threads == threads);
    CHECK(many.stats.primary_rays == one.stats.primary_rays);
    CHECK(many.stats.shadow_rays == one.stats.shadow_rays);
  }
  CHECK(one.stats.primary_rays == 75U * 50U * 5U);
  CHECK(one.stats.reflected_rays > 0);
  CHECK(one.stats.refracted_rays > 0);
  CHECK(one.stats.shape_tests > 0);
  CHECK(one.stats.node_visits > 0);
}

TEST_CASE("render: a region is a cut-out of the whole", "[render]") {
  const Scene s = lit_by_the_sun();
  const Rendered whole = picture(s, front(60, 40), 4);
  Options options;
  options.samples = 4;
  options.region = Region{7, 11, 50, 39};
  const Rendered part = render(s, front(60, 40), options);
  REQUIRE(part.image.width() == 43);
  REQUIRE(part.image.height() == 28);
  for (int y = 0; y < 28; ++y) {
    for (int x = 0; x < 43; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        REQUIRE(part.image.pixel(x, y)[c] == whole.image.pixel(x + 7, y + 11)[c]);
      }
    }
  }
}

TEST_CASE("render: the size asked for takes the place of the view's", "[render]") {
  Options options;
  options.samples = 1;
  options.columns = 9;
  options.rows = 4;
  const Rendered out = render(lit_by_the_sun(), front(640, 480), options);
  CHECK(out.image.width() == 9);
  CHECK(out.image.height() == 4);
}

TEST_CASE("render: every row is announced once, complete", "[render]") {
  const Scene s = lit_by_the_sun();
  std::vector<int> seen_rows(45);
  std::vector<float> copy(30 * 45 * 3);
  Watch watch;
  watch.rows = [&](int y0, int y1, const float* rgb) {
    for (int y = y0; y < y1; ++y) ++seen_rows[static_cast<std::size_t>(y)];
    std::memcpy(copy.data() + y0 * 30 * 3, rgb, static_cast<std::size_t>(y1 - y0) * 30 * 3 * sizeof(float));
  };
  Options options;
  options.samples = 2;
  options.threads = 2;
  const Rendered out = render(s, front(30, 45), options, watch);
  CHECK(seen_rows == std::vector<int>(45, 1));
  CHECK(copy == out.image.data());
  CHECK_FALSE(out.cancelled);
}

TEST_CASE("render: cancelled before it starts it draws nothing", "[render]") {
  const std::atomic<bool> cancel{true};
  Watch watch;
  watch.cancel = &cancel;
  int rows = 0;
  watch.rows = [&](int, int, const float*) { ++rows; };
  const Rendered out = render(lit_by_the_sun(), front(64, 64), {}, watch);
  CHECK(out.cancelled);
  CHECK(rows == 0);
  CHECK(out.image.width() == 64);
}

TEST_CASE("render: cancelled on the way it keeps the rows that were finished", "[render]") {
  std::atomic<bool> cancel{false};
  Watch watch;
  watch.cancel = &cancel;
  watch.rows = [&](int, int, const float*) { cancel = true; };
  Options options;
  options.threads = 1;
  const Rendered out = render(lit_by_the_sun(), front(16, 320), options, watch);
  CHECK(out.cancelled);
  CHECK(out.stats.primary_rays < 16U * 320U * 16U);
  CHECK(out.image.pixel(3, 3)[2] > 0);
  CHECK(out.image.pixel(3, 319)[2] == 0);
}

TEST_CASE("render: more samples are the mean of what each sees", "[render]") {
  // A white half-plane that ends in the middle of the one pixel.
  Scene s;
  s.settings.ambient = grey(1);
  add_plane(s, {0, 0, 0}, {1, 0, 0}, glowing(1));
  CHECK(picture(s, view({5, 0, 0}, {0, 0, -1}, 1), 64).image.pixel(0, 0)[0] == Approx(0.5).margin(0.02));
}

TEST_CASE("render: an empty scene is all background", "[render]") {
  Scene s;
  s.settings.background = grey(0.25);
  for (const float value : values(s, front(20, 20), 3)) REQUIRE(value == 0.25F);
}
