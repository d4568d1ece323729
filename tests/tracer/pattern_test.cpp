#include "tracer/pattern.hpp"

#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

const Color k_a{1, 0.5, 0}, k_b{0, 0.25, 1};

scene::Pattern pattern(scene::Pattern::Kind kind) {
  scene::Pattern p;
  p.kind = kind;
  p.a = k_a;
  p.b = k_b;
  return p;
}

OwnPoint at(double x, double y, double z, double error = 0) { return {{x, y, z}, {error, error, error}}; }

}  // namespace

TEST_CASE("pattern: a checker has a where the cell numbers sum to an even number", "[pattern]") {
  scene::Pattern p = pattern(scene::Pattern::Kind::checker);
  CHECK(color_at(p, at(0.5, 0.5, 0.5)) == k_a);
  CHECK(color_at(p, at(1.5, 0.5, 0.5)) == k_b);
  CHECK(color_at(p, at(1.5, -0.5, 0.5)) == k_a);  // 1 + -1 + 0
  CHECK(color_at(p, at(-0.5, 0.5, 0.5)) == k_b);
  CHECK(color_at(p, at(1, 1, 1)) == k_b);
  p.size = 2;
  CHECK(color_at(p, at(1.5, 0.5, 0.5)) == k_a);
  CHECK(color_at(p, at(2.5, 0.5, 0.5)) == k_b);
}

TEST_CASE("pattern: a coordinate within rounding of a boundary belongs to the cell above", "[pattern]") {
  const scene::Pattern p = pattern(scene::Pattern::Kind::checker);
  CHECK(color_at(p, at(0.5, -1e-17, 0.5, 1e-16)) == k_a);
  CHECK(color_at(p, at(0.5, -1e-15, 0.5, 1e-16)) == k_b);
  scene::Pattern s = pattern(scene::Pattern::Kind::stripes);
  s.axis = {0, 1, 0};
  s.size = 0.1;
  CHECK(color_at(s, at(0, 0.3, 0, 1e-16)) ==
        k_b);  // 0.3 / 0.1 is 2.9999999999999996 in doubles; cell 3 is meant
}

TEST_CASE("pattern: stripes count widths along the axis", "[pattern]") {
  scene::Pattern p = pattern(scene::Pattern::Kind::stripes);
  p.axis = {0, 10, 0};
  p.size = 0.5;
  CHECK(color_at(p, at(7, 0.25, 3)) == k_a);
  CHECK(color_at(p, at(7, 0.75, 3)) == k_b);
  CHECK(color_at(p, at(7, -0.25, 3)) == k_b);
  p.axis = {3, 4, 0};  // (3, 4)/5 . (1, 1) = 1.4, cell 2
  CHECK(color_at(p, at(1, 1, 0)) == k_a);
}

TEST_CASE("pattern: a gradient runs between its points and stays beyond them", "[pattern]") {
  scene::Pattern p = pattern(scene::Pattern::Kind::gradient);
  p.from = {1, 0, 0};
  p.to = {3, 0, 0};
  CHECK(color_at(p, at(0, 5, 5)) == k_a);
  CHECK(color_at(p, at(4, 5, 5)) == k_b);
  const Color quarter = color_at(p, at(1.5, -2, 9));  // t = 0.25
  CHECK(quarter.r == Approx(0.75));
  CHECK(quarter.g == Approx(0.5 * 0.75 + 0.25 * 0.25));
  CHECK(quarter.b == Approx(0.25));
}

TEST_CASE("pattern: it lives in the shape's own space", "[pattern]") {
  // A stripe pattern of width 1 along x on a plane that is scaled by 4 and moved by 2: own x = (x - 2) / 4.
  Scene s;
  s.settings.ambient = grey(1);
  Material m = glowing(1);
  m.ambient.pattern = 0;
  s.patterns.push_back(pattern(scene::Pattern::Kind::stripes));
  s.patterns[0].axis = {1, 0, 0};
  add_plane(s, {0, 0, 0}, {0, 0, 1}, m, then(scaling({4, 4, 4}), translation({2, 0, 0})));
  CHECK(seen(s, {3, 0, 5}, {0, 0, -1}) == k_a);
  CHECK(seen(s, {5.9, 0, 5}, {0, 0, -1}) == k_a);
  CHECK(seen(s, {6.1, 0, 5}, {0, 0, -1}) == k_b);
  CHECK(seen(s, {1.9, 0, 5}, {0, 0, -1}) == k_b);
}

TEST_CASE("pattern: a face that lies in a cell boundary has no speckles, turned and moved as it may be",
          "[pattern]") {
  // The top of a box at y = 1 in its own space is the bottom of the cells above: 1 + even for x, z in [0, 1).
  for (const Affine& map :
       {Affine{}, then(rotation({13, 29, 71}), translation({3.3, -7.1, 0.7})),
        then(scaling({0.1, 0.3, 0.7}), rotation({45, 10, 5})), translation({1e6, 1e6, 1e6})}) {
    Scene s;
    s.settings.ambient = grey(1);
    Material m = glowing(1);
    m.ambient.pattern = 0;
    s.patterns.push_back(pattern(scene::Pattern::Kind::checker));
    add_box(s, {0, 0, 0}, {1, 1, 1}, m, map);
    Random random(17);
    for (int i = 0; i < 300; ++i) {
      const Vec3 target = map.point({random.between(0.01, 0.99), 1, random.between(0.01, 0.99)});
      const Vec3 from = map.point({random(), 3, random()});
      REQUIRE(seen(s, from, target - from) == k_b);
    }
  }
}

TEST_CASE("pattern: black is told from dark", "[pattern]") {
  Scene s;
  s.patterns.push_back(pattern(scene::Pattern::Kind::checker));
  s.patterns.push_back(scene::Pattern{});
  CHECK_FALSE(is_black(s, {{}, 0}));
  CHECK(is_black(s, {{1, 1, 1}, 1}));
  CHECK(is_black(s, {{}, scene::k_none}));
  CHECK_FALSE(is_black(s, {grey(1e-300), scene::k_none}));
}

TEST_CASE("pattern: far from the origin a boundary lies where it is, not where sums are rounded to",
          "[pattern]") {
  const scene::Pattern p = pattern(scene::Pattern::Kind::checker);
  // 2^60 + 512 - 0.1 is rounded to the boundary 2^60 + 512, but lies in the odd cell before it.
  const double far = 0x1p60 + 512;
  CHECK(color_at(p, {{far, 0.5, 0.5}, {}, {-0.1, 0, 0}}) == k_b);
  CHECK(color_at(p, {{far, 0.5, 0.5}, {}, {0.1, 0, 0}}) == k_a);
  CHECK(color_at(p, {{far, 0.5, 0.5}, {}, {-41.5, 0, 0}}) == k_a);
  CHECK(color_at(p, {{far, 0.5, 0.5}, {0.2, 0, 0}, {-0.1, 0, 0}}) == k_a);
  scene::Pattern g = pattern(scene::Pattern::Kind::gradient);
  g.from = {0x1p60, 0, 0};
  g.to = {0x1p60 + 256, 0, 0};
  CHECK(color_at(g, {{0x1p60, 0, 0}, {}, {64, 0, 0}}) == k_a * 0.75 + k_b * 0.25);
}

TEST_CASE("pattern: a shape's own point is found from wherever the world starts", "[pattern]") {
  Scene s;
  add_sphere(s, {0, 0, 0}, 1, {}, then(rotation({0, 90, 0}), translation({0x1p60, 5, 0})));
  add_sphere(s, {0, 0, 0}, 1);
  const World near = prepare(s, {0x1p60, 4, 0}), far = prepare(s);
  // (0.25, 1.5, 0.125) past the origin is (0.25, 0.5, 0.125) past the centre; a quarter turn about y, undone.
  const OwnPoint turned = own_point(near, 0, {0.25, 1.5, 0.125}, 0);
  CHECK(turned.point == Vec3{-0.125, 0.5, 0.25});
  const OwnPoint plain = own_point(near, 1, {0.25, 1.5, 0.125}, 1e-9);
  CHECK(plain.point == Vec3{0x1p60, 5.5, 0.125});
  CHECK(plain.rest == Vec3{0.25, 0, 0});
  CHECK(plain.error == Vec3{1e-9, 1e-9, 1e-9});
  CHECK(own_point(far, 1, {0.25, 1.5, 0.125}, 0).point == Vec3{0.25, 1.5, 0.125});
}
