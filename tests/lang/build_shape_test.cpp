#include "catch.hpp"
#include "lang/build.hpp"

using namespace lancer;
using namespace lancer::lang;

TEST_CASE("build: a sphere in both its forms", "[build]") {
  for (const char* text : {"sphere { center <1, 2, 3> radius 0.5 }", "sphere { <1, 2, 3>, 0.5 }"}) {
    const scene::Scene s = scene_of(text);
    REQUIRE(s.shapes.size() == 1);
    CHECK(s.shapes[0].kind == scene::ShapeKind::sphere);
    CHECK(s.spheres[0].center == Vec3{1, 2, 3});
    CHECK(s.spheres[0].radius == 0.5);
    CHECK(s.shapes[0].transform == 0);
    CHECK(s.shapes[0].shadow);
  }
}

TEST_CASE("build: a plane by point and normal keeps both as written", "[build]") {
  const scene::Scene s = scene_of("plane { point <0, 1, 0> normal <0, 3, 0> }");
  CHECK(s.planes[0].point == Vec3{0, 1, 0});
  CHECK(s.planes[0].normal == Vec3{0, 3, 0});
  CHECK(s.planes[0].offset == 0);
}

TEST_CASE("build: a plane by normal and distance has the distance as its offset", "[build]") {
  const scene::Scene s = scene_of("plane { <0, 3, 4>, -2 }");
  CHECK(s.planes[0].point == Vec3{0, 0, 0});
  CHECK(s.planes[0].normal == Vec3{0, 3, 4});
  CHECK(s.planes[0].offset == -2);
}

TEST_CASE("build: a plane by three points has the normal (b-a) x (c-a)", "[build]") {
  // (b-a) = (2, 0, 0), (c-a) = (0, 0, -2): the cross product is (0*-2 - 0*0, 0*0 - 2*-2, 0) = (0, 4, 0).
  for (const char* text :
       {"plane { <1, 5, 1>, <3, 5, 1>, <1, 5, -1> }", "plane { points <1, 5, 1>, <3, 5, 1>, <1, 5, -1> }"}) {
    const scene::Plane p = scene_of(text).planes[0];
    CHECK(p.point == Vec3{1, 5, 1});
    CHECK(p.normal.x == 0);
    CHECK(p.normal.y > 0);
    CHECK(p.normal.z == 0);
  }
}

TEST_CASE("build: the normal of a plane by points survives very small and very large ones", "[build]") {
  CHECK(normalize(scene_of("plane { <0, 0, 0>, <1e-200, 0, 0>, <0, 0, -1e-200> }").planes[0].normal) ==
        Vec3{0, 1, 0});
  CHECK(normalize(scene_of("plane { <0, 0, 0>, <1e200, 0, 0>, <0, 0, -1e200> }").planes[0].normal) ==
        Vec3{0, 1, 0});
}

TEST_CASE("build: a cube around its center and a box of corners in any order", "[build]") {
  const scene::Scene cube = scene_of("cube { center <1, 2, 3> side 2 }");
  CHECK(cube.boxes[0].lo == Vec3{0, 1, 2});
  CHECK(cube.boxes[0].hi == Vec3{2, 3, 4});
  CHECK(cube.boxes[0].frame == 0);
  for (const char* text : {"box { <3, 0, 5>, <1, 2, -1> }", "box { corners <1, 2, -1>, <3, 0, 5> }"}) {
    const scene::Scene box = scene_of(text);
    CHECK(box.shapes[0].kind == scene::ShapeKind::box);
    CHECK(box.boxes[0].lo == Vec3{1, 0, -1});
    CHECK(box.boxes[0].hi == Vec3{3, 2, 5});
  }
}

TEST_CASE("build: a cube on three points is the unit cube in their frame", "[build]") {
  // e1 = (2, 0, 0), e2 = (0, 0, 2): e1 x e2 = (0, -4, 0), so the face is extruded by |e1| = 2 along -y.
  const scene::Scene s = scene_of("cube { <1, 1, 1>, <3, 1, 1>, <1, 1, 3> }");
  CHECK(s.boxes[0].lo == Vec3{0, 0, 0});
  CHECK(s.boxes[0].hi == Vec3{1, 1, 1});
  REQUIRE(s.boxes[0].frame != 0);
  const Affine& frame = s.transforms[s.boxes[0].frame].to_world;
  CHECK(frame.point({0, 0, 0}) == Vec3{1, 1, 1});
  CHECK(frame.point({1, 0, 0}) == Vec3{3, 1, 1});
  CHECK(frame.point({0, 1, 0}) == Vec3{1, 1, 3});
  CHECK(frame.point({0, 0, 1}) == Vec3{1, -1, 1});
  const Affine& back = s.transforms[s.boxes[0].frame].to_object;
  CHECK(is_near(back.point({3, -1, 3}), {1, 1, 1}));
}

TEST_CASE("build: a cube whose face is no square is built with a warning", "[build]") {
  const Built oblong = build("cube { <0, 0, 0>, <1, 0, 0>, <0, 2, 0> }");
  CHECK(oblong.messages == std::vector<std::string>{
                               "W104 [<0, 0, 0>, <1, 0, 0>, <0, 2, 0>] the face of this cube is no square"});
  REQUIRE(oblong.scene.boxes.size() == 1);
  // The extrusion is as long as p1 - p0, whatever p2 - p0 is.
  const Affine& frame = oblong.scene.transforms[oblong.scene.boxes[0].frame].to_world;
  CHECK(frame.point({1, 1, 1}) == Vec3{1, 2, 1});
  CHECK(build("cube { points <0, 0, 0>, <1, 0, 0>, <0.6, 0.8, 0> }").messages.size() == 1);
}

TEST_CASE("build: rounding makes no face crooked", "[build]") {
  CHECK(build("cube { <0.1, 0.2, 0.3>, <0.1 + cos(33), 0.2 + sin(33), 0.3>, <0.1 - sin(33), 0.2 + cos(33), "
              "0.3> }")
            .messages.empty());
}

TEST_CASE("build: the normals of a facet get unit length", "[build]") {
  const scene::Scene s =
      scene_of("facet { <0, 0, 0>, <1, 0, 0>, <0, 1, 0>  normals <0, 0, 2>, <0, 3, 4>, <1e-300, 0, 0> }");
  REQUIRE(s.facets[0].normals == 0);
  CHECK(s.facet_normals[0][0] == Vec3{0, 0, 1});
  CHECK(is_near(s.facet_normals[0][1], {0, 0.6, 0.8}));
  CHECK(s.facet_normals[0][2] == Vec3{1, 0, 0});
  CHECK(scene_of("facet { points <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }").facets[0].normals == scene::k_none);
}

TEST_CASE("build: sizes that are not positive are refused at the size", "[build][refusals]") {
  CHECK(refusal("sphere { center <0,1,0> radius -1 }") ==
        "E013 [-1] a sphere's radius is positive; this one is -1");
  CHECK(refusal("sphere { <0,1,0>, 0 }") == "E013 [0] a sphere's radius is positive; this one is 0");
  CHECK(refusal("cube { center <0,1,0> side -0.5 }") ==
        "E013 [-0.5] a cube's side is positive; this one is -0.5");
}

TEST_CASE("build: wrong types are refused with what was found", "[build][refusals]") {
  CHECK(refusal("sphere { 1, 1 }") == "E030 [1] a sphere's center is a point <x, y, z>; this is a number");
  CHECK(refusal("sphere { <1, 2>, 1 }") ==
        "E030 [<1, 2>] a sphere's center is a point <x, y, z>; this is a vector of 2");
  CHECK(refusal("sphere { x, \"big\" }") == "E030 [\"big\"] a sphere's radius is a number; this is a string");
  CHECK(refusal("box { x, true }") ==
        "E030 [true] each of a box's corners is a point <x, y, z>; this is a boolean");
  CHECK(refusal("sphere { x, 1 shadow 0 }") == "E030 [0] `shadow` is a boolean; this is a number");
  CHECK(refusal("sphere { x, 1 material red }") ==
        "E030 [red] `material` takes a material; this is a vector");
}

TEST_CASE("build: flat shapes are refused", "[build][refusals]") {
  CHECK(refusal("box { <0, 0, 0>, <1, 0, 1> }") ==
        "E016 [<1, 0, 1>] a box is not flat; its corners have the same y, 0");
  CHECK(refusal("plane { point x normal <0, 0, 0> }") == "E016 [<0, 0, 0>] a plane's normal is not zero");
  CHECK(refusal("plane { <0, 0, 0>, 1 }") == "E016 [<0, 0, 0>] a plane's normal is not zero");
  CHECK(refusal("facet { x, y, z normals x, <0, 0, 0>, z }") == "E016 [<0, 0, 0>] a normal is not zero");
  CHECK(refusal("cube { center <1e20, 0, 0> side 1 }") ==
        "E016 [1] a cube's side of 1 is lost beside its center <100000000000000000000, 0, 0>");
}

TEST_CASE("build: points on a line are refused at any size and place", "[build][refusals]") {
  CHECK(refusal("plane { <0, 0, 0>, <1, 1, 1>, <2, 2, 2> }") ==
        "E016 [<0, 0, 0>, <1, 1, 1>, <2, 2, 2>] the points of a plane lie on a line");
  CHECK(refusal("cube { points x, x, y }") == "E016 [x, x, y] the points of a cube lie on a line");
  // On a line but for the rounding of decimal fractions.
  CHECK(refusal("facet { <0.1, 0.2, 0.3>, <0.2, 0.4, 0.6>, <0.3, 0.6, 0.9> }").find("E016") == 0);
  CHECK(refusal("facet { <1e-200, 0, 0>, <2e-200, 1e-200, 0>, <3e-200, 2e-200, 0> }").find("E016") == 0);
  CHECK(refusal("facet { <1e200, 0, 0>, <2e200, 1e200, 0>, <3e200, 2e200, 0> }").find("E016") == 0);
}

TEST_CASE("build: thin facets are facets", "[build]") {
  CHECK(scene_of("facet { <0, 0, 0>, <1e9, 0, 0>, <2e9, 1e-9, 0> }").facets.size() == 1);
  CHECK(scene_of("facet { <0, 0, 0>, <1, 0, 0>, <1, 1e-200, 0> }").facets.size() == 1);
  CHECK(scene_of("facet { <1e-300, 0, 0>, <0, 1e-300, 0>, <0, 0, 1e-300> }").facets.size() == 1);
  CHECK(scene_of("facet { <1e9, 1e9, 0>, <1e9 + 1e-3, 1e9, 0>, <1e9, 1e9 + 1e-3, 0> }").facets.size() == 1);
}

TEST_CASE("build: shapes that reach beyond all numbers are refused", "[build][refusals]") {
  CHECK(refusal("sphere { <1.5e308, 0, 0>, 1e308 }") ==
        "E031 [sphere] this sphere reaches beyond the range of numbers");
  CHECK(refusal("box { <-1.5e308, 0, 0>, <1.5e308, 1, 1> }") ==
        "E031 [box] this box reaches beyond the range of numbers");
}
