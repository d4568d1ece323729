#include "catch.hpp"
#include "lang/build.hpp"

using namespace lancer;
using namespace lancer::lang;

namespace {

scene::Material material_of(const std::string& attributes) {
  const scene::Scene s = scene_of("sphere { x, 1 material { " + attributes + " } }");
  return s.materials[s.shapes[0].material];
}

std::string refusal_in(const std::string& attributes) {
  return refusal("sphere { x, 1 material { " + attributes + " } }");
}

}  // namespace

TEST_CASE("material: defaults", "[build][material]") {
  const scene::Material m = material_of("");
  CHECK(m == scene::Material{});
  CHECK(m.diffuse.color == grey(0.8));
  CHECK(m.ambient.color == grey(0.8));
  CHECK(m.specular.color == Color{});
  CHECK(m.shininess == 32);
  CHECK(m.ior == 1);
  CHECK_FALSE(m.fresnel);
}

TEST_CASE("material: every attribute", "[build][material]") {
  const scene::Material m = material_of(
      "diffuse 0.5 ambient 0.25 specular rgb(1, 0, 0) shininess 0 reflection 0.125 transmission <0, 1, 2> "
      "ior 1.5 fresnel true");
  CHECK(m.diffuse.color == grey(0.5));
  CHECK(m.ambient.color == grey(0.25));
  CHECK(m.specular.color == Color{1, 0, 0});
  CHECK(m.shininess == 0);
  CHECK(m.reflection.color == grey(0.125));
  CHECK(m.transmission.color == Color{0, 1, 2});
  CHECK(m.ior == 1.5);
  CHECK(m.fresnel);
  CHECK(material_of("color 0.5").diffuse.color == grey(0.5));
}

TEST_CASE("material: ambient is diffuse unless some ambient was written", "[build][material]") {
  CHECK(material_of("diffuse 0.25").ambient.color == grey(0.25));
  CHECK(material_of("from material { diffuse 0.5 } diffuse 0.25").ambient.color == grey(0.25));
  CHECK(material_of("from material { ambient 0.5 } diffuse 0.25").ambient.color == grey(0.5));
  CHECK(material_of("diffuse 0.25 from material { from material { ambient 0.5 } }").ambient.color ==
        grey(0.5));
}

TEST_CASE("material: from gives what is not written", "[build][material]") {
  const scene::Material m = material_of("specular 0.5 from material { diffuse 0.25 specular 0.75 ior 2 }");
  CHECK(m.diffuse.color == grey(0.25));
  CHECK(m.specular.color == grey(0.5));
  CHECK(m.ior == 2);
}

TEST_CASE("material: patterns are colours, and are stored once", "[build][material]") {
  const scene::Scene s = scene_of(
      "sphere { x, 1 material { diffuse checker(1, 0, 2) specular checker(1, 0, 2) reflection stripes(1, 0, "
      "y) } }");
  const scene::Material& m = s.materials[s.shapes[0].material];
  REQUIRE(s.patterns.size() == 2);
  CHECK(m.diffuse.pattern == m.specular.pattern);
  CHECK(m.ambient.pattern == m.diffuse.pattern);
  CHECK(s.patterns[m.diffuse.pattern].kind == scene::Pattern::Kind::checker);
  CHECK(s.patterns[m.diffuse.pattern].size == 2);
  CHECK(s.patterns[m.reflection.pattern].kind == scene::Pattern::Kind::stripes);
}

TEST_CASE("material: what is refused", "[build][material][refusals]") {
  CHECK(refusal_in("diffuse <1, -0.1, 1>") ==
        "E014 [<1, -0.1, 1>] a diffuse colour is not negative; this one is <1, -0.1, 1>");
  CHECK(refusal_in("color -1") == "E014 [-1] a diffuse colour is not negative; this one is -1");
  CHECK(refusal_in("ambient -1") == "E014 [-1] an ambient colour is not negative; this one is -1");
  CHECK(refusal_in("specular -1") == "E014 [-1] a specular colour is not negative; this one is -1");
  CHECK(refusal_in("reflection -0.5") == "E014 [-0.5] a reflection is not negative; this one is -0.5");
  CHECK(refusal_in("transmission -0.5") == "E014 [-0.5] a transmission is not negative; this one is -0.5");
  CHECK(refusal_in("shininess -1") == "E014 [-1] a shininess is not negative; this one is -1");
  CHECK(refusal_in("ior 0") == "E013 [0] an ior is positive; this one is 0");
  CHECK(refusal_in("fresnel 1") == "E030 [1] `fresnel` is a boolean; this is a number");
  CHECK(refusal_in("from red") == "E030 [red] `from` takes a material; this is a vector");
  CHECK(refusal_in("diffuse \"red\"") ==
        "E030 [\"red\"] a diffuse colour is a colour or a pattern; this is a string");
  CHECK(refusal_in("diffuse gradient(0, -1, x, y)") ==
        "E014 [gradient(0, -1, x, y)] a diffuse colour is not negative; this pattern has -1 in it");
  CHECK(refusal_in("diffuse fn (p) -> red") ==
        "E047 [fn (p) -> red] a diffuse colour cannot be a function yet: that comes with a later version");
}

TEST_CASE("settings: defaults and every attribute", "[build][settings]") {
  const scene::Settings standard = scene_of("").settings;
  CHECK(standard.background == Color{});
  CHECK(standard.ambient == grey(0.1));
  CHECK(standard.depth == 8);
  CHECK(standard.shadows == scene::Shadows::filtered);
  CHECK(standard.sum == scene::Sum::linear);
  CHECK(standard.exposure == 1);
  const scene::Settings s = scene_of(
                                "settings { background rgb(0, 0.5, 1) ambient 0.2 depth 0 ior 1.5 shadows "
                                "\"off\" sum \"log\" exposure 2 }")
                                .settings;
  CHECK(s.background == Color{0, 0.5, 1});
  CHECK(s.ambient == grey(0.2));
  CHECK(s.depth == 0);
  CHECK(s.ior == 1.5);
  CHECK(s.shadows == scene::Shadows::off);
  CHECK(s.sum == scene::Sum::log);
  CHECK(s.exposure == 2);
  CHECK(scene_of("settings { shadows \"opaque\" sum \"linear\" depth 1e300 }").settings.shadows ==
        scene::Shadows::opaque);
}

TEST_CASE("settings: what is given again wins with a warning", "[build][settings]") {
  const Built b = build("settings { depth 3 ambient 0.5 }\nsettings { depth 4 }");
  CHECK(b.messages == std::vector<std::string>{"W103 [depth] `depth` was set before; this one counts"});
  CHECK(b.scene.settings.depth == 4);
  CHECK(b.scene.settings.ambient == grey(0.5));
}

TEST_CASE("settings: what is refused", "[build][settings][refusals]") {
  CHECK(refusal("settings { depth 2.5 }") == "E015 [2.5] a depth is whole and not negative; this one is 2.5");
  CHECK(refusal("settings { depth -1 }") == "E015 [-1] a depth is whole and not negative; this one is -1");
  CHECK(refusal("settings { exposure 0 }") == "E013 [0] an exposure is positive; this one is 0");
  CHECK(refusal("settings { ior -1 }") == "E013 [-1] an ior is positive; this one is -1");
  CHECK(refusal("settings { background -0.5 }") ==
        "E014 [-0.5] a background is not negative; this one is -0.5");
  CHECK(refusal("settings { shadows \"soft\" }") ==
        "E015 [\"soft\"] `shadows` is \"filtered\", \"opaque\" or \"off\"; this is \"soft\"");
  CHECK(refusal("settings { sum true }") == "E030 [true] `sum` is \"linear\" or \"log\"; this is a boolean");
}
