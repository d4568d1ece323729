#include "tracer/intersect.hpp"

#include "build.hpp"
#include "catch.hpp"
#include "tracer/crossings.hpp"
#include "tracer/shadow.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

/// All kinds of shapes, many of them overlapping, touching or coincident.
Scene crowd(std::uint64_t seed) {
  Random random(seed);
  Scene s;
  for (int i = 0; i < 60; ++i) {
    const Vec3 at = random.in_cube(4);
    const Affine map = then(rotation(random.in_cube(180)), translation(at));
    Material m = clear(0.5, 1 + random());
    m.reflection.color = grey(0.1);
    m.ambient.color = {random(), random(), random()};
    switch (i % 6) {
      case 0: add_sphere(s, at, random.between(0.1, 1), m); break;
      case 1: add_sphere(s, {}, random.between(0.1, 1), m, then(scaling({1, 2, 0.5}), map)); break;
      case 2: add_box(s, at, at + Vec3{random(), random(), random()}, m); break;
      case 3: add_box(s, {0, 0, 0}, {1, 0.5, 2}, m, map); break;
      case 4: {
        const Vec3 b = at + random.in_cube(2);
        add_facet(s, at, b, at + random.in_cube(2), m);
        break;
      }
      default: add_mesh(s, cube_mesh(i % 4 == 1), m, then(scaling({0.3, 0.5, 0.2}), map)); break;
    }
    if (i % 10 == 9) add_box(s, {-2, -2, -2}, {2, 2, at.z}, m);
  }
  add_plane(s, {0, -2, 0}, {0, 1, 0}, clear(0.5, 1));
  s.settings.ambient = grey(1);
  s.settings.background = grey(0.3);
  s.settings.depth = 5;
  s.lights.push_back(point_light({5, 9, 3}));
  return s;
}

/// The same world without a tree: every primitive is asked for every ray.
World without_tree(const Scene& s) {
  World world = prepare(s);
  world.unbounded.clear();
  for (std::uint32_t p = 0; p < world.primitives.size(); ++p) world.unbounded.push_back(p);
  world.bounded.clear();
  world.tree = Bvh();
  return world;
}

}  // namespace

TEST_CASE("intersect: the tree changes no bit of what is seen", "[intersect]") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Scene s = crowd(seed);
    const World world = prepare(s), plain = without_tree(s);
    const Plan needed = plan(s, {}, {});
    Tracer with_tree({&world, &needed, nullptr}), without({&plain, &needed, nullptr});
    Random random(seed + 100);
    int hits = 0;
    for (int i = 0; i < 400; ++i) {
      Ray ray{random.in_cube(8), random.direction(), 0, {}, {}};
      if (i % 4 == 0) ray.direction = Vec3{0, i % 8 == 0 ? 1.0 : -1.0, 0};
      if (i % 5 == 0) ray.origin = {ray.origin.x, ray.origin.y, s.spheres[0].center.z};
      const Color a = with_tree.radiance(ray, 5), b = without.radiance(ray, 5);
      REQUIRE(a == b);
      hits += a == grey(0.3) ? 0 : 1;
    }
    CHECK(hits > 100);
  }
}

TEST_CASE("intersect: shadow rays find the same with and without the tree", "[intersect]") {
  const Scene s = crowd(9);
  const World world = prepare(s), plain = without_tree(s);
  Random random(7);
  const auto found = [](const World& w, const Ray& ray, double distance) {
    Stats stats;
    std::vector<std::pair<std::uint32_t, double>> all;
    crossings(w, ray, distance, stats, [&](const Crossing& c) {
      all.emplace_back(c.primitive, c.root.t);
      return false;
    });
    std::sort(all.begin(), all.end());
    return all;
  };
  for (int i = 0; i < 1000; ++i) {
    const Ray ray{random.in_cube(8), random.direction(), 0, {}, {}};
    const double distance = i % 2 ? random() * 10 : std::numeric_limits<double>::infinity();
    REQUIRE(found(world, ray, distance) == found(plain, ray, distance));
  }
}

TEST_CASE("intersect: eye rays and shadow rays cross the same surfaces", "[intersect]") {
  // Unbent, with half of the light let through by each surface, what a ray sees of a white background is the
  // light that reaches its start along it: two ways to count crossings, one step by step, one all at once.
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const bool on_grid = seed % 2 == 0;  // then many faces are coincident
    const auto place = [&] {
      const Vec3 v = random.in_cube(3.49);
      return on_grid ? Vec3{std::round(v.x), std::round(v.y), std::round(v.z)} : v;
    };
    const Affine turned =
        seed % 3 == 0 ? then(rotation(random.in_cube(180)), translation({3, 1, 4})) : Affine{};
    Scene s;
    s.settings.background = grey(1);
    s.settings.ambient = {};
    const Material half = clear(0.5, 1);
    for (int i = 0; i < 6; ++i) {
      const Vec3 a = place();
      add_box(s, a, a + Vec3{1, 2, 1}, half, turned);
      add_sphere(s, place(), 1.5, half, turned);
      add_mesh(s, cube_mesh(i % 2 == 0), half, then(translation(place()), turned));
      add_plane(s, place(), {0, 0, i % 2 == 0 ? 1.0 : -1.0}, half, turned);
      add_facet(s, {-9, -9, a.z}, {9, -9, a.z}, {0, 9, a.z}, half, turned);
    }
    const World world = prepare(s);
    const Plan needed = plan(s, {}, {});
    Tracer tracer({&world, &needed, nullptr});
    Stats stats;
    for (int i = 0; i < 100; ++i) {
      const Ray ray{turned.point(random.in_cube(9)), random.direction(), 0, {}, {}};
      const Color through =
          light_through(world, ShadowWork::filtered, ray, std::numeric_limits<double>::infinity(), stats);
      REQUIRE(tracer.radiance(ray, 100) == through);
    }
  }
}

TEST_CASE("intersect: a ray through a mesh's silhouette edge enters and leaves once", "[intersect]") {
  Scene s;
  s.settings.background = grey(1);
  s.settings.depth = 50;
  add_mesh(s, cube_mesh(true), clear(0.5, 1));
  // Past the edge x = 1, z = 1, which it touches.
  const Color touched = seen(s, {2, 0.3, 0}, {-1, 0, 1});
  CHECK((touched == grey(0.25) || touched == grey(1)));
}

TEST_CASE("intersect: the distance of every hit is within its bound of the truth", "[intersect]") {
  // The truth for axis-parallel rays onto spheres and boxes, placed with exact numbers.
  Scene s;
  add_sphere(s, {0, 0, 0}, 5);
  const World world = prepare(s);
  Stats stats;
  Hit hit;
  REQUIRE(closest(world, Ray{{3, 0, 100}, {0, 0, -1}, 0, {}, {}}, stats, hit));
  CHECK(std::fabs(hit.root.t - 96) <= hit.root.error);
  CHECK(hit.root.error < 1e-12);
  CHECK(hit.point.z == Approx(4).epsilon(1e-15));
}

TEST_CASE("intersect: a ray from a surface does not meet it again where it starts", "[intersect]") {
  Scene s;
  add_sphere(s, {0, 0, 0}, 1);
  const World world = prepare(s);
  Stats stats;
  Hit hit;
  REQUIRE(closest(world, Ray{{0.3, 0.4, 9}, {0, 0, -1}, 0, {}, {}}, stats, hit));
  Hit next;
  CHECK_FALSE(closest(world, ray_from(world, hit, {0, 0, 1}), stats, next));
  CHECK_FALSE(closest(world, ray_from(world, hit, hit.normal), stats, next));
  REQUIRE(closest(world, ray_from(world, hit, {0, 0, -1}), stats, next));
  CHECK(next.root.t == Approx(2 * std::sqrt(0.75)));
  CHECK_FALSE(next.root.entering);
  CHECK_FALSE(closest(world, ray_from(world, next, {0, 0, -1}), stats, hit));
}

TEST_CASE("intersect: what lies behind the start is not seen", "[intersect]") {
  Scene s;
  add_sphere(s, {0, 0, 5}, 1);
  add_plane(s, {0, 0, 3}, {0, 0, -1});
  add_box(s, {-1, -1, 2}, {1, 1, 3});
  add_facet(s, {-1, -1, 1}, {1, -1, 1}, {0, 1, 1});
  const World world = prepare(s);
  Stats stats;
  Hit hit;
  CHECK_FALSE(closest(world, Ray{{0, 0, 0}, {0, 0, -1}, 0, {}, {}}, stats, hit));
}
