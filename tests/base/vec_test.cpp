#include "base/vec.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"

namespace lancer {

TEST_CASE("vec: products of the axes", "[vec]") {
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  CHECK(cross(x, y) == z);
  CHECK(cross(y, z) == x);
  CHECK(cross(z, x) == y);
  CHECK(dot(Vec3{1, 2, 3}, Vec3{4, -5, 6}) == 12);  // 4 - 10 + 18
}

TEST_CASE("vec: lengths of any size", "[vec]") {
  for (const double scale : {5e-324, 1e-300, 1.0, 1e300}) {
    CAPTURE(scale);
    CHECK(length(Vec3{2 * scale, -3 * scale, 6 * scale}) == Approx(7 * scale).epsilon(1e-15));
  }
  CHECK(length(Vec3{3, 4, 0}) == 5);
  CHECK(length(Vec3{0, 0, 0}) == 0);
}

TEST_CASE("vec: unit vectors of any size", "[vec]") {
  for (const double scale : {5e-324, 1e-200, 1.0, 1e300}) {
    CAPTURE(scale);
    CHECK(normalize(Vec3{0, -scale, 0}) == Vec3{0, -1, 0});
    const Vec3 u = normalize(Vec3{3 * scale, 0, 4 * scale});
    CHECK(u.x == Approx(0.6).epsilon(1e-15));
    CHECK(u.z == Approx(0.8).epsilon(1e-15));
  }
}

TEST_CASE("vec: what is beyond numbers has no direction and an infinite length", "[vec]") {
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(lancer::length({infinite, 0, 0}) == infinite);
  CHECK(lancer::length({0, 0, 0}) == 0);
  CHECK(std::isnan(lancer::length({std::nan(""), 1, 2})));
  CHECK(lancer::normalize({0, -infinite, 1}).y == -infinite);
}

}  // namespace lancer
