#include "base/math.hpp"
#include "build.hpp"
#include "catch.hpp"
#include "tracer/shapes/solid_angle.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

World world_of(const Scene& s) { return prepare(s); }

Roots hit(const World& world, Vec3 o, Vec3 d, std::uint32_t primitive = 0) {
  return roots(world, primitive, Probe(o, normalize(d)));
}

}  // namespace

TEST_CASE("sphere: a ray through the centre crosses both sides", "[shapes]") {
  Scene s;
  add_sphere(s, {1, 2, -5}, 2);
  const World world = world_of(s);
  const Roots r = hit(world, {1, 2, 3}, {0, 0, -1});
  REQUIRE(r.count == 2);
  CHECK(r.root[0].t == 6);  // 3 - (-5 + 2)
  CHECK(r.root[1].t == 10);
  CHECK(r.root[0].entering);
  CHECK_FALSE(r.root[1].entering);
  CHECK(normal(world, 0, {1, 2, -3}, 0) == Vec3{0, 0, 1});
}

TEST_CASE("sphere: a ray from inside has its start between the crossings", "[shapes]") {
  Scene s;
  add_sphere(s, {0, 0, 0}, 1);
  const Roots r = hit(world_of(s), {0.5, 0, 0}, {1, 0, 0});
  REQUIRE(r.count == 2);
  CHECK(r.root[0].t == -1.5);
  CHECK(r.root[1].t == 0.5);
}

TEST_CASE("sphere: near the silhouette hit and miss are told apart from a hundred million radii",
          "[shapes]") {
  Scene s;
  add_sphere(s, {0, 0, -1e8}, 1);
  const World world = world_of(s);
  CHECK(hit(world, {1 - 1e-7, 0, 0}, {0, 0, -1}).count == 2);
  CHECK(hit(world, {1 + 1e-7, 0, 0}, {0, 0, -1}).count == 0);
}

TEST_CASE("sphere: just above the surface the near root keeps its digits", "[shapes]") {
  // From 2^-40 above the pole straight down: t is that height, which f.f - r^2 in plain doubles would lose
  // half of.
  Scene s;
  add_sphere(s, {0, 0, 0}, 1);
  const Roots r = hit(world_of(s), {0, 1 + 0x1p-40, 0}, {0, -1, 0});
  REQUIRE(r.count == 2);
  CHECK(r.root[0].t == 0x1p-40);
}

TEST_CASE("sphere: a start on the surface going in leaves through the far side", "[shapes]") {
  Scene s;
  add_sphere(s, {0, 0, 0}, 1);
  const Root out = exit(world_of(s), 0, {0, 0, 1}, normalize({0.6, 0, -0.8}));
  CHECK(out.t == Approx(1.6).epsilon(1e-15));  // chord 2 cos
  CHECK_FALSE(out.entering);
}

TEST_CASE("sphere: similarities keep it a sphere, mirroring ones too", "[shapes]") {
  Scene s;
  add_sphere(s, {1, 0, 0}, 1, {},
             then(scaling({2, -2, 2}), then(rotation({10, 20, 30}), translation({5, 6, 7}))));
  const World world = world_of(s);
  REQUIRE(world.spheres.size() == 1);
  CHECK(world.spheres[0].radius == Approx(2));
}

TEST_CASE("ellipsoid: half axes are met where they end, with normals along them", "[shapes]") {
  Scene s;
  add_sphere(s, {0, 0, 0}, 1, {}, then(scaling({1, 2, 4}), translation({10, 0, 0})));
  const World world = world_of(s);
  REQUIRE(world.ellipsoids.size() == 1);
  CHECK(hit(world, {0, 0, 0}, {1, 0, 0}).root[0].t == Approx(9));
  CHECK(hit(world, {10, 10, 0}, {0, -1, 0}).root[0].t == Approx(8));
  CHECK(hit(world, {10, 0, 10}, {0, 0, -1}).root[0].t == Approx(6));
  CHECK(hit(world, {10, 0, 10}, {0, 0, -1}).root[1].t == Approx(14));
  const Vec3 n = normal(world, 0, {10, 2, 0}, 0);
  CHECK(n.y == Approx(1));
  // At (x, y) of x^2 + y^2/4 = 1 the normal goes as (x, y/4): here (0.6, 1.6/4) of (0.6, 1.6).
  const Vec3 slanted = normal(world, 0, {10.6, 1.6, 0}, 0);
  CHECK(slanted.y / slanted.x == Approx(0.4 / 0.6));
}

TEST_CASE("ellipsoid: a start on the surface going in leaves through the far side", "[shapes]") {
  Scene s;
  add_sphere(s, {0, 0, 0}, 1, {}, scaling({1, 2, 4}));
  CHECK(exit(world_of(s), 0, {0, 2, 0}, {0, -1, 0}).t == Approx(4));
}

TEST_CASE("plane: the inside is where the normal points away from", "[shapes]") {
  Scene s;
  add_plane(s, {0, 1, 0}, {0, 3, 0});
  const World world = world_of(s);
  const Roots down = hit(world, {7, 3, 7}, {0, -1, 0});
  REQUIRE(down.count == 1);
  CHECK(down.root[0].t == 2);
  CHECK(down.root[0].entering);
  const Roots up = hit(world, {7, -3, 7}, {0, 1, 0});
  CHECK(up.root[0].t == 4);
  CHECK_FALSE(up.root[0].entering);
  CHECK(side(world, 0, {0, 0, 0}) < 0);
  CHECK(side(world, 0, {0, 2, 0}) > 0);
  CHECK(hit(world, {0, 3, 0}, {1, 0, 0}).count == 0);
}

TEST_CASE("plane: the offset is a distance, whatever the normal's length", "[shapes]") {
  Scene s;
  s.planes.push_back({{0, 0, 0}, {0, 0, 5}, -2});
  s.materials.emplace_back();
  scene::Shape shape;
  shape.kind = ShapeKind::plane;
  s.shapes.push_back(shape);
  const World world = world_of(s);
  CHECK(hit(world, {0, 0, 0}, {0, 0, -1}).root[0].t == 2);
  s.shapes[0].transform = add_transform(s, scaling({3, 3, 3}));
  CHECK(hit(world_of(s), {0, 0, 0}, {0, 0, -1}).root[0].t == Approx(6));
}

TEST_CASE("plane: a start close to it far from its point keeps its digits", "[shapes]") {
  // n.(o - p) is (1, 1, 0).(1e9 + 2^-20, -1e9): 2^-20 is what is left, and t = 2^-20 / 1 along -x.
  Scene s;
  add_plane(s, {0, 0, 0}, {1, 1, 0});
  const Roots r = hit(world_of(s), {1e9 + 0x1p-20, -1e9, 0}, {-1, 0, 0});
  REQUIRE(r.count == 1);
  CHECK(r.root[0].t == 0x1p-20);
}

TEST_CASE("box: rays through edges, corners and along sides hit", "[shapes]") {
  Scene s;
  add_box(s, {-1, -1, -1}, {1, 1, 1});
  const World world = world_of(s);
  CHECK(hit(world, {1, 0, 5}, {0, 0, -1}).count == 2);  // in the plane of a side
  CHECK(hit(world, {1, 1, 5}, {0, 0, -1}).count == 2);  // along an edge
  CHECK(hit(world, {-1, 1, 5}, {0, 0, -1}).count == 2);
  CHECK(hit(world, {-1, -1, 5}, {-0.0, -0.0, -1}).count == 2);
  CHECK(hit(world, {2, 2, 2}, {-1, -1, -1}).count == 2);  // into a corner
  CHECK(hit(world, {2, 0, 0}, {-1, 1, 0}).count == 2);    // past an edge, touching it
  CHECK(hit(world, {1 + 1e-15, 0, 5}, {0, 0, -1}).count == 0);
  const Roots r = hit(world, {1, 0, 5}, {0, 0, -1});
  CHECK(r.root[0].t == 4);
  CHECK(r.root[1].t == 6);
  CHECK(normal(world, 0, {}, r.root[0].face) == Vec3{0, 0, 1});
  CHECK(normal(world, 0, {}, r.root[1].face) == Vec3{0, 0, -1});
}

TEST_CASE("box: one with a frame of its own is tested in it", "[shapes]") {
  // A unit cube turned by 45 degrees about y, its centre at x = 10: the nearest edge is at 10 - sqrt(1/2).
  Scene s;
  add_box(s, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, {}, then(rotation({0, 45, 0}), translation({10, 0, 0})));
  const World world = world_of(s);
  REQUIRE(world.boxes.size() == 1);
  const Roots r = hit(world, {0, 0.1, 1e-3}, {1, 0, 0});
  REQUIRE(r.count == 2);
  CHECK(r.root[0].t == Approx(10 - std::sqrt(0.5) + 1e-3).epsilon(1e-14));
  const Vec3 n = normal(world, 0, {}, r.root[0].face);
  CHECK(n.x == Approx(-std::sqrt(0.5)));
  CHECK(n.z == Approx(std::sqrt(0.5)));
  CHECK(hit(world, {0, 0.51, 0}, {1, 0, 0}).count == 0);
}

TEST_CASE("box: the frame of a three-point cube comes before the shape's transform", "[shapes]") {
  Scene s;
  add_box(s, {0, 0, 0}, {1, 1, 1}, {}, translation({0, 0, 5}));
  s.boxes[0].frame = add_transform(s, rotation({0, 90, 0}));  // x to -z, z to x
  const World world = world_of(s);
  const Roots r = hit(world, {0.5, 0.5, 10}, {0, 0, -1});  // the box is [0,1] x [0,1] x [4,5]
  REQUIRE(r.count == 2);
  CHECK(r.root[0].t == 5);
  CHECK(r.root[1].t == 6);
}

TEST_CASE("box: a start on a face going in leaves through the first side on its way", "[shapes]") {
  Scene s;
  add_box(s, {-1, -1, -1}, {1, 1, 1});
  const World world = world_of(s);
  const Root out = exit(world, 0, {1, 0.5, 0}, normalize({-1, 1, 0}));
  CHECK(out.t == Approx(std::sqrt(0.5)));  // 0.5 up, 0.5 to the left
  CHECK(normal(world, 0, {}, out.face) == Vec3{0, 1, 0});
  CHECK(exit(world, 0, {1, 0, 0}, {-1, 0, 0}).t == 2);
}

TEST_CASE("facet: its front is where the corners run counter-clockwise", "[shapes]") {
  Scene s;
  add_facet(s, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const World world = world_of(s);
  for (const Vec3 axis : {Vec3{0.1, 0.1, 1}, Vec3{-0.1, 0.2, 1}}) {
    const Roots front = hit(world, Vec3{0.25, 0.25, 0} + axis, -axis);
    REQUIRE(front.count == 1);
    CHECK(front.root[0].entering);
    const Roots back = hit(world, Vec3{0.25, 0.25, 0} - axis, axis);
    REQUIRE(back.count == 1);
    CHECK_FALSE(back.root[0].entering);
  }
  CHECK(normal(world, 0, {}, 0) == Vec3{0, 0, 1});
  CHECK(hit(world, {0.6, 0.6, 1}, {0, 0, -1}).count == 0);
}

TEST_CASE("facet: facing is told alike for every direction of the ray", "[shapes]") {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    Scene s;
    const Vec3 a = random.in_cube(1), b = random.in_cube(1), c = random.in_cube(1);
    add_facet(s, a, b, c);
    const World world = world_of(s);
    const Vec3 n = normal(world, 0, {}, 0), d = random.direction();
    const Roots r = hit(world, (a + b + c) / 3 - d * 2, d);
    REQUIRE(r.count == 1);
    CHECK(r.root[0].entering == (dot(n, d) < 0));
    CHECK(std::fabs(r.root[0].t - 2) <= r.root[0].error + 1e-15);
  }
}

TEST_CASE("facet: a mirroring transform carries its front along", "[shapes]") {
  Scene s;
  add_facet(s, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {}, scaling({-1, 1, 1}));  // front still towards +z
  const World world = world_of(s);
  CHECK(normal(world, 0, {}, 0) == Vec3{0, 0, 1});
  const Roots r = hit(world, {-0.25, 0.25, 1}, {0, 0, -1});
  REQUIRE(r.count == 1);
  CHECK(r.root[0].entering);
}

TEST_CASE("facet: edges and corners belong to it, and no ray slips between neighbours", "[shapes]") {
  Scene s;
  add_mesh(s, cube_mesh(true), {}, then(rotation({20, 30, 40}), scaling({1, 1e-3, 7})));
  const World world = world_of(s);
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const FacetPrimitive& f = world.facets[static_cast<std::size_t>(random() * 12)];
    const double w = i % 3 == 0 ? 0 : random();  // a corner, or along an edge
    const Vec3 target = f.a * (1 - w) + f.b * w;
    const Vec3 inside = world.scene->transforms[1].to_world.point(random.in_cube(0.9));
    bool met = false;
    for (std::uint32_t p = 0; p < 12; ++p) {
      const Roots r = hit(world, inside, target - inside, p);
      met = met || (r.count == 1 && r.root[0].t > 0);
    }
    REQUIRE(met);
  }
}

TEST_CASE("facet: barycentric weights of corners and the middle", "[shapes]") {
  const FacetPrimitive f{{1, 2, 3}, {4, 2, 5}, {0, 7, 1}, {}, false, 0, 0};
  CHECK(barycentric(f, f.a).a == 1);
  CHECK(barycentric(f, f.b).b == 1);
  CHECK(barycentric(f, f.c).c == 1);
  const Barycentric m = barycentric(f, f.a * 0.5 + f.b * 0.3 + f.c * 0.2);
  CHECK(m.a == Approx(0.5));
  CHECK(m.b == Approx(0.3));
  CHECK(m.c == Approx(0.2));
}

TEST_CASE("mesh: the winding number tells inside from outside, mirrored too", "[shapes]") {
  for (const double x : {1.0, -1.0}) {
    Scene s;
    add_mesh(s, cube_mesh(true), {}, scaling({x, 2, 1}));
    const World world = world_of(s);
    CHECK(side(world, 0, {0.3, 1.9, -0.8}) < 0);
    CHECK(side(world, 0, {0.3, 2.1, -0.8}) > 0);
    CHECK(side(world, 0, {30, 0, 0}) > 0);
  }
  // The facet that spans the ends of the unit axes fills an eighth of what the origin sees.
  CHECK(seen_from({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}, false, 0, 0}, {0, 0, 0}).turns == Approx(1.0 / 8));
}

TEST_CASE("shapes: bounds hold every point of the surface", "[shapes]") {
  Scene s;
  const Affine map = then(rotation({10, 50, 80}), then(scaling({1, 3, 0.2}), translation({100, 5, -3})));
  add_sphere(s, {1, 2, 3}, 2);
  add_sphere(s, {1, 2, 3}, 2, {}, map);
  add_box(s, {-1, -2, -3}, {1, 2, 5}, {}, map);
  add_facet(s, {0, 0, 0}, {1, 5, 0}, {0, 1, 3}, {}, map);
  const World world = world_of(s);
  Random random(9);
  for (std::uint32_t p = 0; p < world.primitives.size(); ++p) {
    const Aabb box = bounds(world, p);
    for (int i = 0; i < 500; ++i) {
      const Vec3 target = box.lo + Vec3{random() * (box.hi - box.lo).x, random() * (box.hi - box.lo).y,
                                        random() * (box.hi - box.lo).z};
      const Vec3 d = random.direction();
      const Roots r = roots(world, p, Probe(target - d * 50, d));
      for (int k = 0; k < r.count; ++k) {
        const Vec3 at = project(world, p, target + d * (r.root[k].t - 50), r.root[k].face);
        REQUIRE(box.contains(at));
      }
    }
  }
}

TEST_CASE("shapes: a facet without an area is left out", "[shapes]") {
  Scene s;
  scene::Mesh mesh = cube_mesh(false);
  mesh.faces.push_back({0, 0, 1});
  add_mesh(s, mesh);
  CHECK(world_of(s).primitives.size() == 12);
}
