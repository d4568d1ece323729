#include "base/transform.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"
#include "numbers.hpp"

namespace lancer {
namespace {

constexpr Vec3 k_x{1, 0, 0}, k_y{0, 1, 0}, k_z{0, 0, 1};

double distance(Vec3 a, Vec3 b) { return length(a - b); }

/// The largest distance of an entry of `a` from one of `b`.
double distance(const Affine& a, const Affine& b) {
  double out = max_abs(a.translation - b.translation);
  for (std::size_t i = 0; i < 3; ++i) out = std::fmax(out, max_abs(a.rows[i] - b.rows[i]));
  return out;
}

bool has_minus_zero(Vec3 v) {
  return (v.x == 0 && std::signbit(v.x)) || (v.y == 0 && std::signbit(v.y)) ||
         (v.z == 0 && std::signbit(v.z));
}

Affine matrix(Vec3 a, Vec3 b, Vec3 c) { return {{a, b, c}, {}}; }

}  // namespace

TEST_CASE("transform: turns about the axes are right-handed", "[transform]") {
  CHECK(rotation(Vec3{90, 0, 0}).point(k_y) == k_z);
  CHECK(rotation(Vec3{0, 90, 0}).point(k_z) == k_x);
  CHECK(rotation(Vec3{0, 0, 90}).point(k_x) == k_y);
  CHECK(rotation(k_x, 90).point(k_y) == k_z);
  CHECK(rotation(Vec3{0, -3, 0}, -90).point(k_z) == k_x);  // the other way about the other way
  const Vec3 p = rotation(Vec3{0, 0, 30}).point(k_x);
  CHECK(p == Vec3{std::sqrt(3.0) / 2, 0.5, 0});
}

TEST_CASE("transform: about x first, then y, then z", "[transform]") {
  // y goes to z by the first turn, z to x by the second, x to y by the third.
  CHECK(rotation(Vec3{90, 90, 90}).point(k_y) == k_y);
  // x stays, then goes to -z, which stays.
  CHECK(rotation(Vec3{90, 90, 90}).point(k_x) == Vec3{0, 0, -1});
}

TEST_CASE("transform: four quarter turns leave every bit", "[transform]") {
  for (const Vec3 angles :
       {Vec3{90, 0, 0}, Vec3{0, 90, 0}, Vec3{0, 0, 90}, Vec3{0, -450, 0}, Vec3{180, 90, 0}}) {
    Affine a = translation({0.1, 0.2, 0.3});
    const Affine start = a;
    for (int i = 0; i < 4; ++i) a = then(a, rotation(angles));
    CHECK(a == start);
    for (const Vec3& row : a.rows) CHECK_FALSE(has_minus_zero(row));
  }
  CHECK(is_identity(rotation(Vec3{360, 720, -360})));
  CHECK(is_identity(rotation(k_y, 360)));
}

TEST_CASE("transform: turns about any axis", "[transform]") {
  // About the diagonal by a third of a turn x goes to y, y to z, z to x.
  for (const double size : {1e-200, 1.0, 1e200}) {
    const Affine third = rotation(Vec3{size, size, size}, 120);
    CHECK(distance(third.point(k_x), k_y) < 1e-15);
    CHECK(distance(third.point(k_y), k_z) < 1e-15);
    CHECK(distance(third.point(k_z), k_x) < 1e-15);
  }
  // Half a turn about <1, 1, 0> exchanges x and y and turns z round.
  const Affine half = rotation(Vec3{1, 1, 0}, 180);
  CHECK(distance(half.point(k_x), k_y) < 1e-15);
  CHECK(distance(half.point(k_z), -k_z) < 1e-15);
}

TEST_CASE("transform: a small turn keeps lengths and its axis", "[transform]") {
  Numbers n(11);
  for (int i = 0; i < 500; ++i) {
    const Vec3 axis{n.uniform(-1, 1), n.uniform(-1, 1), n.uniform(-1, 1)};
    const Affine a = rotation(axis, n.of_any_size(-30, 9));
    const Vec3 p{n.uniform(-1, 1), n.uniform(-1, 1), n.uniform(-1, 1)};
    REQUIRE(std::fabs(length(a.point(p)) - length(p)) < 1e-15);
    REQUIRE(distance(a.point(axis), axis) < 1e-15);
    REQUIRE(std::fabs(determinant(a) - 1) < 1e-15);
  }
}

TEST_CASE("transform: what comes first is applied first", "[transform]") {
  const Affine moved_then_scaled = then(translation({1, 2, 3}), scaling({2, 3, 4}));
  CHECK(moved_then_scaled.point({0, 0, 0}) == Vec3{2, 6, 12});
  CHECK(moved_then_scaled.vector({1, 1, 1}) == Vec3{2, 3, 4});
  const Affine scaled_then_moved = then(scaling({2, 3, 4}), translation({1, 2, 3}));
  CHECK(scaled_then_moved.point({1, 1, 1}) == Vec3{3, 5, 7});
}

TEST_CASE("transform: inverses of simple maps are exact", "[transform]") {
  CHECK(inverse(Affine{}) == Affine{});
  CHECK(inverse(translation({0.1, -7, 1e300})) == translation({-0.1, 7, -1e300}));
  CHECK(inverse(scaling({2, -0.5, 10})) == scaling({0.5, -2, 0.1}));
  CHECK(inverse(scaling({0.1, 3, 1e-200})) == scaling({10, 1.0 / 3, 1e200}));
}

TEST_CASE("transform: the inverse of a product of quarter turns is its transpose", "[transform]") {
  const Affine a = rotation(Vec3{90, 180, 270});
  const auto b = inverse(a);
  REQUIRE(b);
  CHECK(then(a, *b) == Affine{});
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      CHECK(b->rows[static_cast<std::size_t>(i)][j] == a.rows[static_cast<std::size_t>(j)][i]);
  }
}

TEST_CASE("transform: inverses worked out by hand", "[transform]") {
  // | 1 2 3 |          | -24  18   5 |
  // | 0 1 4 |  det 1   |  20 -15  -4 |
  // | 5 6 0 |          |  -5   4   1 |
  const Affine a{{Vec3{1, 2, 3}, Vec3{0, 1, 4}, Vec3{5, 6, 0}}, {1, 1, 1}};
  CHECK(determinant(a) == 1);
  const Affine expected{{Vec3{-24, 18, 5}, Vec3{20, -15, -4}, Vec3{-5, 4, 1}}, {1, -1, 0}};
  CHECK(inverse(a) == expected);
}

TEST_CASE("transform: inverses undo", "[transform]") {
  Numbers n(12);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const Affine turn = rotation(Vec3{n.uniform(0, 360), n.uniform(0, 360), n.uniform(0, 360)});
    const Affine a =
        then(then(turn, scaling({n.uniform(0.5, 2), n.uniform(0.5, 2), -n.uniform(0.5, 2)})),
             then(rotation(Vec3{n.uniform(0, 90), 0, 0}), translation({n.uniform(-5, 5), 1, 2})));
    const auto b = inverse(a);
    REQUIRE(b);
    worst = std::fmax(worst, distance(then(a, *b), Affine{}));
  }
  CHECK(worst < 1e-14);
}

TEST_CASE("transform: scales far apart can be undone", "[transform]") {
  for (const double tiny : {1e-30, 1e-150, 1e-300}) {
    CAPTURE(tiny);
    const auto b = inverse(then(scaling({tiny, 1, 1 / tiny}), rotation(Vec3{0, 90, 0})));
    REQUIRE(b);
    CHECK(b->rows[0].z == Approx(-1 / tiny).epsilon(1e-15));
  }
  const Affine turned = then(scaling({1e-100, 1, 1}), rotation(Vec3{10, 20, 30}));
  CHECK(inverse(turned).has_value());
}

TEST_CASE("transform: maps without an inverse", "[transform]") {
  CHECK_FALSE(inverse(scaling({1, 0, 1})));
  CHECK_FALSE(inverse(matrix({1, 2, 3}, {2, 4, 6}, {0, 1, 1})));
  CHECK_FALSE(inverse(matrix({1, 2, 3}, {4, 5, 6}, {7, 8, 9})));
  // Flat in a direction that no axis has: rounding alone is left of the determinant.
  const Affine turn = rotation(Vec3{10, 20, 30});
  CHECK_FALSE(inverse(then(then(turn, scaling({1, 0, 1})), rotation(Vec3{40, 50, 60}))));
  CHECK_FALSE(inverse(scaling({std::numeric_limits<double>::infinity(), 1, 1})));
  CHECK_FALSE(inverse(translation({std::numeric_limits<double>::quiet_NaN(), 0, 0})));
  CHECK_FALSE(inverse(scaling({5e-324, 1, 1})));  // 1 / 5e-324 is too large
}

TEST_CASE("transform: normals travel by the inverse transpose", "[transform]") {
  // The plane x + y = 1 under a stretch of x by 2 becomes x / 2 + y = 1.
  const Affine a = scaling({2, 1, 1});
  const Transform t{a, *inverse(a)};
  CHECK(t.normal_to_world({1, 1, 0}) == Vec3{0.5, 1, 0});
}

TEST_CASE("transform: far moves keep what is below the last bits of their sum", "[transform]") {
  // 2^60 + 0.1 is 2^60 in doubles, and back again 0.
  const Affine there = translation({0x1p60, 0, -0x1p60}), back = translation({-0x1p60, 0, 0x1p60});
  const Affine moved = then(translation({0.1, 0.2, 0.3}), there);
  CHECK(moved.translation == Vec3{0x1p60, 0.2, -0x1p60});
  CHECK(moved.rest == Vec3{0.1, 0, 0.3});
  CHECK(then(moved, back) == translation({0.1, 0.2, 0.3}));
  CHECK(then(then(translation({0.1, 0.2, 0.3}), then(there, scaling({2, 1, 4}))),
             translation({-0x1p61, 0, 0x1p62})) == then(translation({0.1, 0.2, 0.3}), scaling({2, 1, 4})));
  const auto inverse_of = inverse(moved);
  REQUIRE(inverse_of);
  CHECK(inverse_of->translation == Vec3{-0x1p60, -0.2, 0x1p60});
  CHECK(inverse_of->rest == Vec3{-0.1, 0, -0.3});
}

TEST_CASE("transform: a place is known to twice the precision", "[transform]") {
  const Place at = translation({0x1p60, 0, 0}).place({{0.1, 0.2, 0.3}, {}});
  CHECK(at.at == Vec3{0x1p60, 0.2, 0.3});
  CHECK(at.rest == Vec3{0.1, 0, 0});
  CHECK(at.from({0x1p60, 0, 0}).at == Vec3{0.1, 0.2, 0.3});
  CHECK(at.from({0x1p60, 0, 0}).rest == Vec3{});
  // Near the end of the range of numbers it is known to one.
  const Place huge = translation({1e307, 0, 0}).place({{1e307, 1, 1}, {}});
  CHECK(huge.at == Vec3{2e307, 1, 1});
  CHECK(huge.rest == Vec3{});
}

TEST_CASE("transform: rows are brought near 1 by one power of two", "[transform]") {
  int exponent = 0;
  const auto rows = near_one({Vec3{-6e200, 0, 0}, Vec3{0, 1e200, 0}, Vec3{0, 0, 3}}, exponent);
  CHECK(std::fabs(rows[0].x) >= 1);
  CHECK(std::fabs(rows[0].x) < 2);
  CHECK(std::scalbn(rows[0].x, exponent) == -6e200);
  CHECK(std::scalbn(rows[1].y, exponent) == 1e200);
}

}  // namespace lancer
