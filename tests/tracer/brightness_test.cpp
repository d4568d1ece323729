#include "tracer/brightness.hpp"

#include <cmath>

#include "base/math.hpp"
#include "catch.hpp"
#include "random_scene.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

TEST_CASE("brightness: ambient, lights and background at their most", "[brightness]") {
  Scene s;
  s.settings.ambient = grey(0.5);
  s.settings.background = {0.1, 0.2, 3};
  Material m = matt(0.8);
  m.ambient.color = grey(0.4);
  m.specular.color = grey(0.3);
  m.reflection.color = grey(0.25);
  add_sphere(s, {}, 1, m);
  s.lights.push_back(point_light({0, 5, 0}, 0.5));
  s.lights.push_back(sun({0, -1, 0}, 2));
  const Brightness b(s);
  // 0.4 * 0.5 + (0.8 + 0.3) * (0.5 + 2) = 2.95; the background's blue is brighter.
  CHECK(b.bound(0).r == Approx(2.95));
  CHECK(b.bound(0).b == 3);
  // 2.95 + 0.25 * 2.95; blue 2.95 + 0.25 * 3
  CHECK(b.bound(1).r == Approx(3.6875));
  CHECK(b.bound(1).b == Approx(3.7));
}

TEST_CASE("brightness: a lamp with falloff counts at its least distance", "[brightness]") {
  const auto own = [](const Scene& s) { return Brightness(s).bound(0).r; };
  Scene s;
  s.settings.ambient = {};
  add_sphere(s, {0, 0, 0}, 1, matt(1));
  s.lights.push_back(point_light({0, 5, 0}));
  s.lights[0].falloff = 2;
  CHECK(own(s) == Approx(0.25));  // (2 / 4)^2
  s.lights[0].at = {0, 0.5, 0};
  CHECK(own(s) == Approx(16));  // within: (2 / 0.5)^2
  s = Scene{};
  s.settings.ambient = {};
  add_box(s, {-1, -1, -1}, {1, 1, 1}, matt(1), translation({0, 0, 7}));
  s.lights.push_back(point_light({4, 0, 7}));
  s.lights[0].falloff = 3;
  CHECK(own(s) == Approx(1));
  s.lights[0].at = {0.5, 0, 7};
  CHECK(own(s) == Approx(36));
  s = Scene{};
  s.settings.ambient = {};
  add_plane(s, {0, -2, 0}, {0, 3, 0}, matt(1));
  s.lights.push_back(point_light({4, 0, 7}));
  s.lights[0].falloff = 1;
  CHECK(own(s) == Approx(0.25));
  s.lights[0].at = {1, -2, 5};
  CHECK(Brightness(s).near_lamp().has_value());
  CHECK(std::isinf(Brightness(s).bound(3).r));
}

TEST_CASE("brightness: glass that only passes light on does not grow with depth", "[brightness]") {
  Scene s;
  s.settings.background = grey(1);
  s.settings.depth = 2000000000;
  add_sphere(s, {}, 1, clear(1, 1.5));
  CHECK(Brightness(s).bound(1999999999) == grey(1));
  s.materials[0].reflection.color = grey(1);  // doubles at each
  CHECK(Brightness(s).bound(10).r == 1024);
  CHECK(std::isinf(Brightness(s).bound(1999999999).r));
}

TEST_CASE("brightness: no ray of a random scene brings more", "[brightness]") {
  int bounded = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Scene s = random_scene(seed);
    s.settings.sum = scene::Sum::linear;
    const Brightness b(s);
    if (b.near_lamp()) continue;
    ++bounded;
    const Color most = b.bound(s.settings.depth);
    const std::vector<float> rgb = values(s, random_view(seed, 12, 12));
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
      INFO("seed " << seed);
      REQUIRE(rgb[i] <= most.r * 1.0000001);
      REQUIRE(rgb[i + 1] <= most.g * 1.0000001);
      REQUIRE(rgb[i + 2] <= most.b * 1.0000001);
    }
  }
  CHECK(bounded > 150);
}

TEST_CASE("brightness: the tolerance is no more than the display curve allows, and concave", "[brightness]") {
  for (int i = 0; i < 4000; ++i) {
    const double x = i < 2000 ? i * 5e-6 : (i - 2000) / 2000.0;
    for (const double loss : {1e-3, 1e-2, 0.1}) {
      const double dark = x, bright = x + loss * tolerance(x);
      if (bright > 1) continue;
      REQUIRE(math::linear_to_srgb(bright) - math::linear_to_srgb(dark) <= loss);
    }
    const double h = x / 3;
    REQUIRE(tolerance(x - h) + tolerance(x + h) <= 2 * tolerance(x));
  }
}
