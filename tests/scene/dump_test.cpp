#include "catch.hpp"
#include "scene/scene.hpp"

using namespace lancer;
using namespace lancer::scene;

namespace {

/// What follows the line of settings.
std::string body(const Scene& scene) {
  const std::string text = dump(scene);
  return text.substr(text.find('\n') + 1);
}

}  // namespace

TEST_CASE("dump: an empty scene is its settings", "[dump]") {
  Scene s;
  s.settings.background = {0.1, 0, 1e-7};
  s.settings.shadows = Shadows::opaque;
  s.settings.sum = Sum::log;
  CHECK(dump(s) ==
        "settings background <0.1, 0, 1e-7> ambient <0.1, 0.1, 0.1> depth 8 ior 1 shadows opaque sum log "
        "exposure 1\n");
}

TEST_CASE("dump: shapes with all their fields, unnamed ones counted by kind", "[dump]") {
  Scene s;
  s.names = {"", "ball", "a \"b\"\n{"};
  s.spheres = {{{0, 1, 0}, 1}, {{0, 0, 0}, 0.5}};
  s.planes = {{{0, 0, 0}, {0, 1, 0}, -2}};
  s.boxes = {{{0, 0, 0}, {1, 2, 3}, 1}};
  s.facets = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, k_none}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0}};
  s.facet_normals = {{Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{1, 0, 0}}};
  s.meshes = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}, false}};
  s.shapes = {{ShapeKind::sphere, true, 0, 2, 0, 1, {}}, {ShapeKind::sphere, false, 1, 0, 1, 0, {}},
              {ShapeKind::plane, true, 0, 0, 0, 0, {}},  {ShapeKind::box, true, 0, 0, 0, 2, {}},
              {ShapeKind::facet, true, 0, 0, 0, 0, {}},  {ShapeKind::facet, true, 1, 0, 0, 0, {}},
              {ShapeKind::sphere, true, 1, 0, 0, 0, {}}, {ShapeKind::mesh, true, 0, 0, 0, 0, {}}};
  CHECK(body(s) ==
        "sphere \"ball\" center <0, 1, 0> radius 1 material 2 transform 0 shadow true\n"
        "sphere 1 center <0, 0, 0> radius 0.5 material 0 transform 1 shadow false\n"
        "plane 1 point <0, 0, 0> normal <0, 1, 0> offset -2 material 0 transform 0 shadow true\n"
        "box \"a \\\"b\\\"\\n\\{\" corners <0, 0, 0> <1, 2, 3> frame 1 material 0 transform 0 shadow true\n"
        "facet 1 points <0, 0, 0> <1, 0, 0> <0, 1, 0> material 0 transform 0 shadow true\n"
        "facet 2 points <0, 0, 0> <1, 0, 0> <0, 1, 0> normals <0, 0, 1> <0, 1, 0> <1, 0, 0> material 0 "
        "transform 0 shadow true\n"
        "sphere 2 center <0, 0, 0> radius 0.5 material 0 transform 0 shadow true\n"
        "mesh 1 points 3 faces 1 smooth false solid false material 0 transform 0 shadow true\n"
        "  point 0 <0, 0, 0>\n"
        "  point 1 <1, 0, 0>\n"
        "  point 2 <0, 1, 0>\n"
        "  face 0 1 2\n");
}

TEST_CASE("dump: transforms, patterns and materials by their place", "[dump]") {
  Scene s;
  s.transforms.push_back({translation({1, 2, 3}), translation({-1, -2, -3})});
  s.patterns.resize(3);
  s.patterns[0] = {Pattern::Kind::checker, {1, 1, 1}, {}, 2, {}, {}, {}};
  s.patterns[1] = {Pattern::Kind::stripes, {1, 0, 0}, {}, 0.5, {0, 1, 0}, {}, {}};
  s.patterns[2] = {Pattern::Kind::gradient, {}, {1, 1, 1}, 1, {}, {0, 0, 0}, {0, 1, 0}};
  s.materials.resize(1);
  s.materials[0].diffuse = {{}, 1};
  s.materials[0].fresnel = true;
  CHECK(body(s) ==
        "transform 1 rows <1, 0, 0> <0, 1, 0> <0, 0, 1> translation <1, 2, 3>\n"
        "  inverse rows <1, 0, 0> <0, 1, 0> <0, 0, 1> translation <-1, -2, -3>\n"
        "pattern 0 checker <1, 1, 1> <0, 0, 0> size 2\n"
        "pattern 1 stripes <1, 0, 0> <0, 0, 0> axis <0, 1, 0> width 0.5\n"
        "pattern 2 gradient <0, 0, 0> <1, 1, 1> from <0, 0, 0> to <0, 1, 0>\n"
        "material 0 diffuse pattern 1 ambient <0.8, 0.8, 0.8> specular <0, 0, 0> shininess 32 reflection <0, "
        "0, 0> "
        "transmission <0, 0, 0> ior 1 fresnel true\n");
}

TEST_CASE("dump: lights and views of every kind", "[dump]") {
  Scene s;
  s.names = {"", "key"};
  s.lights.resize(3);
  s.lights[0].at = {1, 2, 3};
  s.lights[0].falloff = 2;
  s.lights[0].name = 1;
  s.lights[1].kind = LightKind::sun;
  s.lights[1].direction = {0, -1, 0};
  s.lights[2].kind = LightKind::spot;
  s.lights[2].direction = {0, -1, 0};
  s.views.resize(3);
  s.views[1].projection = Projection::orthographic;
  s.views[1].width = 4;
  s.views[2].projection = Projection::corners;
  s.views[2].corners = {Vec3{-1, 1, 0}, Vec3{1, 1, 0}, Vec3{-1, -1, 0}};
  CHECK(body(s) ==
        "light \"key\" at <1, 2, 3> color <1, 1, 1> falloff 2\n"
        "sun 1 direction <0, -1, 0> color <1, 1, 1>\n"
        "spot 1 at <0, 0, 0> direction <0, -1, 0> angle 30 softness 0.1 color <1, 1, 1>\n"
        "view 1 eye <0, 0, 0> look <0, 0, -1> up <0, 1, 0> fov 50 size 640, 480\n"
        "view 2 eye <0, 0, 0> look <0, 0, -1> up <0, 1, 0> width 4 size 640, 480\n"
        "view 3 eye <0, 0, 0> corners <-1, 1, 0> <1, 1, 0> <-1, -1, 0> size 640, 480\n");
}
