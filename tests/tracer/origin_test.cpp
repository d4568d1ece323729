#include "tracer/origin.hpp"

#include "build.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

Scene with_slanted_mirror(const Affine& move) {
  Scene s = still_life(move);
  s.patterns[0].size = 0.6;
  add_plane(s, {0, 0, -6}, {0.25, 0.125, 1}, mirror(0.7), move);
  return s;
}

Rendered seen(const Affine& move) {
  scene::View v = view({0.1, 0.8, 5}, {0, -0.15, -1});
  v.columns = 60;
  v.rows = 40;
  const Place eye = move.place({v.eye, {}});
  v.eye = eye.at;
  v.eye_rest = eye.rest;
  return picture(with_slanted_mirror(move), v, 1, 1);
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
