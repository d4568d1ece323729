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
