#include "tracer/shapes/linear_map.hpp"

#include <cfenv>

#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

/// The entry of the product a b farthest from that of the identity.
double off_identity(const Rows& a, const Rows& b) {
  double most = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec3 column = apply(a, {b[0][i], b[1][i], b[2][i]});
    for (int j = 0; j < 3; ++j) most = std::fmax(most, std::fabs(column[j] - (i == j ? 1 : 0)));
  }
  return most;
}

}  // namespace

TEST_CASE("linear map: an inverse is that of a matrix of any size", "[linear_map]") {
  const Rows turn = rotation({10, 20, 30}).rows;
  for (const double size : {1e-290, 2e-200, 1e-160, 1.0, 1e160, 1e200, 1e290}) {
    for (const Vec3 sides : {Vec3{1, 1, 1}, Vec3{1, 2, 0.5}, Vec3{1, 1 / size, 1}, Vec3{1 / size, 1, 1}}) {
      Rows across = turn, along = turn;
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          across[static_cast<std::size_t>(i)][j] *= size * sides[j];
          along[static_cast<std::size_t>(i)][j] *= size * sides[i];
        }
      }
      std::feclearexcept(FE_ALL_EXCEPT);
      const Rows undone = accurate_inverse(across), redone = accurate_inverse(along);
      CHECK(std::fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) == 0);
      CHECK(off_identity(across, undone) < 1e-15);
      CHECK(off_identity(redone, along) < 1e-15);
    }
  }
}

TEST_CASE("linear map: the inverse has the same bits at every power of two", "[linear_map]") {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Rows m{random.in_cube(1), random.in_cube(1), random.in_cube(1)};
    const int power = -900 + 9 * i;
    Rows larger = m;
    for (Vec3& row : larger) row = row * std::ldexp(1.0, power);
    const Rows inverse = accurate_inverse(m), smaller = accurate_inverse(larger);
    for (std::size_t row = 0; row < 3; ++row) CHECK(smaller[row] == inverse[row] * std::ldexp(1.0, -power));
  }
}

TEST_CASE("linear map: tiny and huge turned boxes raise no invalid operation and are hit", "[linear_map]") {
  for (const double size : {1e-290, 2e-200, 1e-160, 1e160, 1e200, 1e290}) {
    Scene s;
    std::feclearexcept(FE_ALL_EXCEPT);
    add_box(s, {-size, -size, -size}, {size, size, size}, {}, rotation({10, 20, 30}));
    const World world = prepare(s);
    Random random(4);
    int hits = 0;
    for (int i = 0; i < 50; ++i) {
      const Vec3 from = random.direction();
      Stats stats;
      Hit hit;
      hits += closest(world, Ray{from * (5 * size), -from, 0, {}, {}}, stats, hit) ? 1 : 0;
    }
    CHECK(hits == 50);
    CHECK(std::fetestexcept(FE_INVALID) == 0);
  }
}
