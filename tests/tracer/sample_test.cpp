#include "tracer/sample.hpp"

#include <cmath>
#include <set>

#include "catch.hpp"

using namespace lancer::tracer;

TEST_CASE("sample: one is the pixel's centre", "[sample]") {
  CHECK(pixel_point(3, 9, 0, 1).x == 0.5);
  CHECK(pixel_point(3, 9, 0, 1).y == 0.5);
}

TEST_CASE("sample: any number is stratified in x and in y", "[sample]") {
  for (const int n : {2, 3, 4, 7, 16, 17, 64, 100, 1000}) {
    for (int pixel = 0; pixel < 5; ++pixel) {
      std::set<int> rows;
      std::set<int> columns;
      const int across = static_cast<int>(std::sqrt(n)), down = (n + across - 1) / across;
      for (int i = 0; i < n; ++i) {
        const PixelPoint p = pixel_point(pixel * 7, 1000 - pixel, i, n);
        REQUIRE(p.x >= 0);
        REQUIRE(p.x < 1);
        REQUIRE(p.y >= 0);
        REQUIRE(p.y < 1);
        rows.insert(static_cast<int>(p.y * n));
        columns.insert(static_cast<int>(p.x * across * down));
      }
      CHECK(rows.size() == static_cast<std::size_t>(n));
      CHECK(columns.size() == static_cast<std::size_t>(n));
    }
  }
}

TEST_CASE("sample: pixels differ, and the mean over many is the centre", "[sample]") {
  double x = 0, y = 0;
  std::set<double> first;
  for (int pixel = 0; pixel < 4000; ++pixel) {
    const PixelPoint p = pixel_point(pixel % 61, pixel / 61, 3, 16);
    x += p.x;
    y += p.y;
    first.insert(p.x);
  }
  CHECK(first.size() > 3900);
  CHECK(x / 4000 == Approx(0.5).margin(0.02));  // standard error 0.0046
  CHECK(y / 4000 == Approx(0.5).margin(0.02));
}
