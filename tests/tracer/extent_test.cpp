#include "tracer/extent.hpp"

#include "catch.hpp"
#include "random_scene.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

scene::Light spot(Vec3 at, Vec3 direction, double angle) {
  scene::Light light = point_light(at);
  light.kind = scene::LightKind::spot;
  light.direction = direction;
  light.angle = angle;
  return light;
}

}  // namespace

TEST_CASE("extent: a spot misses a ball beside its cone", "[extent]") {
  Scene s;
  add_sphere(s, {0, 0, 0},
             1);  // its bounds' ball has the radius sqrt 3, seen from 10 away under 9.97 degrees
  const Extent e(s);
  const auto lit = [&](double degrees_off, double angle) {
    const double a = degrees_off * 3.14159265358979323846 / 180;
    return e.may_be_lit_by(spot({0, 0, 10}, {std::sin(a), 0, -std::cos(a)}, angle));
  };
  CHECK(lit(0, 1));
  CHECK(lit(24, 30));
  CHECK_FALSE(lit(26, 30));
  CHECK_FALSE(lit(180, 90));
  CHECK(e.may_be_lit_by(spot({0, 1, 0}, {0, 1, 0}, 1)));  // within the bounds' ball nothing is sure
}

TEST_CASE("extent: a spot misses a plane when all of its cone rises", "[extent]") {
  Scene s;
  add_plane(s, {0, 1, 0}, {0, 3, 0});
  const Extent e(s);
  CHECK_FALSE(e.may_be_lit_by(spot({0, 5, 0}, {0, 1, 0}, 100)));
  CHECK_FALSE(e.may_be_lit_by(spot({0, 5, 0}, {1, 1, 0}, 89)));
  CHECK(e.may_be_lit_by(spot({0, 5, 0}, {1, 1, 0}, 91)));
  CHECK(e.may_be_lit_by(spot({0, -5, 0}, {0, 1, 0}, 10)));
  CHECK_FALSE(e.may_be_lit_by(spot({0, -5, 0}, {0, -1, 0}, 10)));
  CHECK(e.may_be_lit_by(spot({0, 1, 0}, {0, 1, 0}, 10)));  // in the plane
}

TEST_CASE("extent: no surface is nearer than the least distance", "[extent]") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Scene s = random_scene(seed);
    const World world = prepare(s);
    const Extent e(s);
    Random random(seed);
    for (int i = 0; i < 40; ++i) {
      const Vec3 p = random.direction() * (4 + 20 * random());
      Stats stats;
      Hit hit;
      if (!closest(world, Ray{p, random.direction(), 0, {}, {}}, stats, hit)) continue;
      INFO("seed " << seed);
      REQUIRE(length(hit.point - p) >= e.least_distance(p));
    }
  }
}
