#include "catch.hpp"
#include "lang/build.hpp"

using namespace lancer;
using namespace lancer::lang;

TEST_CASE("light: its attributes and defaults", "[build][light]") {
  const scene::Scene s =
      scene_of("light { at <4, 6, 5> }\nlight \"key\" { at y color rgb(1, 0.5, 0) falloff 3 }");
  REQUIRE(s.lights.size() == 2);
  CHECK(s.lights[0].kind == scene::LightKind::point);
  CHECK(s.lights[0].at == Vec3{4, 6, 5});
  CHECK(s.lights[0].color == Color{1, 1, 1});
  CHECK(s.lights[0].falloff == 0);
  CHECK(s.lights[1].color == Color{1, 0.5, 0});
  CHECK(s.lights[1].falloff == 3);
  CHECK(s.names[s.lights[1].name] == "key");
}

TEST_CASE("light: a sun and a spot", "[build][light]") {
  const scene::Scene s =
      scene_of("sun { direction <0, -2, 0> color 0.5 }\nspot { at <0, 5, 0> look_at <1, 0, 0> }");
  CHECK(s.lights[0].kind == scene::LightKind::sun);
  CHECK(s.lights[0].direction == Vec3{0, -2, 0});
  CHECK(s.lights[0].color == Color{0.5, 0.5, 0.5});
  CHECK(s.lights[1].kind == scene::LightKind::spot);
  CHECK(s.lights[1].direction == Vec3{1, -5, 0});
  CHECK(s.lights[1].angle == 30);
  CHECK(s.lights[1].softness == 0.1);
}

TEST_CASE("light: transforms carry places and directions, and falloff by the cube root of the determinant",
          "[build][light]") {
  // det diag(1, 2, 4) = 8, whose cube root is 2.
  const scene::Scene s = scene_of(
      "light { at <1, 1, 1> falloff 3 scale <1, 2, 4> }\n"
      "group { sun { direction <0, 0, -1> } rotate <0, 90, 0> translate <7, 7, 7> }\n"
      "spot { at x look_at <0, 0, 0> falloff 1 scale <-2, -2, -2> translate y }");
  CHECK(s.lights[0].at == Vec3{1, 2, 4});
  CHECK(s.lights[0].falloff == 6);
  CHECK(s.lights[1].direction == Vec3{-1, 0, 0});  // -z turned about y by 90 degrees
  CHECK(s.lights[2].at == Vec3{-2, 1, 0});
  CHECK(normalize(s.lights[2].direction) == Vec3{1, 0, 0});
  CHECK(s.lights[2].falloff == 2);
}

TEST_CASE("light: falloff survives transforms whose determinant is beyond the range of numbers",
          "[build][light]") {
  CHECK(scene_of("light { at x falloff 1 scale 1e-120 }").lights[0].falloff == Approx(1e-120).epsilon(1e-14));
  CHECK(scene_of("light { at x falloff 1 scale 1e120 }").lights[0].falloff == Approx(1e120).epsilon(1e-14));
}

TEST_CASE("light: what is refused", "[build][light][refusals]") {
  CHECK(refusal("light { at y falloff 0 }") == "E013 [0] a light's falloff is positive; this one is 0");
  CHECK(refusal("light { at y color \"red\" }") ==
        "E030 [\"red\"] a light's color is a colour; this is a string");
  CHECK(refusal("light { at y color <1, 2> }") ==
        "E030 [<1, 2>] a light's color is a colour; this is a vector of 2");
  CHECK(refusal("sun { direction <0, 0, 0> }") == "E016 [<0, 0, 0>] a sun's direction is not zero");
  CHECK(refusal("spot { at y look_at <0, 1, 0> }") ==
        "E016 [<0, 1, 0>] a spot does not look at its own place");
  CHECK(refusal("spot { at y look_at x angle 180 }") ==
        "E015 [180] a spot's angle lies between 0 and 180 degrees; this one is 180");
  CHECK(refusal("spot { at y look_at x angle 0 }") ==
        "E015 [0] a spot's angle lies between 0 and 180 degrees; this one is 0");
  CHECK(refusal("spot { at y look_at x softness 1.5 }") ==
        "E015 [1.5] a spot's softness lies from 0 to 1; this one is 1.5");
}

TEST_CASE("view: its forms and defaults", "[build][view]") {
  const scene::Scene s = scene_of(
      "view { eye <0, 3, 7> look_at <0, 1, 0> }\n"
      "view { eye x look <0, 0, -2> up <1, 1, 0> width 4 size 1, 65536 }\n"
      "view { eye <0, 0, 5> corners <-1, 1, 0>, <1, 1, 0>, <-1, -1, 0> size 100, 50 }");
  CHECK(s.views[0].projection == scene::Projection::perspective);
  CHECK(s.views[0].look == Vec3{0, -2, -7});
  CHECK(s.views[0].up == Vec3{0, 1, 0});
  CHECK(s.views[0].fov == 50);
  CHECK(s.views[0].columns == 640);
  CHECK(s.views[0].rows == 480);
  CHECK(s.views[1].projection == scene::Projection::orthographic);
  CHECK(s.views[1].width == 4);
  CHECK(s.views[1].up == Vec3{1, 1, 0});
  CHECK(s.views[1].rows == 65536);
  CHECK(s.views[2].projection == scene::Projection::corners);
  CHECK(s.views[2].corners[2] == Vec3{-1, -1, 0});
}

TEST_CASE("view: up is z where it looks along y", "[build][view]") {
  CHECK(scene_of("view { eye <0, 5, 0> look -y }").views[0].up == Vec3{0, 0, 1});
  CHECK(scene_of("view { eye <0.1, 5, 0.2> look_at <0.1, 0, 0.2> }").views[0].up == Vec3{0, 0, 1});
  // 0.1 + 0.2 is not quite 0.3.
  CHECK(scene_of("view { eye <0.1 + 0.2, 5, 0> look_at <0.3, 0, 0> }").views[0].up == Vec3{0, 0, 1});
  CHECK(scene_of("view { eye <0, 5, 0> look <1e-9, -1, 0> }").views[0].up == Vec3{0, 1, 0});
}

TEST_CASE("view: transforms carry eye, look, up and corners, the default up too", "[build][view]") {
  const scene::Scene s = scene_of(
      "view { eye <1, 0, 0> look x rotate <0, 0, 90> }\n"
      "view { eye z corners <-1, 1, 0>, <1, 1, 0>, <-1, -1, 0> translate x scale 2 }");
  CHECK(s.views[0].eye == Vec3{0, 1, 0});
  CHECK(s.views[0].look == Vec3{0, 1, 0});
  CHECK(s.views[0].up == Vec3{-1, 0, 0});
  CHECK(s.views[0].fov == 50);
  CHECK(s.views[1].eye == Vec3{2, 0, 2});
  CHECK(s.views[1].corners[0] == Vec3{0, 2, 0});
}

TEST_CASE("view: what cannot look is refused", "[build][view][refusals]") {
  CHECK(refusal("view { eye z look <0, 0, 0> }") == "E018 [<0, 0, 0>] a view's look is not zero");
  CHECK(refusal("view { eye z look_at <0, 0, 1> }") ==
        "E018 [<0, 0, 1>] a view does not look at its own eye");
  CHECK(refusal("view { eye y look z up <0, 0, -2> }") ==
        "E018 [<0, 0, -2>] a view does not look along its up");
  CHECK(refusal("view { eye <0.1, 0.2, 0.3> look_at <0.2, 0.4, 0.6> up <1, 2, 3> }") ==
        "E018 [<1, 2, 3>] a view does not look along its up");
  CHECK(refusal("view { eye z look -z up <0, 0, 0> }") == "E016 [<0, 0, 0>] a view's up is not zero");
  CHECK(refusal("view { eye z look -z fov 180 }") ==
        "E015 [180] a fov lies between 0 and 180 degrees; this one is 180");
  CHECK(refusal("view { eye z look -z width 0 }") == "E013 [0] a view's width is positive; this one is 0");
  CHECK(refusal("view { eye z look -z size 0, 5 }") ==
        "E015 [0] a size is whole and from 1 to 65,536; this one is 0");
  CHECK(refusal("view { eye z look -z size 5, 65537 }") ==
        "E015 [65537] a size is whole and from 1 to 65,536; this one is 65537");
  CHECK(refusal("view { eye z look -z size 5, 2.5 }") ==
        "E015 [2.5] a size is whole and from 1 to 65,536; this one is 2.5");
  CHECK(refusal("view { eye z look 3 }") == "E030 [3] a view's look is a point <x, y, z>; this is a number");
  CHECK(refusal("view { eye z corners x, 2 * x, 3 * x }") ==
        "E016 [x, 2 * x, 3 * x] the corners of a view's screen lie on a line");
}
