// Which pixels the first look leaves in doubt.

#include "tracer/sampling/doubt.hpp"

#include "build.hpp"
#include "catch.hpp"
#include "tracer/sampling/stratum.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

constexpr int k_side = 16;

/// The doubtful pixels of a view of 16 x 16 that looks down on the scene, which is 16 x 16, too: pixel (i, j)
/// shows the square from (i, j) to (i + 1, j + 1) of the plane z = 0, y downwards.
std::vector<std::pair<int, int>> doubtful(const Scene& s, float limit) {
  scene::View v = view({8, -8, 10}, {0, 0, -1}, k_side);
  v.projection = scene::Projection::orthographic;
  v.width = k_side;
  const Plan needed = plan(s, v, {});
  const World world = prepare(s, {}, nullptr, needed.tree);
  const Job job{{&world, &needed, nullptr}, Camera(v, k_side, k_side), {0, 0, k_side, k_side}, {}, {}};
  Lattice lattice(job.region);
  ViewTracer tracer(job);
  lattice.sample(0, 0, lattice.columns(), lattice.rows(), tracer);
  const Display display(1);
  Doubt doubt(display, limit);
  doubt.look(lattice, {0, 0, k_side, k_side});
  std::vector<std::pair<int, int>> out;
  for (int y = 0; y < k_side; ++y) {
    for (int x = 0; x < k_side; ++x) {
      if (doubt.at(x, y)) out.emplace_back(x, y);
    }
  }
  return out;
}

Scene glowing_scene() {
  Scene s;
  s.settings.ambient = grey(1);
  s.settings.background = grey(0.1);
  return s;
}

}  // namespace

TEST_CASE("doubt: an edge is one pixel wide", "[doubt]") {
  Scene s = glowing_scene();
  add_box(s, {-90, -90, -1}, {5.4, 90, 0}, glowing(0.6));
  const auto found = doubtful(s, 0.03F);
  CHECK(found.size() == k_side);
  for (const auto& [x, y] : found) CHECK(x == 5);
}

TEST_CASE("doubt: a slope is none, beside an edge either", "[doubt]") {
  Scene s = glowing_scene();
  s.settings.background = {};
  Material slope = glowing(1);
  slope.ambient.pattern = 0;
  s.patterns.emplace_back();
  s.patterns[0].kind = scene::Pattern::Kind::gradient;
  s.patterns[0].a = grey(0.2);
  s.patterns[0].b = grey(0.8);
  s.patterns[0].from = {-20, 0, 0};
  s.patterns[0].to = {40, 0, 0};
  add_box(s, {-90, -90, -1}, {90, 90, 0}, slope);
  CHECK(doubtful(s, 0.005F).empty());
  add_box(s, {-90, -90, 1}, {90, -8.5, 2}, glowing(0.9));
  const auto found = doubtful(s, 0.005F);
  CHECK(found.size() == k_side);
  for (const auto& [x, y] : found) CHECK(y == 8);
}

TEST_CASE("doubt: what lies between the corners is looked for around, too", "[doubt]") {
  Scene s = glowing_scene();
  const ScreenPoint in = point_in({7, 7}, {});
  add_sphere(s, {7 + in.x, -7 - in.y, 0}, 0.01, glowing(0.9));
  const auto found = doubtful(s, 0.03F);
  REQUIRE(found.size() == 9);
  CHECK(found.front() == std::pair(6, 6));
  CHECK(found.back() == std::pair(8, 8));
}
