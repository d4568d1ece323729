#include "tracer/shapes/sphere_quads.hpp"

#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

/// Do the versions for both kinds of processor say of each lane what the test of one sphere does?
bool is_as_alone(const std::array<SpherePrimitive, 4>& spheres, const SphereQuad& quad, const Probe& probe) {
  unsigned alone = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool meets = roots(spheres[i], probe).count > 0;
    alone |= (meets ? 1U : 0U) << i;
  }
  const unsigned together = may_meet(quad, probe);
#if defined(LANCER_HAS_AVX2)
  if (baseline::may_meet(quad, probe) != together) return false;
#endif
  // What exact arithmetic alone tells is left to it.
  return (alone & ~together) == 0;
}

}  // namespace

TEST_CASE("sphere quads: no sphere that a ray meets is left out, and nearly all others are", "[shapes]") {
  Random random(7);
  int left_in = 0, met = 0;
  for (int round = 0; round < 20000; ++round) {
    std::array<SpherePrimitive, 4> spheres;
    SphereQuad quad;
    const double scale = std::pow(10.0, random.between(-6, 6));
    for (std::size_t i = 0; i < 4; ++i) {
      spheres[i] = {random.in_cube(3) * scale, random.between(0.1, 1) * scale, 0};
      quad.x[i] = spheres[i].center.x;
      quad.y[i] = spheres[i].center.y;
      quad.z[i] = spheres[i].center.z;
      quad.radius[i] = spheres[i].radius;
    }
    // At the rim of one of them.
    const Vec3 to = spheres[static_cast<std::size_t>(round % 4)].center;
    const Vec3 from = random.in_cube(9) * scale;
    const Vec3 across = normalize(cross(to - from, random.direction()));
    const double radius = spheres[static_cast<std::size_t>(round % 4)].radius;
    const Probe probe(from, normalize(to + across * (radius * random.between(0.9, 1.1)) - from));
    REQUIRE(is_as_alone(spheres, quad, probe));
    for (std::size_t i = 0; i < 4; ++i) met += roots(spheres[i], probe).count > 0 ? 1 : 0;
    left_in += std::popcount(may_meet(quad, probe));
  }
  CHECK(met > 10000);
  CHECK(left_in - met < 20);
}

TEST_CASE("sphere quads: spheres are told by their numbers, until one ends it", "[shapes]") {
  SphereQuads list;
  const Probe probe({0, 0, 9}, {0, 0, -1});
  // Seven, of which every other one is in the way.
  for (std::uint32_t i = 0; i < 7; ++i) {
    list.add({{i % 2 == 0 ? 0.0 : 5.0, 0, -3.0 * i}, 1, 0}, 10 + i);
  }
  std::vector<std::uint32_t> told;
  CHECK_FALSE(list.each(probe, [&](std::uint32_t number) {
    told.push_back(number);
    return false;
  }));
  CHECK(told == std::vector<std::uint32_t>{10, 12, 14, 16});
  told.clear();
  CHECK(list.each(probe, [&](std::uint32_t number) {
    told.push_back(number);
    return number == 12;
  }));
  CHECK(told == std::vector<std::uint32_t>{10, 12});
}
