#include <bit>
#include <cstdint>

#include "build.hpp"
#include "catch.hpp"
#include "tracer/shapes/careful.hpp"
#include "tracer/shapes/newton.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

/// Numbers in [-1, 1) from a counter (splitmix64).
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  double next() {
    state_ += 0x9E3779B97F4A7C15;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    z ^= z >> 31;
    return static_cast<double>(z >> 11) * 0x1p-52 - 1;
  }
  Vec3 vec() {
    const double x = next(), y = next(), z = next();
    return {x, y, z};
  }

 private:
  std::uint64_t state_;
};

/// How many doubles lie between the two.
std::int64_t steps(double a, double b) {
  const auto place = [](double x) {
    const auto bits = std::bit_cast<std::int64_t>(x);
    return bits < 0 ? std::int64_t{-0x7FFFFFFFFFFFFFFF} - 1 - bits : bits;
  };
  const std::int64_t difference = place(a) - place(b);
  return difference < 0 ? -difference : difference;
}

/// A coordinate far below the largest one counts in units of that one's last place times 2^-40.
bool within_an_ulp(Vec3 a, Vec3 b) {
  const double least = std::ldexp(max_abs(b), -40);
  for (int i = 0; i < 3; ++i) {
    const double unit = std::fmax(std::fabs(b[i]), least) * 0x1p-52;
    if (std::fabs(a[i] - b[i]) > unit) return false;
  }
  return true;
}

bool same(const Landing& a, const Landing& b) {
  return a.root.t == b.root.t && a.rest == b.rest && a.point == b.point && a.normal == b.normal;
}

/// Calls check(ray, root) for the crossings of random rays, as the quick test finds them.
template <class Surface, class Check>
int for_crossings(const Surface& surface, double distance, Check check) {
  Numbers numbers(7);
  int count = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 origin = numbers.vec() * distance;
    const Vec3 direction = normalize(numbers.vec() * 1.2 - origin);
    const Roots found = roots(surface, Probe(origin, direction));
    for (int k = 0; k < found.count; ++k) {
      if (!(found.root[k].t > 0)) continue;
      ++count;
      check(origin, direction, found.root[k]);
    }
  }
  return count;
}

template <class Surface>
void check_against_exact(const Surface& surface) {
  for (const double distance : {2.0, 50.0, 1e6, 1e9}) {
    int off = 0;
    const int count = for_crossings(surface, distance, [&](Vec3 o, Vec3 d, const Root& root) {
      const Landing quick = land(surface, o, d, root);
      const Landings exactly = careful(surface, o, d, Detail::places);
      const Landing& truth = exactly.at[root.entering || exactly.count == 1 ? 0 : 1];
      const bool right = exactly.count > 0 && steps(quick.root.t, truth.root.t) <= 1 &&
                         within_an_ulp(quick.point, truth.point) && within_an_ulp(quick.normal, truth.normal);
      off += right ? 0 : 1;
    });
    INFO("from " << distance);
    CHECK(count > 200);
    CHECK(off == 0);
  }
}

World turned_ones() {
  static Scene s;
  if (s.shapes.empty()) {
    const Affine turn = then(rotation({10, 20, 30}), translation({0.1, -0.2, 0.3}));
    add_sphere(s, {0.1, 0.2, 0.3}, 0.7);
    add_sphere(s, {0, 0, 0}, 1, {}, then(scaling({0.5, 1.25, 0.75}), turn));
    add_plane(s, {0.3, 0, 0}, {0.1, 1, 0.4});
    add_box(s, {-0.5, -0.25, -1}, {0.5, 0.75, 0.5}, {}, turn);
    add_box(s, {-0.5, -0.25, -1}, {0.5, 0.75, 0.5});
    add_facet(s, {-1, -0.3, 0.1}, {1.1, -0.4, 0}, {0.1, 1.3, 0.2});
  }
  return prepare(s);
}

}  // namespace

TEST_CASE("landing: distance, point and normal are within an ulp of the exact ones", "[landing]") {
  const World world = turned_ones();
  check_against_exact(world.spheres[0]);
  check_against_exact(world.ellipsoids[0]);
  check_against_exact(world.planes[0]);
  check_against_exact(world.boxes[0]);
  check_against_exact(world.boxes[1]);
  check_against_exact(world.facets[0]);
}

#if defined(LANCER_HAS_AVX2)
TEST_CASE("landing: processors with and without AVX2 give the same bits", "[landing]") {
  if (!k_use_avx2) return;
  const World world = turned_ones();
  const auto check = [](const auto& surface, const auto& tested) {
    int different = 0, settled = 0;
    for_crossings(tested, 4, [&](Vec3 o, Vec3 d, const Root& root) {
      Landing a{root, 0, 0, {}, {}}, b{root, 0, 0, {}, {}};
      const bool first = baseline::land(surface, o, d, a), second = avx2::land(surface, o, d, b);
      different += first == second && same(a, b) ? 0 : 1;
      settled += first ? 1 : 0;
    });
    CHECK(settled > 200);
    CHECK(different == 0);
  };
  check(world.spheres[0], world.spheres[0]);
  check(world.ellipsoids[0], world.ellipsoids[0]);
  check(Planar{world.planes[0].normal, world.planes[0].level, world.planes[0].point}, world.planes[0]);
  check(world.facets[0], world.facets[0]);
}
#endif

TEST_CASE("landing: what lies in a plane across an axis keeps its coordinate", "[landing]") {
  Scene s;
  add_facet(s, {-1, 0.1, -1}, {0, 0.1, 1.5}, {1, 0.1, -1});
  add_plane(s, {0, 0.1, 0}, {0, 3, 0});
  const World world = prepare(s);
  Numbers numbers(3);
  for (int i = 0; i < 500; ++i) {
    const Vec3 o{numbers.next(), 2.5 + numbers.next(), numbers.next()};
    const Vec3 d = normalize(Vec3{numbers.next() * 0.3, 0.1, numbers.next() * 0.3} - o);
    Stats stats;
    Hit hit;
    REQUIRE(closest(world, Ray{o, d, 0, {}, {}}, stats, hit));
    CHECK(hit.point.y == 0.1);
  }
}

TEST_CASE("landing: a ray that touches a sphere exactly hits it, one beside it by an ulp does not",
          "[landing]") {
  Scene s;
  add_sphere(s, {0, 0, 0}, 1);
  const World world = prepare(s);
  const Roots touching = roots(world, 0, Probe({1, 0, 3}, {0, 0, -1}));
  REQUIRE(touching.count == 2);
  CHECK(touching.root[0].t == 3);
  CHECK(roots(world, 0, Probe({1 + 0x1p-52, 0, 3}, {0, 0, -1})).count == 0);
  CHECK(roots(world, 0, Probe({1 - 0x1p-53, 0, 3}, {0, 0, -1})).count == 2);
}

TEST_CASE("landing: a start a hair above a sphere keeps every digit of the way", "[landing]") {
  Scene s;
  add_sphere(s, {0, 0, 0}, 1);
  const World world = prepare(s);
  for (const double height : {0x1p-30, 0x1p-45, 0x1p-52}) {
    const Roots r = roots(world, 0, Probe({0, 1 + height, 0}, {0, -1, 0}));
    REQUIRE(r.count == 2);
    CHECK(r.root[0].t == height);
    CHECK(r.root[0].entering);
  }
}
