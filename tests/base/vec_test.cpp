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

TEST_CASE("vec: with and without a power of two taken out, the same bits", "[vec]") {
  for (int i = 0; i < 2000; ++i) {
    // Any mantissas; the components up to 2^60 apart, the squares within the bounds of the plain way.
    const auto part = [&](int k) {
      return std::scalbn(1 + std::fmod(i * 0.618 * k, 1.0), (i * k * 7) % 61 - 30);
    };
    const Vec3 v = times_power_of_two(Vec3{part(1), -part(2), part(3)}, i % 700 - 350);
    REQUIRE(is_safe_square(dot(v, v)));
    REQUIRE(length(v) == scaled_length(v));
    REQUIRE(normalize(v) == scaled_normalize(v));
  }
  CHECK_FALSE(is_safe_square(0));
  CHECK_FALSE(is_safe_square(std::numeric_limits<double>::infinity()));
  CHECK_FALSE(is_safe_square(std::nan("")));
}

TEST_CASE("vec: the larger of a number and NaN is the number", "[vec]") {
  CHECK(larger(1, 2) == 2);
  CHECK(larger(2, 1) == 2);
  CHECK(larger(1, std::nan("")) == 1);
  CHECK(larger(std::nan(""), 1) == 1);
  CHECK(std::isnan(larger(std::nan(""), std::nan(""))));
}

TEST_CASE("vec: what is beyond numbers has no direction and an infinite length", "[vec]") {
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(lancer::length({infinite, 0, 0}) == infinite);
  CHECK(lancer::length({0, 0, 0}) == 0);
  CHECK(std::isnan(lancer::length({std::nan(""), 1, 2})));
  CHECK(lancer::normalize({0, -infinite, 1}).y == -infinite);
}

}  // namespace lancer
