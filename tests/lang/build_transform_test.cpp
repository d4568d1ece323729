#include "catch.hpp"
#include "lang/build.hpp"
#include "lang/geometry_checks.hpp"
#include "lang/run_script.hpp"

using namespace lancer;
using namespace lancer::lang;

namespace {

/// Where the transforms of a sphere take a point.
Vec3 moved(const std::string& transforms, Vec3 p) {
  const scene::Scene s = scene_of("sphere { <0, 0, 0>, 1 " + transforms + " }");
  return s.transforms[s.shapes[0].transform].to_world.point(p);
}

}  // namespace

TEST_CASE("transform: applied in the order written", "[build][transform]") {
  CHECK(moved("translate x scale 2", {0, 0, 0}) == Vec3{2, 0, 0});
  CHECK(moved("scale 2 translate x", {0, 0, 0}) == Vec3{1, 0, 0});
  CHECK(moved("scale <1, 2, 3>", {1, 1, 1}) == Vec3{1, 2, 3});
}

TEST_CASE("transform: rotation is about x, then y, then z, right-handed", "[build][transform]") {
  CHECK(moved("rotate <0, 0, 90>", {1, 0, 0}) == Vec3{0, 1, 0});
  CHECK(moved("rotate <0, 90, 0>", {1, 0, 0}) == Vec3{0, 0, -1});
  // z goes to -y (about x), stays (about y), goes to x (about z).
  CHECK(moved("rotate <90, 90, 90>", {0, 0, 1}) == Vec3{1, 0, 0});
  CHECK(is_near(moved("rotate <1, 1, 1>, 120", {1, 0, 0}), {0, 1, 0}));
}

TEST_CASE("transform: four quarter turns leave every bit as it was", "[build][transform]") {
  const scene::Scene s =
      scene_of("sphere { x, 1 rotate <0, 90, 0> rotate <0, 90, 0> rotate <0, 90, 0> rotate <0, 90, 0> }");
  CHECK(s.shapes[0].transform == 0);
}

TEST_CASE("transform: those of groups come last, the outermost at the end", "[build][transform]") {
  const scene::Scene s = scene_of(
      "group { translate y  group { rotate <0, 0, 90>  sphere { <0, 0, 0>, 1 translate x } } scale 3 }");
  // x, turned to y, plus y makes 2 y, times 3.
  CHECK(s.transforms[s.shapes[0].transform].to_world.point({0, 0, 0}) == Vec3{0, 6, 0});
  CHECK(is_near(s.transforms[s.shapes[0].transform].to_object.point({0, 6, 0}), {0, 0, 0}));
}

TEST_CASE("transform: the same one is stored once", "[build][transform]") {
  const scene::Scene s = scene_of("for i in 0..5 { sphere { <0, 0, 0>, 1 translate x } }\nsphere { x, 1 }");
  CHECK(s.transforms.size() == 2);
  CHECK(s.shapes[4].transform == 1);
  CHECK(s.shapes[5].transform == 0);
}

TEST_CASE("transform: what is refused", "[build][transform][refusals]") {
  CHECK(refusal("sphere { x, 1 scale 0 }") == "E017 [0] a scale by 0 cannot be undone");
  CHECK(refusal("sphere { x, 1 scale <1, 0, 1> }") == "E017 [<1, 0, 1>] a scale by 0 cannot be undone");
  CHECK(refusal("sphere { x, 1 scale 1e-200 scale 1e-199 }") ==
        "E017 [1e-199] these transforms cannot be undone");
  CHECK(refusal("sphere { x, 1 scale 1e200 scale 1e199 }") ==
        "E031 [1e199] with this `scale` the transforms leave the range of numbers");
  CHECK(refusal("sphere { x, 1 translate 2 }") ==
        "E030 [2] `translate` takes a vector <x, y, z>; this is a number");
  CHECK(refusal("sphere { x, 1 translate <1, 2> }") ==
        "E030 [<1, 2>] `translate` takes a vector <x, y, z>; this is a vector of 2");
  CHECK(refusal("sphere { x, 1 scale \"2\" }") ==
        "E030 [\"2\"] `scale` takes a number or a vector <x, y, z>; this is a string");
  CHECK(refusal("sphere { x, 1 rotate 90 }") ==
        "E030 [90] `rotate` takes angles <x, y, z>, or an axis and an angle; this is a number");
  CHECK(refusal("sphere { x, 1 rotate <0, 0, 0>, 30 }") == "E016 [<0, 0, 0>] an axis is not zero");
  CHECK(refusal("sphere { x, 1 rotate y, z }") ==
        "E030 [z] `rotate` takes an axis <x, y, z> and an angle; this is a vector");
}

TEST_CASE("transform: groups that together leave the range of numbers are refused at the object",
          "[build][transform][refusals]") {
  CHECK(refusal("group { sphere { x, 1 scale 1e-200 } scale 1e-200 }") ==
        "E017 [sphere { x, 1 scale 1e-200 }] this sphere's transforms, with those of its groups, have no "
        "inverse: nothing is left to see");
  CHECK(refusal("group { sphere { x, 1 scale 1e200 } scale 1e200 }") ==
        "E031 [sphere { x, 1 scale 1e200 }] this sphere's transforms, with those of its groups, leave the "
        "range of numbers");
}

TEST_CASE("scene: objects stand in the order added, groups dissolved", "[build][scene]") {
  const scene::Scene s = scene_of(
      "sphere { x, 1 }\ngroup { sphere { x, 2 } group { } sphere { x, 3 } }\nfn two() { sphere { x, 4 } "
      "sphere { x, 5 } }\ntwo()");
  REQUIRE(s.shapes.size() == 5);
  for (std::size_t i = 0; i < 5; ++i)
    CHECK(s.spheres[s.shapes[i].record].radius == static_cast<double>(i + 1));
}

TEST_CASE("scene: material and shadow of a group serve members that set none, the nearest wins",
          "[build][scene]") {
  const scene::Scene s = scene_of(
      "group { sphere { x, 1 } sphere { x, 2 material { diffuse 0.5 } shadow true }\n"
      "  group { sphere { x, 3 } material { diffuse 0.25 } } shadow false material { diffuse 0.125 } "
      "}\nsphere { x, 4 }");
  const auto diffuse = [&](std::size_t i) { return s.materials[s.shapes[i].material].diffuse.color.r; };
  CHECK(diffuse(0) == 0.125);
  CHECK(diffuse(1) == 0.5);
  CHECK(diffuse(2) == 0.25);
  CHECK(diffuse(3) == 0.8);
  CHECK_FALSE(s.shapes[0].shadow);
  CHECK(s.shapes[1].shadow);
  CHECK_FALSE(s.shapes[2].shadow);
  CHECK(s.shapes[3].shadow);
}

TEST_CASE("scene: equal materials are one, and names are kept once", "[build][scene]") {
  const scene::Scene s = scene_of(
      "for i in 0..3 { sphere \"bead\" { x, 1 material { diffuse red } } }\nsphere \"bead {1 + 1}\" { x, 1 "
      "material { diffuse blue } }");
  CHECK(s.materials.size() == 2);
  CHECK(s.names == std::vector<std::string>{"", "bead", "bead 2"});
  CHECK(s.shapes[2].name == 1);
  CHECK(s.shapes[3].name == 2);
}

TEST_CASE("scene: groups nest as deep as calls do", "[build][scene]") {
  const scene::Scene s =
      scene_of("fn nest(n) { if n == 0 { sphere { x, 1 } } else { nest(n - 1) } }\nnest(9000)");
  CHECK(s.shapes.size() == 1);
}

TEST_CASE("member: as written, by default, and before transforms", "[build][member]") {
  CHECK(
      printed(
          "let s = sphere \"ball\" { <1, 2, 3>, 4 scale 2 }\nprint(s.center, s.radius, s.name, s.shadow)") ==
      "<1, 2, 3> 4 ball true\n");
  CHECK(printed("let b = box { <0, 0, 0>, <1, 2, 3> }\nprint(b.corners)") == "[<0, 0, 0>, <1, 2, 3>]\n");
  CHECK(printed("let p = plane { y, 2 }\nprint(p.normal)") == "<0, 1, 0>\n");
  CHECK(printed("let v = view { eye z look -z }\nprint(v.fov, v.up, v.size, v.eye)") ==
        "50 <0, 1, 0> [640, 480] <0, 0, 1>\n");
  CHECK(printed("let l = spot { at y look_at x }\nprint(l.color, l.angle, l.softness, l.look_at)") ==
        "1 30 0.1 <1, 0, 0>\n");
  CHECK(
      printed("let m = material { diffuse 0.5 }\nprint(m.ambient, m.color, m.specular, m.ior, m.fresnel)") ==
      "0.5 0.5 0 1 false\n");
  CHECK(
      printed("let g = group \"g\" { sphere { x, 1 } shadow false }\nprint(g.name, g.shadow, g[0].shadow)") ==
      "g false true\n");
}

TEST_CASE("member: what there is not", "[build][member][refusals]") {
  CHECK(failure("print(sphere { x, 1 }.size)").find("E034 a sphere has no member `size`") !=
        std::string::npos);
  CHECK(failure("print(light { at x }.falloff)")
            .find("E034 this light was given no `falloff`, and there is no default") != std::string::npos);
  CHECK(failure("print(sphere { x, 1 }.scale)").find("E034 a sphere's transforms cannot be read") !=
        std::string::npos);
  CHECK(failure("print(view { eye z look -z width 2 }.fov)").find("E034 this view was given no `fov`") !=
        std::string::npos);
}

TEST_CASE("flatness: does not depend on scale", "[build][geometry]") {
  for (const double u : {1e-300, 1e-150, 1.0, 1e150, 1e300}) {
    CHECK(are_on_a_line({0, 0, 0}, {u, u, u}, {3 * u, 3 * u, 3 * u}));
    CHECK_FALSE(are_on_a_line({0, 0, 0}, {u, 0, 0}, {0, u, 0}));
    CHECK_FALSE(are_on_a_line({0, 0, 0}, {u, 0, 0}, {u, 1e-6 * u, 0}));
  }
  CHECK(are_on_a_line({1, 2, 3}, {1, 2, 3}, {4, 5, 6}));
  CHECK(are_parallel(written_direction({1, 2, 3}), written_direction({-2, -4, -6})));
  CHECK_FALSE(are_parallel(written_direction({0, -1, 0}), written_direction({1e-30, 1, 0})));
}
