#include "tracer/shadow.hpp"

#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

/// A white floor y = 0 seen at the origin from the side, a lamp 10 above.
Scene lit_floor() {
  Scene s;
  s.settings.ambient = {};
  add_plane(s, {0, 0, 0}, {0, 1, 0}, matt(1));
  s.lights.push_back(point_light({0, 10, 0}));
  return s;
}

Color floor_color(const Scene& s) { return seen(s, {3, 1, 0}, {-3, -1, 0}); }

}  // namespace

TEST_CASE("shadow: filtered light has crossed a clear ball twice", "[shadow]") {
  Scene s = lit_floor();
  Material m = clear(0.5, 1.5);
  m.fresnel = true;  // which shadows do not care for
  m.transmission.color = {0.5, 1, 0};
  add_sphere(s, {0, 5, 0}, 1, m);
  CHECK(floor_color(s) == Color{0.25, 1, 0});
}

TEST_CASE("shadow: an opaque thing in between leaves nothing, none or a distant one all", "[shadow]") {
  Scene s = lit_floor();
  CHECK(floor_color(s).r == 1);
  add_sphere(s, {2, 5, 0}, 1, matt(1));
  CHECK(floor_color(s).r == 1);
  add_sphere(s, {0, 5, 0}, 1, matt(1));
  CHECK(floor_color(s).r == 0);
}

TEST_CASE("shadow: opaque shadows know no clear things, off knows no shadows", "[shadow]") {
  Scene s = lit_floor();
  add_sphere(s, {0, 5, 0}, 1, clear(0.5, 1));
  s.settings.shadows = scene::Shadows::opaque;
  CHECK(floor_color(s).r == 0);
  s.settings.shadows = scene::Shadows::off;
  CHECK(floor_color(s).r == 1);
}

TEST_CASE("shadow: what has shadow false is not in the way", "[shadow]") {
  Scene s = lit_floor();
  add_sphere(s, {0, 5, 0}, 1, matt(1));
  s.shapes.back().shadow = false;
  for (const auto mode : {scene::Shadows::filtered, scene::Shadows::opaque}) {
    s.settings.shadows = mode;
    CHECK(floor_color(s).r == 1);
  }
}

TEST_CASE("shadow: what lies behind the light is not in the way, behind a sun nothing is", "[shadow]") {
  Scene s = lit_floor();
  add_sphere(s, {0, 15, 0}, 1, matt(1));
  CHECK(floor_color(s).r == 1);
  s.lights[0] = sun({0, -1, 0});
  CHECK(floor_color(s).r == 0);
}

TEST_CASE("shadow: a lamp that touches a ceiling is not behind it", "[shadow]") {
  Scene s = lit_floor();
  add_plane(s, {0, 10, 0}, {0, -1, 0}, matt(1));
  CHECK(floor_color(s).r == 1);
}

TEST_CASE("shadow: light from within a clear ball crosses one surface", "[shadow]") {
  Scene s = lit_floor();
  add_sphere(s, {0, 10, 0}, 1, clear(0.5, 1));
  CHECK(floor_color(s).r == 0.5);
}

TEST_CASE("shadow: a clear facet is crossed once, a clear box twice", "[shadow]") {
  Scene s = lit_floor();
  add_facet(s, {-1, 5, -1}, {1, 5, -1}, {0, 5, 2}, clear(0.5, 1));
  CHECK(floor_color(s).r == 0.5);
  add_box(s, {-1, 6, -1}, {1, 7, 1}, clear(0.5, 1));
  CHECK(floor_color(s).r == 0.125);
}

TEST_CASE("shadow: where facets of a mesh meet it is crossed once each way", "[shadow]") {
  // The diagonals of the cube's top and bottom lie right above the floor's origin.
  Scene s = lit_floor();
  add_mesh(s, cube_mesh(true), clear(0.5, 1), translation({0, 5, 0}));
  CHECK(floor_color(s).r == 0.25);
}

TEST_CASE("shadow: transmission is looked up at the point crossed", "[shadow]") {
  // Stripes of 2: the bottom y = 4 begins cell 2, a; the top y = 6 begins cell 3, b.
  Scene s = lit_floor();
  scene::Pattern p;
  p.kind = scene::Pattern::Kind::stripes;
  p.a = {1, 0.5, 0.25};
  p.b = {0.5, 0.5, 0.5};
  p.axis = {0, 1, 0};
  p.size = 2;
  s.patterns.push_back(p);
  Material m = clear(1, 1);
  m.transmission.pattern = 0;
  add_box(s, {-1, 4, -1}, {1, 6, 1}, m);
  CHECK(floor_color(s) == Color{0.5, 0.25, 0.125});
}

TEST_CASE("shadow: a lit surface does not shadow itself, its far side does", "[shadow]") {
  Scene s;
  s.settings.ambient = {};
  add_sphere(s, {0, 0, 0}, 1, matt(1));
  s.lights.push_back(sun({0, 0, -1}));
  CHECK(seen(s, {0, 0, 5}, {0, 0, -1}).r == Approx(1));
  // From inside, lit from outside through the ball's own wall: opaque, so dark.
  CHECK(seen(s, {0, 0, 0}, {0, 0, -1}).r == 0);
  s.materials.back().transmission.color = grey(0.5);
  s.settings.depth = 0;
  CHECK(seen(s, {0, 0, 0}, {0, 0, -1}).r == Approx(0.5));
}

TEST_CASE("shadow: the order of the search does not show in the product", "[shadow]") {
  // Colours whose product depends on the order in its last bit; the tree is built over different neighbours.
  Random random(2);
  std::vector<Color> colors;
  for (int i = 0; i < 12; ++i)
    colors.push_back({random.between(0.9, 1), random.between(0.9, 1), random.between(0.9, 1)});
  Color first;
  for (int variant = 0; variant < 4; ++variant) {
    Scene s = lit_floor();
    for (int i = 0; i < 12; ++i) {
      Material m = clear(1, 1);
      m.transmission.color = colors[static_cast<std::size_t>(i)];
      add_sphere(s, {0, 1 + 0.6 * i, 0}, 0.25, m);
    }
    for (int i = 0; i < 40 * variant; ++i) add_sphere(s, random.in_cube(2) + Vec3{30, 0, 0}, 0.1);
    if (variant == 0) first = floor_color(s);
    CHECK(floor_color(s) == first);
  }
}
