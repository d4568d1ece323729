// Surfaces that lie in one another, and rays that start on several at once.

#include "base/math.hpp"
#include "build.hpp"
#include "catch.hpp"
#include "tracer/shadow.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

/// Counts the pixels of `out` by their red value.
int count(const Rendered& out, double value) {
  int n = 0;
  for (int y = 0; y < out.image.height(); ++y) {
    for (int x = 0; x < out.image.width(); ++x)
      n += out.image.pixel(x, y)[0] == static_cast<float>(value) ? 1 : 0;
  }
  return n;
}

Affine crooked(int i) {
  return then(rotation({7.0 * i, 31.0 * i, 53.0 * i}),
              translation(Vec3{3.1, -2.7, 0.9} * static_cast<double>(i)));
}

/// A triangle in the plane z = 0 of the map, larger than what is seen of it.
void add_sheet(Scene& s, const Material& m, const Affine& map, double turn) {
  const double c = math::cos_deg(turn), n = math::sin_deg(turn);
  const auto at = [&](double x, double y) { return Vec3{x * c - y * n, x * n + y * c, 0}; };
  add_facet(s, at(-29, -27), at(31, -28), at(0.3, 39), m, map);
}

}  // namespace

TEST_CASE("coincident: a box's face in a plane has the colour of what was added first, without speckles",
          "[coincident]") {
  for (int i = 0; i < 6; ++i) {
    for (const bool box_first : {true, false}) {
      Scene s;
      s.settings.ambient = grey(1);
      if (box_first) add_box(s, {-1, -1, -1}, {1, 1, 0}, glowing(0.25), crooked(i));
      add_plane(s, {5, 4, 0}, {0, 0, 1}, glowing(0.5), crooked(i));
      if (!box_first) add_box(s, {-1, -1, -1}, {1, 1, 0}, glowing(0.25), crooked(i));
      const Vec3 eye = crooked(i).point({0.3, -2, 4});
      const Rendered out = picture(s, view(eye, crooked(i).point({0, 0, 0}) - eye, 61, 60));
      const int inside = count(out, 0.25), outside = count(out, 0.5);
      CHECK(inside + outside == 61 * 61);
      // The outline is the one of the same box raised clear of all rounding by a bit too little to be seen.
      Scene raised;
      raised.settings.ambient = grey(1);
      add_box(raised, {-1, -1, -1}, {1, 1, 1e-9}, glowing(0.25), crooked(i));
      add_plane(raised, {5, 4, 0}, {0, 0, 1}, glowing(0.5), crooked(i));
      const int expected = count(picture(raised, view(eye, crooked(i).point({0, 0, 0}) - eye, 61, 60)), 0.25);
      CHECK(expected > 200);
      CHECK(inside == (box_first ? expected : 0));
    }
  }
}

TEST_CASE("coincident: facets that share a plane, however turned, are met in the order of adding",
          "[coincident]") {
  for (int i = 0; i < 12; ++i) {
    Scene s;
    s.settings.ambient = grey(1);
    for (int k = 0; k < 5; ++k) add_sheet(s, glowing(0.125 * (k + 1)), crooked(i), 17.0 * k * i);
    const Vec3 eye = crooked(i).point({0.3, -2, 1});
    const Rendered out = picture(s, view(eye, crooked(i).point({0, 0, 0}) - eye, 41, 30));
    CHECK(count(out, 0.125) == 41 * 41);
  }
}

TEST_CASE("coincident: a ray let through meets the next one in the same place", "[coincident]") {
  // Clear sheets with a glow of their own: 1/4 + 1/2 (1/8 + 1/2 (1)), two deviations.
  for (int i = 0; i < 6; ++i) {
    Scene s;
    s.settings.ambient = grey(1);
    Material a = clear(0.5, 1), b = clear(0.5, 1);
    a.ambient.color = grey(0.25);
    b.ambient.color = grey(0.125);
    add_sheet(s, a, crooked(i), 0);
    add_sheet(s, b, crooked(i), 33);
    add_sheet(s, glowing(1), crooked(i), 71);
    const Vec3 eye = crooked(i).point({0.3, -2, 3});
    const scene::View v = view(eye, crooked(i).point({0, 0, 0}) - eye, 21, 30);
    s.settings.depth = 2;
    CHECK(count(picture(s, v), 0.25 + 0.0625 + 0.25) == 21 * 21);
    s.settings.depth = 1;
    CHECK(count(picture(s, v), 0.25 + 0.0625) == 21 * 21);
  }
}

TEST_CASE("coincident: a mirror does not show what lies in it", "[coincident]") {
  for (int i = 0; i < 6; ++i) {
    Scene s;
    s.settings.ambient = grey(1);
    s.settings.background = grey(0.5);
    add_sheet(s, mirror(0.5), crooked(i), 0);
    add_sheet(s, glowing(1), crooked(i), 40);
    const Vec3 eye = crooked(i).point({0.3, -2, 3});
    CHECK(count(picture(s, view(eye, crooked(i).point({0, 0, 0}) - eye, 21, 30)), 0.25) == 21 * 21);
  }
}

TEST_CASE("coincident: a lit surface is not shadowed by one that lies in it", "[coincident]") {
  for (int i = 0; i < 6; ++i) {
    Scene s;
    s.settings.ambient = {};
    add_plane(s, {0, 0, 0}, {0, 0, 1}, matt(1), crooked(i));
    add_box(s, {-3, -3, -1}, {3, 3, 0}, matt(1), crooked(i));
    add_sheet(s, matt(1), crooked(i), 40);
    s.lights.push_back(sun(crooked(i).vector({0, 0, -1})));
    const Vec3 eye = crooked(i).point({0.3, -2, 3});
    const Rendered out = picture(s, view(eye, crooked(i).point({0, 0, 0}) - eye, 21, 30));
    for (const float value : out.image.data()) REQUIRE(value == Approx(1).epsilon(1e-6));
  }
}

TEST_CASE("coincident: a glass block on a table lets the table be seen and lit through it", "[coincident]") {
  // Down into the block (1/2), out of it or into the table first, whichever was added first. The lamp's light
  // crosses the block's top, and its bottom too where that lies above what is lit.
  for (int i = 0; i < 6; ++i) {
    for (const bool table_first : {true, false}) {
      Scene s;
      s.settings.ambient = {};
      if (table_first) add_plane(s, {0, 0, 0}, {0, 0, 1}, matt(1), crooked(i));
      add_box(s, {-3, -3, 0}, {3, 3, 1}, clear(0.5, 1), crooked(i));
      if (!table_first) add_plane(s, {0, 0, 0}, {0, 0, 1}, matt(1), crooked(i));
      s.lights.push_back(sun(crooked(i).vector({0, 0, -1})));
      const Vec3 eye = crooked(i).point({0.1, -0.2, 4});
      const Rendered out = picture(s, view(eye, crooked(i).vector({0, 0, -1}), 21, 20));
      // Table first: the ray meets it while still in the block: 1/2 seen x 1/2 lit (the light leaves through
      // the top; it starts inside the block). Block first: the ray has left the block through its bottom: 1/4
      // seen; the light, starting below the bottom, crosses bottom and top: 1/4 lit.
      const double expected = table_first ? 0.5 * 0.5 : 0.25 * 0.25;
      for (const float value : out.image.data()) REQUIRE(value == Approx(expected).epsilon(1e-6));
    }
  }
}

TEST_CASE("coincident: what lies under a clear facet is seen and lit through it, and shines back through it",
          "[coincident]") {
  for (int i = 0; i < 6; ++i) {
    for (const bool plane : {true, false}) {
      const Vec3 eye = crooked(i).point({0.3, -2, 3});
      const scene::View v = view(eye, crooked(i).point({0, 0, 0}) - eye, 21, 30);
      const auto under_clear_sheet = [&](const Material& m) {
        Scene s;
        s.settings.ambient = {};
        s.settings.background = grey(1);
        add_sheet(s, clear(0.5, 1), crooked(i), 0);
        if (plane) {
          add_plane(s, {5, 4, 0}, {0, 0, 1}, m, crooked(i));
        } else {
          add_sheet(s, m, crooked(i), 40);
        }
        s.lights.push_back(sun(crooked(i).vector({0, 0, -1})));
        return picture(s, v);
      };
      CHECK(count(under_clear_sheet(mirror(0.5)), 0.5 * 0.5 * 0.5) == 21 * 21);
      const Rendered lit = under_clear_sheet(matt(1));
      for (const float value : lit.image.data()) REQUIRE(value == Approx(0.5 * 0.5).epsilon(1e-6));
    }
  }
}

TEST_CASE("coincident: spheres in one another are met in the order of adding", "[coincident]") {
  Scene s;
  s.settings.ambient = grey(1);
  add_sphere(s, {0.1, 0.2, 0.3}, 1, glowing(0.5));
  add_sphere(s, {0.1, 0.2, 0.3}, 1, glowing(1));
  add_sphere(s, {0, 0, 0}, 0.5, glowing(1), then(scaling({2, 2, 2}), translation({0.1, 0.2, 0.3})));
  const Rendered out = picture(s, view({0, 0, 5}, {0, 0, -1}, 101, 40));
  CHECK(count(out, 0.5) > 1000);
  CHECK(count(out, 1) == 0);
}

TEST_CASE("coincident: surfaces that differ by the rounding of their numbers count as one place",
          "[coincident]") {
  Scene s;
  s.settings.ambient = grey(1);
  add_plane(s, {0, 0, 0.3}, {0, 0, 1}, glowing(0.5));
  add_box(s, {-1, -1, 0}, {1, 1, 0.1 + 0.2}, glowing(1));  // 0.30000000000000004
  CHECK(count(picture(s, view({0.1, 0.2, 2}, {0, 0, -1}, 31, 20)), 0.5) == 31 * 31);
}

TEST_CASE("coincident: a gap far above rounding is a gap", "[coincident]") {
  Scene s;
  s.settings.ambient = grey(1);
  add_plane(s, {0, 0, 0}, {0, 0, 1}, glowing(0.5));
  add_box(s, {-1, -1, -1}, {1, 1, 1e-13}, glowing(1));
  CHECK(count(picture(s, view({0.1, 0.2, 2}, {0, 0, -1}, 31, 20)), 1) == 31 * 31);
}

TEST_CASE("coincident: in the corner of a room mirrors show each other", "[coincident]") {
  // Rays into the very edge between floor and wall: whatever is first, both reflect, and none leaks out
  // behind.
  Scene s;
  s.settings.background = grey(1);
  s.settings.ambient = grey(1);
  s.settings.depth = 4;
  add_plane(s, {0, 0, 0}, {0, 1, 0}, mirror(0.5));
  add_plane(s, {0, 0, 0}, {0, 0, 1}, mirror(0.5));
  CHECK(seen(s, {0, 1, 1}, {0, -1, -1}).r == 0.25);
  CHECK(seen(s, {0.3, 1.7, 0.9}, {0.1, -1.7, -0.9}).r == 0.25);
}

TEST_CASE("coincident: light through a mesh aimed at its edges and corners crosses it once each way",
          "[coincident]") {
  Scene s;
  s.settings.ambient = grey(1);
  s.settings.depth = 6;
  Material m = clear(0.5, 1);
  m.ambient.color = grey(0.125);
  for (const bool solid : {true, false}) {
    Scene t = s;
    add_mesh(t, cube_mesh(solid), m);
    add_plane(t, {0, 0, -4}, {0, 0, 1}, glowing(1));
    // Along the diagonals of front and back.
    CHECK(seen(t, {0, 0, 5}, {0, 0, -1}).r == 0.125 + 0.0625 + 0.25);
    CHECK(seen(t, {0.5, -0.5, 5}, {0, 0, -1}).r == 0.125 + 0.0625 + 0.25);
  }
}

TEST_CASE("coincident: a ray in a plane sees what it passes, not only the plane", "[coincident]") {
  // All of the rays of the middle row lie in the plane but for rounding; the ball is met before or after,
  // never lost.
  Scene s;
  s.settings.background = grey(1);
  s.settings.depth = 100;
  const Affine map = crooked(3);
  add_plane(s, {0, 0, 0}, {0, 0, 1}, clear(1, 1), map);
  add_sphere(s, {0, 0, 0}, 1, glowing(0.5), map);
  s.settings.ambient = grey(1);
  for (int i = 0; i < 50; ++i) {
    const double x = -0.9 + 0.036 * i;
    CHECK(seen(s, map.point({x, 9, 0}), map.vector({0, -1, 0})).r == 0.5);
  }
}

TEST_CASE("coincident: planes nearly so part at one clean line, without speckles", "[coincident]") {
  // Near by the gap is far above rounding, far away below it; in between every column changes its colour
  // once.
  for (const double gap : {1e-15, 3e-15, 1e-14, 1e-13, 1e-12}) {
    for (const double height : {1e-3, 1.0, 1e3}) {
      Scene s;
      s.settings.ambient = grey(1);
      add_plane(s, {0, 0, 0}, {0, 1, 0}, glowing(0.25));
      add_plane(s, {0, gap * height, 0}, {0, 1, 0}, glowing(0.5));
      const Rendered out = picture(s, view({0.3 * height, height, 2 * height}, {0.1, -0.31, -1}, 81, 70));
      int speckled = 0;
      for (int x = 0; x < 81; ++x) {
        int changes = 0;
        for (int y = 1; y < 81; ++y) {
          changes += out.image.pixel(x, y)[0] != out.image.pixel(x, y - 1)[0] ? 1 : 0;
        }
        speckled += changes > 2 ? 1 : 0;  // from the sky to one plane, from that to the other
      }
      INFO("gap " << gap << ", height " << height);
      CHECK(speckled == 0);
    }
  }
}

TEST_CASE("coincident: no light comes through the edge of two walls", "[coincident]") {
  // The light is behind the wall; where a ray meets the floor within rounding of the edge, the wall stops
  // what goes on towards it, although the ray itself passed the wall by.
  for (int i = 0; i < 6; ++i) {
    for (const bool box : {false, true}) {
      Scene s;
      if (box) {
        add_box(s, {-9, -9, -9}, {9, 0, 9}, glowing(0), crooked(i));
      } else {
        add_facet(s, {0, 0, 0}, {0, 0, 1}, {2, 0, 1}, glowing(0), crooked(i));
        add_facet(s, {0, 0, 0}, {2, 0, 1}, {2, 0, 0}, glowing(0), crooked(i));
      }
      add_facet(s, {0, 0, 0}, {0, 2, 0}, {0, 2, 1}, glowing(0), crooked(i));
      add_facet(s, {0, 0, 0}, {0, 2, 1}, {0, 0, 1}, glowing(0), crooked(i));
      const World world = prepare(s);
      const Vec3 eye = crooked(i).point({1, 1, 0.5}), lamp = crooked(i).point({-3, 2, 0.5});
      int met = 0, lit = 0;
      for (int k = 1; k < 500; ++k) {
        const Vec3 aim = crooked(i).point({0, 0, k / 500.0});
        Stats stats;
        Hit hit;
        if (!closest(world, Ray{eye, normalize(aim - eye), 0, {}, {}}, stats, hit)) continue;
        ++met;
        const Vec3 way = lamp - hit.point;
        if (dot(way, hit.normal) <= 0) continue;
        const Ray onward = ray_from(world, hit, normalize(way));
        lit += light_through(world, ShadowWork::blocked, onward, length(way), stats).r > 0 ? 1 : 0;
      }
      CHECK(met > 400);
      CHECK(lit == 0);
    }
  }
}
