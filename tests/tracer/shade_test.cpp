#include "tracer/shade.hpp"

#include "base/math.hpp"
#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

const Vec3 k_eye{0, 0, 5}, k_ahead{0, 0, -1};

/// A wall z = 0 that faces the eye, and an ambient light of 0.
Scene wall(const Material& m) {
  Scene s;
  s.settings.ambient = {};
  add_plane(s, {0, 0, 0}, {0, 0, 1}, m);
  return s;
}

/// A plane z = `z` facing along `facing` that glows with a gradient in x, from 0 at x = 0 to 1 at x = `to`.
void add_ruler(Scene& s, double z, double facing, double to) {
  Material m = glowing(1);
  m.ambient.pattern = static_cast<Index>(s.patterns.size());
  scene::Pattern p;
  p.kind = scene::Pattern::Kind::gradient;
  p.b = grey(1);
  p.to = {to, 0, 0};
  s.patterns.push_back(p);
  add_plane(s, {0, 0, z}, {0, 0, facing}, m);
  s.settings.ambient = grey(1);
}

}  // namespace

TEST_CASE("shade: ambient is ka A, colour by colour", "[shade]") {
  Material m = black();
  m.ambient.color = {0.5, 0.25, 1};
  Scene s = wall(m);
  s.settings.ambient = {0.5, 1, 0.125};
  CHECK(seen(s, k_eye, k_ahead) == Color{0.25, 0.25, 0.125});
}

TEST_CASE("shade: diffuse is kd I n.l", "[shade]") {
  Scene s = wall(matt(0.5));
  s.lights.push_back(point_light({0, 3, 4}, 2));  // n.l = 4/5
  CHECK(seen(s, k_eye, k_ahead).r == Approx(0.5 * 2 * 0.8));
}

TEST_CASE("shade: a light behind the surface adds nothing, highlights included", "[shade]") {
  Material m = matt(0.5);
  m.specular.color = grey(1);
  m.shininess = 0;
  Scene s = wall(m);
  s.settings.shadows = scene::Shadows::off;
  s.lights.push_back(point_light({0, 3, -4}));
  CHECK(is_black(seen(s, k_eye, k_ahead)));
}

TEST_CASE("shade: specular is ks I (n.h)^shininess", "[shade]") {
  // The light stands 60 degrees from the view, so h is 30 degrees from n: cos^2 30 = 3/4.
  Material m = black();
  m.specular.color = grey(0.5);
  m.shininess = 2;
  Scene s = wall(m);
  s.lights.push_back(point_light(Vec3{math::sin_deg(60), 0, math::cos_deg(60)} * 7));
  CHECK(seen(s, k_eye, k_ahead).r == Approx(0.375));
}

TEST_CASE("shade: lights add up", "[shade]") {
  Scene s = wall(matt(1));
  s.lights.push_back(point_light({0, 0, 3}, 0.25));
  s.lights.push_back(sun({0, 0, -2}, 0.5));
  CHECK(seen(s, k_eye, k_ahead).r == Approx(0.75));
}

TEST_CASE("shade: the background is what a ray sees that hits nothing", "[shade]") {
  Scene s = wall(black());
  s.settings.background = {0.25, 0.5, 0.75};
  CHECK(seen(s, k_eye, {0, 0, 1}) == Color{0.25, 0.5, 0.75});
}

TEST_CASE("shade: a mirror shows what lies in the mirror direction, times kr", "[shade]") {
  // From (-1, 0, 1) at 45 degrees into the wall at the origin; off to the ruler z = 2, met at x = 2.
  Scene s = wall(mirror(0.5));
  add_ruler(s, 2, -1, 4);
  CHECK(seen(s, {-1, 0, 1}, {1, 0, -1}).r == Approx(0.5 * 0.5));
}

TEST_CASE("shade: depth counts reflections, and none are followed at 0", "[shade]") {
  // Between the wall and the ruler, which is made a mirror of 1/2: each turn halves what is seen.
  Scene s = wall(mirror(0.5));
  Material m = mirror(0.5);
  m.ambient.color = grey(1);
  s.settings.ambient = grey(1);
  add_plane(s, {0, 0, 8}, {0, 0, -1}, m);
  s.settings.depth = 0;
  CHECK(seen(s, k_eye, k_ahead).r == 0);
  s.settings.depth = 1;
  CHECK(seen(s, k_eye, k_ahead).r == 0.5);
  s.settings.depth = 2;
  CHECK(seen(s, k_eye, k_ahead).r == 0.5);
  s.settings.depth = 3;  // wall, far plane 1/2, wall, far plane 1/8
  CHECK(seen(s, k_eye, k_ahead).r == 0.625);
}

TEST_CASE("shade: what is transmitted straight on is kt times what lies behind", "[shade]") {
  Scene s;
  s.settings.ambient = grey(1);
  add_box(s, {-1, -1, -1}, {1, 1, 1}, clear(0.5, 1.5));
  add_plane(s, {0, 0, -3}, {0, 0, 1}, glowing(1));
  CHECK(seen(s, k_eye, k_ahead).r == 0.25);  // in and out
  s.settings.depth = 1;
  CHECK(seen(s, k_eye, k_ahead).r == 0);
  s.settings.depth = 2;
  CHECK(seen(s, k_eye, k_ahead).r == 0.25);
}

TEST_CASE("shade: transmitted light bends by Snell's law", "[shade]") {
  // 45 degrees into glass of 1.5: sin t = sqrt(2)/3, tan t = sqrt(2/7); the ruler lies 1 below.
  Scene s = wall(clear(1, 1.5));
  add_ruler(s, -1, 1, 1);
  CHECK(seen(s, {-1, 0, 1}, {1, 0, -1}).r == Approx(std::sqrt(2.0 / 7)));
  // The settings' own index counts outside: 1.5 to 1.5 goes straight on.
  s.settings.ior = 1.5;
  CHECK(seen(s, {-0.25, 0, 1}, {0.25, 0, -1}).r == Approx(0.25));
}

TEST_CASE("shade: under total reflection T is the mirror radiance", "[shade]") {
  // From inside the glass, 45 degrees onto the surface (critical: 41.8), back down to the ruler z = -1 at x
  // = 1.
  Material glass = clear(0.75, 1.5);
  Scene s = wall(glass);
  add_ruler(s, -1, 1, 4);
  CHECK(seen(s, {-0.5, 0, -0.5}, {1, 0, 1}).r == Approx(0.75 * 0.25));
  s.materials[0].reflection.color = grey(0.125);  // kr R + kt T, both along the mirror direction
  CHECK(seen(s, {-0.5, 0, -0.5}, {1, 0, 1}).r == Approx(0.875 * 0.25));
  s.materials[0].fresnel = true;  // kr + F kt with F = 1, and 0 for T
  CHECK(seen(s, {-0.5, 0, -0.5}, {1, 0, 1}).r == Approx(0.875 * 0.25));
}

TEST_CASE("shade: Fresnel shares transmission between mirror and refraction", "[shade]") {
  // Straight on from air into 1.5: F = 0.04. 1 lies behind the eye, 0.5 in the glass.
  Material glass = clear(0.5, 1.5);
  glass.fresnel = true;
  glass.reflection.color = grey(0.25);
  Scene s = wall(glass);
  s.settings.ambient = grey(1);
  add_plane(s, {0, 0, 9}, {0, 0, -1}, glowing(1));
  add_plane(s, {0, 0, -9}, {0, 0, 1}, glowing(0.5));
  CHECK(seen(s, k_eye, k_ahead).r == Approx((0.25 + 0.04 * 0.5) * 1 + 0.96 * 0.5 * 0.5));
}

TEST_CASE("shade: a facet passes light unbent, whatever its index, and reflects nothing by Fresnel",
          "[shade]") {
  Material glass = clear(0.5, 1.5);
  glass.fresnel = true;
  Scene s;
  add_facet(s, {-9, -9, 0}, {9, -9, 0}, {0, 9, 0}, glass);
  add_ruler(s, -1, 1, 1);
  s.settings.background = grey(100);
  CHECK(seen(s, {-0.75, 0, 1}, {0.75, 0, -1}).r == Approx(0.75 * 0.5));
}

TEST_CASE("shade: from inside a surface shines as from outside", "[shade]") {
  // In an opaque ball with a lamp in its middle: n.l = 1 everywhere.
  Scene s;
  s.settings.ambient = {};
  add_sphere(s, {0, 0, 0}, 2, matt(0.5));
  s.lights.push_back(point_light({0, 0, 0}));
  CHECK(seen(s, {0.5, 0.5, 0}, {1, 2, 3}).r == Approx(0.5));
}

TEST_CASE("shade: sum log joins clamped terms as 1 - (1-a)(1-b)", "[shade]") {
  Material m = matt(0.8);
  m.ambient.color = grey(0.5);
  Scene s = wall(m);
  s.settings.ambient = grey(1);
  s.settings.sum = scene::Sum::log;
  s.lights.push_back(point_light({0, 0, 3}));
  CHECK(seen(s, k_eye, k_ahead).r == Approx(0.9));  // 0.5 and 0.8
  s.lights.push_back(point_light({0, 0, 3}));
  CHECK(seen(s, k_eye, k_ahead).r == Approx(0.98));  // and 0.8 again: each light is a term
  s.lights.push_back(point_light({0, 0, 3}, 40));
  CHECK(seen(s, k_eye, k_ahead).r == 1);
}

TEST_CASE("shade: sum log joins reflection and transmission, each clamped, at every surface", "[shade]") {
  // The film: ambient 0.1, mirror 0.5 of (ambient 0.6 behind the eye), clear 0.5 of (ambient 0.4 behind it).
  Material film = clear(0.5, 1);
  film.reflection.color = grey(0.5);
  film.ambient.color = grey(0.1);
  Scene s;
  s.settings.sum = scene::Sum::log;
  s.settings.ambient = grey(1);
  add_facet(s, {-9, -9, 0}, {9, -9, 0}, {0, 9, 0}, film);
  add_plane(s, {0, 0, 9}, {0, 0, -1}, glowing(0.6));
  add_plane(s, {0, 0, -9}, {0, 0, 1}, glowing(0.4));
  CHECK(seen(s, k_eye, k_ahead).r == Approx(1 - 0.9 * 0.7 * 0.8));
}

TEST_CASE("shade: sum log keeps R and T apart under total reflection", "[shade]") {
  // As above in the linear sum: ruler 0.25; terms 0.5 x 0.25 and 0.75 x 0.25.
  Material glass = clear(0.75, 1.5);
  glass.reflection.color = grey(0.5);
  Scene s = wall(glass);
  s.settings.sum = scene::Sum::log;
  add_ruler(s, -1, 1, 4);
  CHECK(seen(s, {-0.5, 0, -0.5}, {1, 0, 1}).r == Approx(1 - (1 - 0.125) * (1 - 0.1875)));
}

TEST_CASE("shade: smooth normals are interpolated and turned to face the ray", "[shade]") {
  // In the middle of the long side the normals (1,0,1) and (-1,0,1) cancel to z; at its ends they stand
  // alone.
  Scene s;
  s.settings.ambient = {};
  add_facet(s, {-1, 0, 0}, {1, 0, 0}, {0, 9, 0}, matt(1));
  const double h = std::sqrt(0.5);
  s.facet_normals.push_back({Vec3{-h, 0, h}, Vec3{h, 0, h}, Vec3{0, 0, 1}});
  s.facets[0].normals = 0;
  s.lights.push_back(sun({0, 0, -1}));
  CHECK(seen(s, {0, 1e-9, 5}, k_ahead).r == Approx(1));
  CHECK(seen(s, {0.999999, 1e-9, 5}, k_ahead).r == Approx(h).epsilon(1e-5));
  s.lights[0] = sun({0, 0, 1});
  CHECK(seen(s, {0.999999, 1e-9, -5}, {0, 0, 1}).r == Approx(h).epsilon(1e-5));
}

TEST_CASE("shade: smooth normals travel by the inverse transpose", "[shade]") {
  // Own normal (1, 0, 1)/sqrt2 under scale <2, 1, 1> becomes (1/2, 0, 1): cosine to z 2/sqrt5.
  Scene s;
  s.settings.ambient = {};
  add_facet(s, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, matt(1), scaling({2, 1, 1}));
  const double h = std::sqrt(0.5);
  s.facet_normals.push_back({Vec3{h, 0, h}, Vec3{h, 0, h}, Vec3{h, 0, h}});
  s.facets[0].normals = 0;
  s.lights.push_back(sun({0, 0, -1}));
  CHECK(seen(s, k_eye, k_ahead).r == Approx(2 / std::sqrt(5.0)));
}

TEST_CASE("shade: a mesh may have smooth normals", "[shade]") {
  scene::Mesh mesh;
  mesh.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.faces = {{0, 1, 2}, {0, 2, 3}};
  mesh.normals = {{0, 0, 1}, {0, 0.6, 0.8}, {0, 0, 1}, {0, 0, 1}};
  Scene s;
  s.settings.ambient = {};
  add_mesh(s, mesh, matt(1));
  s.lights.push_back(sun({0, 0, -1}));
  CHECK(seen(s, {-0.5, 0.5, 5}, k_ahead).r == Approx(1));
  CHECK(seen(s, {0.9999999, -0.9999999, 5}, k_ahead).r == Approx(0.8).epsilon(1e-5));
}

TEST_CASE("shade: an ellipsoid is lit by its own normals", "[shade]") {
  // x^2 + y^2/4 = 1 at (0.6, 1.6): normal (0.6, 0.4)/|.|; the sun along -y.
  Scene s;
  s.settings.ambient = {};
  add_sphere(s, {0, 0, 0}, 1, matt(1), scaling({1, 2, 1}));
  s.lights.push_back(sun({0, -1, 0}));
  CHECK(seen(s, {0.6, 9, 0}, {0, -1, 0}).r == Approx(0.4 / std::sqrt(0.52)));
}

TEST_CASE("shade: a plane's normal follows mirroring and stretching transforms", "[shade]") {
  // x + z = 0 under scale <-2, 1, 1>: x' = -2x, normal (-1/2, 0, 1); the eye above sees it from outside, lit
  // by 2/sqrt5.
  Scene s;
  s.settings.ambient = {};
  add_plane(s, {0, 0, 0}, {1, 0, 1}, matt(1), scaling({-2, 1, 1}));
  s.lights.push_back(sun({0, 0, -1}));
  CHECK(seen(s, k_eye, k_ahead).r == Approx(2 / std::sqrt(5.0)));
}
