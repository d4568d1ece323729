#include "tracer/origin.hpp"

#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

/// Glass, a mirror, a turned box, a squeezed sphere, facets and patterns around the origin, then moved.
Scene still_life(const Affine& move) {
  Scene s;
  s.settings.background = {0.1, 0.2, 0.3};
  Material glass = clear(0.9, 1.5);
  glass.fresnel = true;
  Material checkered = matt(0.8);
  checkered.diffuse.pattern = 0;
  s.patterns.emplace_back();
  s.patterns[0].a = grey(1);
  s.patterns[0].b = grey(0.2);
  s.patterns[0].size = 0.6;
  add_plane(s, {0, -1, 0}, {0, 1, 0}, checkered, move);
  add_plane(s, {0, 0, -6}, {0.25, 0.125, 1}, mirror(0.7), move);
  add_sphere(s, {0, 0, 0}, 1, glass, move);
  add_box(s, {1, -1, -2}, {2, 0, -1}, mirror(0.8), then(rotation({0, 20, 0}), move));
  add_sphere(s, {}, 0.5, matt(0.6), then(then(scaling({1, 2, 1}), translation({-1.5, 0, -1})), move));
  add_mesh(s, cube_mesh(true), clear(0.7, 1.3),
           then(then(scaling({0.3, 0.3, 0.3}), translation({0.5, -0.7, 1.3})), move));
  s.lights.push_back(point_light({4, 6, 5}));
  const Place at = move.place({s.lights[0].at, {}});
  s.lights[0].at = at.at;
  s.lights[0].at_rest = at.rest;
  return s;
}

Rendered seen(const Affine& move) {
  scene::View v = view({0.1, 0.8, 5}, {0, -0.15, -1});
  v.columns = 60;
  v.rows = 40;
  const Place eye = move.place({v.eye, {}});
  v.eye = eye.at;
  v.eye_rest = eye.rest;
  return picture(still_life(move), v, 1, 1);
}

}  // namespace

TEST_CASE("origin: the world starts at the eye where everything is as far as that", "[origin]") {
  Scene s;
  CHECK(world_origin(s, {9, 9, 9}) == Vec3{});
  add_sphere(s, {10, -10, 1}, 100);
  CHECK(world_origin(s, {9, -9, 0}) == Vec3{9, -9, 0});
  CHECK(world_origin(s, {20, -5, 2.5}) == Vec3{20, -5, 0});
  CHECK(world_origin(s, {20.5, -4.5, 0.5}) == Vec3{0, 0, 0.5});
  add_box(s, {10, -12, -1}, {12, -10, 1});
  CHECK(world_origin(s, {12, -10, 1}) == Vec3{12, -10, 0});
  add_facet(s, {100, -10, 5}, {100, -11, 5}, {101, -10, 5});
  CHECK(world_origin(s, {12, -10, 1}) == Vec3{0, -10, 0});
}

TEST_CASE("origin: a plane has a place along its axis only", "[origin]") {
  Scene s;
  add_plane(s, {3, 4, 5}, {0, 1, 0});
  CHECK(world_origin(s, {1000, 5, 1000}) == Vec3{0, 5, 0});
  CHECK(world_origin(s, {1000, 50, 1000}) == Vec3{});
  add_plane(s, {3, 4, 5}, {1, 1, 0});
  CHECK(world_origin(s, {1000, 5, 1000}) == Vec3{0, 5, 0});
}

TEST_CASE("origin: the picture does not show where the scene stands", "[origin]") {
  const Rendered here = seen(Affine{});
  const Affine moves[] = {translation({0x1p30, -0x1.8p30, 0x1p29}), translation({1e9, 2e9, 3e9}),
                          translation({-1e9, 1e6, 1e3}),
                          then(scaling({1e9, 1e9, 1e9}), translation({1e18, 0, -3e18}))};
  for (const Affine& move : moves) {
    const Rendered there = seen(move);
    double worst = 0;
    for (std::size_t i = 0; i < here.image.data().size(); ++i) {
      worst = std::max(worst, std::fabs(static_cast<double>(here.image.data()[i]) -
                                        static_cast<double>(there.image.data()[i])));
    }
    CHECK(worst <= 1e-7);
  }
}
