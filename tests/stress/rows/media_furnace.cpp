// Energy that must come back whole: white all around stays white.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "stress/rows/rows.hpp"
#include "stress/subjects/glass.hpp"
#include "stress/subjects/script.hpp"
#include "stress/truth/reference/pictures.hpp"

namespace lancer::stress {
namespace {

/// Surfaces that return all that they get.
Scripts furnaces() {
  const std::string glass = "material { ambient 0 diffuse 0 transmission 1 ior 1.5 fresnel true } }\n";
  const std::string half = "material { ambient 0 diffuse 0 reflection 0.25 transmission 0.75 } }\n";
  const std::string bubble = "material { ambient 0 diffuse 0 transmission 1 ior 0.67 fresnel true } }\n";
  Scripts scenes = {
      {"mirror ball", "sphere { <0, 0, 0>, 1 material { ambient 0 diffuse 0 reflection 1 } }\n"},
      {"mirror box in a corner of mirrors",
       "box { <-1, -1, -1>, <1, 1, 1> rotate <10, 20, 30> material { ambient 0 diffuse 0 reflection 1 } }\n"
       "plane { y, -1.6 material { ambient 0 diffuse 0 reflection 1 } }\n"
       "plane { x, -1.9 material { ambient 0 diffuse 0 reflection 1 } }\n"}};
  for (const Solid& solid : solids()) {
    const std::string begin = solid.begin + " " + solid.turn + " ";
    scenes.emplace_back("glass " + solid.name, begin + glass);
    scenes.emplace_back("half-silvered " + solid.name, begin + half);
    scenes.emplace_back("thin " + solid.name, begin + bubble);
  }
  return scenes;
}

Outcome furnace(const Settings& settings) {
  const int size = settings.full ? 64 : 16;
  double worst = 0, cut = 0, at_depth = 0;
  Measure measure = measure_in_use("white pixels");
  Outcome out;
  for (const auto& scene : furnaces()) {
    const std::string &name = scene.first, &text = scene.second;
    const auto script = [&](int depth) {
      return Script(fmt::format("settings {{ background 1 ambient 0 depth {} }}\n", depth) + text +
                    view({0.3, 0.4, 4}, {-0.06, -0.1, -1}, 40, size));
    };
    const Script whole = script(100000);
    double here = 0;
    for (const Color& c : drawn(whole.scene, whole.view)) {
      ++measure.rays;
      here = std::max(here, reference::difference(c, grey(1)));
      if (!(std::fabs(c.r - 1) <= 1e-12)) ++measure.wrong;
    }
    if (here > worst) out.note = "largest error: " + name;
    worst = std::max(worst, here);
    // Cut off early: what is missing is what was not followed.
    const Script early = script(5);
    Measures measures;
    measures.limit = 1e-12;
    const Verdict verdict = judge(name, early.scene, early.view, measures);
    at_depth = std::max(at_depth, verdict.worst);
    for (const Color& c : drawn(early.scene, early.view)) cut = std::max(cut, c.r - 1);
  }
  out.measures.push_back(measure);
  out.limits = {{"energy", worst, 1e-12},
                {"energy more than whole, cut off at depth 5", cut, 1e-12},
                {"energy cut off at depth 5", at_depth, 1e-12}};
  return out;
}

}  // namespace

void add_media_furnace_rows(Rows& rows) {
  rows.push_back({"media.furnace", "white all around stays white", furnace});
}

}  // namespace lancer::stress
