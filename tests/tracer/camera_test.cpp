#include "tracer/camera.hpp"

#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

void check_near(Vec3 a, Vec3 b) {
  CHECK(a.x == Approx(b.x).margin(1e-15));
  CHECK(a.y == Approx(b.y).margin(1e-15));
  CHECK(a.z == Approx(b.z).margin(1e-15));
}

}  // namespace

TEST_CASE("camera: perspective pixel centres follow the formula", "[camera]") {
  // fov 90, so t = 1; 4 x 2 pixels. Pixel (0, 0): f + (1/4 - 1) r - (1/2 - 1)(2/4) u = (-3/4, 1/4, -1).
  scene::View v = view({1, 2, 3}, {0, 0, -7}, 4, 90);
  const Camera camera(v, 4, 2);
  check_near(camera.ray(0.5, 0.5).direction, normalize({-0.75, 0.25, -1}));
  check_near(camera.ray(3.5, 1.5).direction, normalize({0.75, -0.25, -1}));
  CHECK(camera.ray(0.5, 0.5).origin == Vec3{1, 2, 3});
  CHECK(camera.has_one_origin());
}

TEST_CASE("camera: right is look x up, whatever the lengths and the lean of up", "[camera]") {
  // Looking along +x with y up, right is x x y = z.
  scene::View v = view({0, 0, 0}, {1e-9, 0, 0}, 2, 90);
  v.up = {5e8, 1e8, 0};
  const Camera camera(v, 2, 2);
  check_near(camera.ray(2, 1).direction, normalize({1, 0, 1}));
  check_near(camera.ray(1, 0).direction, normalize({1, 1, 0}));
}

TEST_CASE("camera: orthographic rays are parallel and start on the screen", "[camera]") {
  scene::View v = view({0, 0, 10}, {0, 0, -1});
  v.projection = scene::Projection::orthographic;
  v.width = 8;
  const Camera camera(v, 4, 2);
  // (1/4 - 1) 4 = -3; -(1/2 - 1) 4 (2/4) = 1.
  check_near(camera.ray(0.5, 0.5).origin, {-3, 1, 10});
  check_near(camera.ray(0.5, 0.5).direction, {0, 0, -1});
  check_near(camera.ray(3.5, 1.5).origin, {3, -1, 10});
  CHECK_FALSE(camera.has_one_origin());
}

TEST_CASE("camera: corners span the screen, skew or not", "[camera]") {
  scene::View v;
  v.projection = scene::Projection::corners;
  v.eye = {0, 0, 1};
  v.corners = {Vec3{-1, 1, 0}, Vec3{3, 1, 0}, Vec3{0, -1, 0}};
  const Camera camera(v, 4, 2);
  // a + 1/8 (b-a) + 1/4 (c-a) = (-1 + 0.5 + 0.25, 1 - 0.5, 0).
  check_near(camera.ray(0.5, 0.5).direction, normalize({-0.25, 0.5, -1}));
  check_near(camera.ray(0, 0).direction, normalize({-1, 1, -1}));
}

TEST_CASE("camera: scaling the look, or all lengths, by a power of two changes no bit", "[camera]") {
  scene::View v = view({1, 2, 3}, {0.3, -0.2, -0.7});
  scene::View w = v;
  w.look = v.look * 0x1p-300;
  w.up = v.up * 0x1p200;
  CHECK(Camera(v, 7, 5).ray(2.5, 3.5).direction == Camera(w, 7, 5).ray(2.5, 3.5).direction);
}
