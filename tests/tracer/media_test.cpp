#include "tracer/media.hpp"

#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

std::vector<std::uint32_t> open_list(const Scene& s, Vec3 eye, Vec3 direction) {
  const World world = prepare(s);
  Stats stats;
  const OpenSolids open = open_at(world, solids_around(world, eye), eye, normalize(direction), stats);
  return {open.begin(), open.end()};
}

using List = std::vector<std::uint32_t>;

/// A plane z = `z` that glows with a gradient in x, from 0 at x = 0 to 1 at x = `to`.
void add_ruler(Scene& s, double z, double to) {
  Material m = glowing(1);
  m.ambient.pattern = 0;
  scene::Pattern p;
  p.kind = scene::Pattern::Kind::gradient;
  p.b = grey(1);
  p.to = {to, 0, 0};
  s.patterns.push_back(p);
  add_plane(s, {0, 0, z}, {0, 0, 1}, m);
  s.settings.ambient = grey(1);
}

/// A slab with the given index.
void add_slab(Scene& s, double low, double high, double ior) {
  add_box(s, {-50, -50, low}, {50, 50, high}, clear(1, ior));
}

/// How far a ray that arrives at 45 degrees goes along x for each unit of depth in a medium of this index.
double drift(double ior) {
  const double sine = std::sqrt(0.5) / ior;
  return sine / std::sqrt(1 - sine * sine);
}

double seen_at_45_degrees(const Scene& s) { return seen(s, {-1, 0, 1}, {1, 0, -1}).r; }

}  // namespace

TEST_CASE("media: overlapping solids, the most recently entered one still open counts", "[media]") {
  // Glass [-2, 0] and diamond [-3, -1]: glass, diamond, diamond (leaving glass closes glass), air.
  for (const bool swapped : {false, true}) {
    Scene s;
    if (!swapped) add_slab(s, -2, 0, 1.5);
    add_slab(s, -3, -1, 2);
    if (swapped) add_slab(s, -2, 0, 1.5);
    add_ruler(s, -4, 4);
    CHECK(seen_at_45_degrees(s) == Approx((drift(1.5) + 2 * drift(2) + 1) / 4));
  }
}

TEST_CASE("media: leaving an inner solid returns to the outer one's index", "[media]") {
  Scene s;
  add_slab(s, -3, 0, 1.5);
  add_slab(s, -2, -1, 2);
  add_ruler(s, -4, 4);
  CHECK(seen_at_45_degrees(s) == Approx((drift(1.5) + drift(2) + drift(1.5) + 1) / 4));
}

TEST_CASE("media: touching solids leave no gap, whichever was added first", "[media]") {
  for (const bool swapped : {false, true}) {
    Scene s;
    if (!swapped) add_slab(s, -1, 0, 1.5);
    add_slab(s, -2, -1, 2);
    if (swapped) add_slab(s, -1, 0, 1.5);
    add_ruler(s, -3, 4);
    CHECK(seen_at_45_degrees(s) == Approx((drift(1.5) + drift(2) + 1) / 4));
  }
}

TEST_CASE("media: a solid mesh counts, an open one does not", "[media]") {
  for (const bool solid : {true, false}) {
    Scene s;
    add_mesh(s, cube_mesh(solid), clear(1, 1.5), then(scaling({50, 50, 0.5}), translation({0, 0, -0.5})));
    add_ruler(s, -2, 4);
    CHECK(seen(s, {-1, 0.3, 1}, {1, 0, -1}).r == Approx((solid ? drift(1.5) + 1 : 2) / 4));
  }
}

TEST_CASE("media: an eye in glass looks out of glass", "[media]") {
  // At 30 degrees out of 1.5: sin t = 0.75; the ruler lies 1 outside.
  Scene s;
  add_slab(s, -1, 4, 1.5);
  add_ruler(s, -2, 4);
  const double out = 0.75 / std::sqrt(1 - 0.75 * 0.75);
  CHECK(seen(s, {-std::sqrt(1.0 / 3), 0, 0}, {0.5, 0, -std::sqrt(0.75)}).r == Approx(out / 4));
}

TEST_CASE("media: each ray of an orthographic view starts in what lies around its own start", "[media]") {
  // The screen lies in z = 0; its left half, x < 0, is in glass that ends at z = -1. All rays lean by 45
  // degrees, where glass of 1.25 still lets light out: sin t = 1.25 sqrt(1/2), and the ruler lies 1 outside.
  Scene s;
  add_box(s, {-50, -50, -1}, {0, 50, 50}, clear(1, 1.25));
  add_ruler(s, -2, 10);
  scene::View v = view({0, 0, 0}, {0, 1, -1}, 2);
  v.projection = scene::Projection::orthographic;
  v.up = {0, 1, 1};
  v.width = 8;  // starts at x = -2 and 2
  v.rows = 1;
  s.patterns[0].from = {0, 0, 0};
  s.patterns[0].to = {0, 10, 0};
  const Rendered out = picture(s, v);
  const double sine = 1.25 * std::sqrt(0.5);
  CHECK(out.image.pixel(0, 0)[0] == Approx((1 + sine / std::sqrt(1 - sine * sine)) / 10).epsilon(1e-6));
  CHECK(out.image.pixel(1, 0)[0] == Approx(2.0 / 10).epsilon(1e-6));
}

TEST_CASE("media: solids around an eye are ordered by where the ray leaves them", "[media]") {
  Scene s;
  add_sphere(s, {0, 0, 0}, 1);          // 0
  add_sphere(s, {2, 0, 0}, 4);          // 1: to the right it ends at 6, to the left at -2
  add_box(s, {-9, -9, -9}, {3, 9, 9});  // 2: at 3 and -9
  add_plane(s, {0, 5, 0}, {0, 1, 0});   // 3: never left sideways
  add_sphere(s, {20, 0, 0}, 1);
  CHECK(open_list(s, {0, 0, 0}, {1, 0, 0}) == List{3, 1, 2, 0});
  CHECK(open_list(s, {0, 0, 0}, {-1, 0, 0}) == List{3, 2, 1, 0});
  CHECK(open_list(s, {0, 0, 0}, {0, 1, 0}) == List{2, 3, 1, 0});  // at 9, 5, sqrt 12, 1
  CHECK(open_list(s, {50, 50, 50}, {0, 1, 0}).empty());
}

TEST_CASE("media: solids left at the same place keep their order, first added outermost", "[media]") {
  Scene s;
  add_sphere(s, {0, 0, 0}, 1);
  add_box(s, {-1, -1, -1}, {1, 1, 1});
  add_plane(s, {5, 0, 0}, {0, 1, 0});
  CHECK(open_list(s, {0.5, -0.1, 0}, {1, 0, 0}).size() == 3);
  CHECK(open_list(s, {0, -0.5, 0}, {1, 0, 0})[0] == 2);
}

TEST_CASE("media: rounding does not order solids left through coincident surfaces", "[media]") {
  for (int i = 0; i < 6; ++i) {
    const Affine map =
        then(rotation({7.0 * i, 31.0 * i, 53.0 * i}), translation({3.1 * i, -2.7 * i, 0.9 * i}));
    Scene s;
    add_box(s, {-1, -1, -1}, {1, 1, 2}, {}, map);
    add_plane(s, {5, 4, 2}, {0, 0, 1}, {}, map);
    add_mesh(s, cube_mesh(true), {}, then(then(scaling({7, 7, 3}), translation({0, 0, -1})), map));
    const Vec3 eye = map.point({0.1, 0.2, 1.5});
    for (int k = 0; k < 200; ++k) {
      const Vec3 direction = map.vector({0.01 * (k % 20) - 0.1, 0.02 * (k / 20) - 0.09, 1});
      REQUIRE(open_list(s, eye, direction) == List{0, 1, 2});
    }
  }
}

TEST_CASE("media: an eye on a surface is inside if it looks in", "[media]") {
  Scene s;
  add_box(s, {-1, -1, -1}, {1, 1, 1});
  add_plane(s, {0, 0, 1}, {0, 0, 1});
  CHECK(open_list(s, {0, 0, 1}, {0, 0, -1}) == List{1, 0});
  CHECK(open_list(s, {0, 0, 1}, {0, 0, 1}).empty());
}

TEST_CASE("media: crossing opens and closes that very solid", "[media]") {
  Scene s;
  for (int i = 0; i < 3; ++i) add_sphere(s, {0, 0, 0}, 1 + i, clear(1, 1.5 + i));
  add_facet(s, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, clear(1, 9));
  s.settings.ior = 1.1;
  const World world = prepare(s);
  OpenSolids open;
  CHECK(refractive_index(world, open) == 1.1);
  cross(world, open, 0, true);
  cross(world, open, 1, true);
  cross(world, open, 2, true);
  CHECK(refractive_index(world, open) == 3.5);
  cross(world, open, 1, false);  // from the middle
  CHECK(refractive_index(world, open) == 3.5);
  cross(world, open, 2, false);
  CHECK(refractive_index(world, open) == 1.5);
  cross(world, open, 2, false);  // not open: nothing
  cross(world, open, 3, true);   // a facet: nothing
  CHECK(refractive_index(world, open) == 1.5);
  CHECK(open.size() == 1);
}

TEST_CASE("media: an eye in an opaque room sees its walls", "[media]") {
  Scene s;
  s.settings.ambient = grey(1);
  add_box(s, {-1, -1, -1}, {1, 1, 1}, glowing(0.25));
  add_sphere(s, {0, 0, -0.5}, 0.25, clear(1, 1.5));
  CHECK(seen(s, {0, 0, 0.5}, {1, 0.3, 0}).r == 0.25);
  CHECK(seen(s, {0, 0, 0.5}, {0, 0, -1}).r == 0.25);
}

TEST_CASE("media: a ray that touches a glass ball exactly is not inside of it afterwards", "[media]") {
  // The ball lies in glass of its own index, in front of a wall whose colour tells how the ray was bent where
  // it left the glass: with the ball and without it the same is seen.
  Scene s;
  s.settings.depth = 20;
  s.settings.ambient = grey(1);
  scene::Pattern gradient;
  gradient.kind = scene::Pattern::Kind::gradient;
  gradient.b = grey(1);
  gradient.from = {0, -10, 0};
  gradient.to = {0, 10, 0};
  s.patterns.push_back(gradient);
  Material wall = black();
  wall.ambient.pattern = 0;
  add_sphere(s, {0, 0, 0}, 5, clear(1, 1.5));
  add_plane(s, {-20, 0, 0}, {1, 0, 0}, wall);
  Scene with = s;
  add_sphere(with, {0, 0, -1}, 1, clear(1, 1.5));
  for (const Vec3 eye : {Vec3{4, -1, -1}, Vec3{4, 1, -1}}) {
    const Color bare = seen(s, eye, {-1, 0, 0});
    CHECK(bare.r != 0.5);
    CHECK(seen(with, eye, {-1, 0, 0}) == bare);
  }
}
