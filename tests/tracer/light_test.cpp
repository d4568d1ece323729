#include "tracer/light.hpp"

#include "base/math.hpp"
#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

/// A spot at the origin pointing down; the point at `angle` degrees from its axis, 2 away.
double spot_at(double angle, double opening, double softness) {
  scene::Light light = point_light({0, 0, 0});
  light.kind = scene::LightKind::spot;
  light.direction = {0, -3, 0};
  light.angle = opening;
  light.softness = softness;
  return incoming(light, {2 * math::sin_deg(angle), -2 * math::cos_deg(angle), 0}).intensity.r;
}

}  // namespace

TEST_CASE("light: a point light shines alike in all directions", "[light]") {
  const Incoming in = incoming(point_light({0, 3, 4}, 0.7), {0, 0, 0});
  CHECK(in.distance == 5);
  CHECK(in.towards.y == Approx(0.6));
  CHECK(in.intensity == grey(0.7));
}

TEST_CASE("light: falloff is inverse square, 1 at its distance", "[light]") {
  scene::Light light = point_light({0, 0, 0});
  light.falloff = 2;
  CHECK(incoming(light, {2, 0, 0}).intensity.r == 1);
  CHECK(incoming(light, {4, 0, 0}).intensity.r == 0.25);
  CHECK(incoming(light, {1, 0, 0}).intensity.r == 4);
}

TEST_CASE("light: a sun shines along its direction from infinitely far", "[light]") {
  const Incoming in = incoming(sun({0, -8, 0}, 0.5), {100, 200, 300});
  CHECK(in.towards == Vec3{0, 1, 0});
  CHECK(std::isinf(in.distance));
  CHECK(in.intensity == grey(0.5));
}

TEST_CASE("light: a spot is full inside, smooth at its rim, none outside", "[light]") {
  // Opening 40, softness 0.5: full to 10 degrees, none from 20 on; at 15 x = 0.5, at 12.5 x = 0.75.
  CHECK(spot_at(0, 40, 0.5) == 1);
  CHECK(spot_at(9.99, 40, 0.5) == 1);
  CHECK(spot_at(15, 40, 0.5) == Approx(0.5).epsilon(1e-13));
  CHECK(spot_at(12.5, 40, 0.5) == Approx(0.75 * 0.75 * 1.5).epsilon(1e-13));
  CHECK(spot_at(20.01, 40, 0.5) == 0);
  CHECK(spot_at(180, 40, 0.5) == 0);
}

TEST_CASE("light: a spot without softness has a sharp rim, one with 1 is soft to its axis", "[light]") {
  CHECK(spot_at(14.99, 30, 0) == 1);
  CHECK(spot_at(15.01, 30, 0) == 0);
  CHECK(spot_at(7.5, 30, 1) == Approx(0.5).epsilon(1e-13));
  CHECK(spot_at(0, 30, 1) == 1);
}

TEST_CASE("light: a very narrow spot keeps its shape", "[light]") {
  CHECK(spot_at(0.75e-6, 2e-6, 0.5) == Approx(0.5).epsilon(1e-6));
}

TEST_CASE("light: at the light itself there is no direction and no light", "[light]") {
  CHECK(is_black(incoming(point_light({1, 2, 3}), {1, 2, 3}).intensity));
}
