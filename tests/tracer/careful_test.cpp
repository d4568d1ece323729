#include "tracer/shapes/careful.hpp"

#include <bit>
#include <chrono>
#include <cstdint>
#include <limits>
#include <vector>

#include "build.hpp"
#include "catch.hpp"
#include "tracer/exact.hpp"
#include "tracer/expansion.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

/// A facet and a ray.
struct Case {
  FacetPrimitive facet;
  Vec3 origin, direction;
};

int below(Random& random, int count) { return static_cast<int>(random() * count); }

/// A whole number of at most `size`, as often as not 0.
double whole(Random& random, int size) {
  return random() < 0.5 ? 0 : std::floor(random.between(-size, size + 1));
}
Vec3 on_grid(Random& random, int size) {
  const double x = whole(random, size), y = whole(random, size), z = whole(random, size);
  return {x, y, z};
}

/// Of short coordinates: corners, edges and planes are met exactly.
Case on_a_grid(Random& random) {
  const int size = 1 << (1 + below(random, 24));
  Case c;
  for (Vec3* v : {&c.facet.a, &c.facet.b, &c.facet.c, &c.origin, &c.direction}) *v = on_grid(random, size);
  return c;
}

/// Of long coordinates, the ray along an axis or not, through a corner or all but that, or from a point of an
/// edge that is off by rounding.
Case at_a_rim(Random& random) {
  Case c;
  const double away = std::pow(10.0, below(random, 9) - 2);
  for (Vec3* v : {&c.facet.a, &c.facet.b, &c.facet.c}) *v = random.in_cube(away);
  c.direction = random.direction();
  if (random() < 0.4) c.direction = on_grid(random, 1);
  const double back = std::ldexp(1.0, below(random, 12) - 4);
  const double share = below(random, 3) * 0.5;
  c.origin = c.facet.a * share + c.facet.b * (1 - share) - c.direction * back;
  if (random() < 0.3) c.facet.a = c.origin + c.direction;
  if (random() < 0.2) c.facet.c = c.facet.a * 2 - c.facet.b;
  if (random() < 0.2) c.origin = c.facet.c;
  return c;
}

/// The case scaled by 2^power, or only its facet, or the direction.
Case scaled(Case c, int power, int what) {
  const double by = std::ldexp(1.0, power);
  if (what != 2) {
    for (Vec3* v : {&c.facet.a, &c.facet.b, &c.facet.c}) *v = *v * by;
  }
  if (what == 0) c.origin = c.origin * by;
  if (what == 2) c.direction = c.direction * by;
  return c;
}

Case any_case(Random& random) {
  Case c = random() < 0.5 ? on_a_grid(random) : at_a_rim(random);
  c.facet.flipped = random() < 0.5;
  const int what = below(random, 3), far = below(random, 1061) - 530, near = below(random, 41) - 20;
  if (random() < 0.4) return scaled(c, random() < 0.5 ? near : far, what);
  return c;
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

/// The distances alone are those with all detail, which are found by whole numbers.
bool agree(const Case& c) {
  const Landings quick = careful(c.facet, c.origin, c.direction, Detail::distances);
  const Landings exactly = careful(c.facet, c.origin, c.direction, Detail::places);
  if (quick.count != exactly.count) return false;
  const Root &a = quick.at[0].root, &b = exactly.at[0].root;
  return quick.count == 0 || (bits(a.t) == bits(b.t) && a.entering == b.entering);
}

double nanoseconds(const std::vector<Case>& cases, Detail detail) {
  double best = std::numeric_limits<double>::infinity();
  int found = 0;
  for (int round = 0; round < 7; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (const Case& c : cases) found += careful(c.facet, c.origin, c.direction, detail).count;
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    best = std::min(best, taken.count() / static_cast<double>(cases.size()));
  }
  CHECK(found > 0);
  return best;
}

}  // namespace

TEST_CASE("careful: expansions and whole numbers tell the same of every facet", "[careful]") {
  Random random(11);
  int different = 0, hits = 0;
  for (int i = 0; i < 60000; ++i) {
    const Case c = any_case(random);
    different += agree(c) ? 0 : 1;
    hits += careful(c.facet, c.origin, c.direction, Detail::distances).count;
  }
  CHECK(different == 0);
  CHECK(hits > 10000);
}

TEST_CASE("careful: facets of any size are met where they are", "[careful]") {
  Random random(1);
  for (int power = -1000; power <= 960; power += 20) {
    const double size = std::ldexp(1.0, power);
    int wrong = 0, hits = 0;
    for (int i = 0; i < 300; ++i) {
      FacetPrimitive f;
      for (Vec3* corner : {&f.a, &f.b, &f.c}) *corner = random.in_cube(size);
      f.normal = normal_of_corners(f);
      const Vec3 origin = random.in_cube(5 * size), inside = random.in_cube(size);
      const Vec3 at = i % 3 == 0 ? f.a * 0.5 + f.b * 0.5 : inside;
      const Vec3 direction = normalize(at - origin);
      const Roots found = roots(f, Probe(origin, direction));
      const Landings exactly = careful(f, origin, direction, Detail::places);
      const Root& there = exactly.at[0].root;
      wrong += found.count == exactly.count ? 0 : 1;
      if (found.count == 0 || exactly.count == 0) continue;
      ++hits;
      wrong += found.root[0].entering == there.entering ? 0 : 1;
      if (!(there.t > 0)) continue;
      const Landing landing = land(f, origin, direction, found.root[0]);
      wrong += std::fabs(landing.root.t - there.t) <= 0x1p-52 * there.t ? 0 : 1;
    }
    INFO("2^" << power);
    CHECK(wrong == 0);
    CHECK(hits > 20);
  }
}

TEST_CASE("careful: a ray that is not finite meets nothing", "[careful]") {
  const FacetPrimitive facet{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, 0, 1}};
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(careful(facet, {0, 0, infinity}, {0, 0, -1}, Detail::distances).count == 0);
  CHECK(careful(facet, {0, 0, 1}, {0, infinity, -1}, Detail::distances).count == 0);
  CHECK(careful(facet, {0, 0, 1}, {0, 0, -1}, Detail::distances).count == 1);
}

TEST_CASE("careful: the sign of a determinant of full digits is that of whole numbers", "[careful]") {
  Random random(5);
  int different = 0, zeros = 0;
  for (int i = 0; i < 5000; ++i) {
    // a and b are long and c is their sum but for rounding, or 2 a + 2 b, whose determinant is 0.
    const Vec3 a = random.in_cube(1) * 0.3, b = random.in_cube(1) * 0.007;
    const Vec3 from = i % 2 == 0 ? Vec3{} : random.in_cube(1e-9);
    const auto sign = [&](auto number) {
      using Vec = Triple<decltype(number)>;
      const Vec at{from.x, from.y, from.z};
      const Vec p = Vec{a.x, a.y, a.z} - at, q = Vec{b.x, b.y, b.z} - at;
      const Vec3 sum = a + b;
      const Vec rounded = Vec{sum.x, sum.y, sum.z} - at - at;
      const Vec r = i % 4 < 2 ? rounded : p + q;
      return dot(cross(p, q), r).sign();
    };
    const int exactly = sign(Exact());
    different += sign(Expansion()) == exactly ? 0 : 1;
    zeros += exactly == 0 ? 1 : 0;
  }
  CHECK(different == 0);
  CHECK(zeros >= 2500);
  CHECK(zeros < 4500);
}

TEST_CASE("careful: rays at corners of facets on a grid cost little", "[careful]") {
  Random random(2);
  std::vector<Case> cases;
  for (int i = 0; i < 300; ++i) {
    Case c;
    for (Vec3* v : {&c.facet.a, &c.facet.b, &c.facet.c}) *v = on_grid(random, 32);
    c.origin = {c.facet.a.x, c.facet.a.y, 50};
    c.direction = {0, 0, -1};
    cases.push_back(c);
  }
  // 20 to 30 times less than by whole numbers.
  CHECK(nanoseconds(cases, Detail::distances) < nanoseconds(cases, Detail::places) / 4);
}
