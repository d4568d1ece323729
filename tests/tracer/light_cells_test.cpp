#include "tracer/light_cells.hpp"

#include <algorithm>

#include "catch.hpp"
#include "random_scene.hpp"
#include "tracer/light.hpp"

using namespace lancer;
using namespace lancer::tracer;
using namespace lancer::tracer::test;

namespace {

Plan planned(const Scene& s, double error) {
  Options options;
  options.error = error;
  return plan(s, view({0, 0, 9}, {0, 0, -1}), options);
}

}  // namespace

TEST_CASE("light cells: what is not asked is dark there, or together too faint", "[light_cells]") {
  int used = 0;
  std::uint64_t outside = 0, faint = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    const Scene s = random_scene(seed);
    const Plan p = planned(s, 0.05);
    if (!p.light_cells.used) continue;
    ++used;
    LightCells cells(s, p);
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
      const Vec3 at = random.in_cube(i % 3 == 0 ? 100 : 4);
      const LightCells::Cell& cell = cells.at(at);
      REQUIRE(std::is_sorted(cell.lights.begin(), cell.lights.end()));
      outside += cell.outside_cone;
      faint += cell.faint;
      double sum = 0;
      for (Index light = 0; light < s.lights.size(); ++light) {
        // Nor does the plan ask those that shine on no surface anywhere.
        const bool never = !p.every_light && !std::binary_search(p.lights.begin(), p.lights.end(), light);
        if (never || std::binary_search(cell.lights.begin(), cell.lights.end(), light)) continue;
        const Color c = incoming(s.lights[light], at).intensity;
        sum += std::max({c.r, c.g, c.b});
      }
      INFO("seed " << seed);
      REQUIRE(sum <= p.light_cells.faint * (1 + 1e-9));
    }
  }
  CHECK(used > 10);
  CHECK(outside > 1000);
  CHECK(faint > 100);
}

TEST_CASE("light cells: few lights are asked everywhere", "[light_cells]") {
  Scene s;
  add_sphere(s, {}, 1);
  for (int i = 0; i < 9; ++i) s.lights.push_back(point_light({0, 5, 0}));
  CHECK_FALSE(planned(s, 0.05).light_cells.used);  // none has limits
  for (int i = 0; i < 5; ++i) s.lights[static_cast<std::size_t>(i)].falloff = 1;
  CHECK(planned(s, 0.05).light_cells.used);
  CHECK_FALSE(planned(s, 0).light_cells.used);
  CHECK(planned(s, 0.05).light_cells.faint > 0);
}
