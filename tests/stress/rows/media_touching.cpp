// Glass upon glass: solids that share faces, touch or are the same.

#include <fmt/format.h>

#include "stress/rows/rows.hpp"
#include "stress/subjects/glass.hpp"
#include "stress/subjects/script.hpp"
#include "stress/truth/reference/pictures.hpp"

namespace lancer::stress {
namespace {

/// Solids that share faces, touch or are the same.
Scripts touching_solids() {
  const std::string clear = "material { ambient 0 diffuse 0 transmission 0.95 ior ";
  const auto glass = [&](const std::string& shape, double ior, const std::string& turn = "") {
    return fmt::format("{} {}{} }} {} }}\n", shape, clear, ior, turn);
  };
  const std::string cube_mesh =
      "mesh { points [<-1,-1,-1>, <1,-1,-1>, <-1,1,-1>, <1,1,-1>, <-1,-1,1>, <1,-1,1>, <-1,1,1>, <1,1,1>] "
      "faces "
      "[[0,2,1],[1,2,3],[4,5,6],[5,7,6],[0,1,4],[1,5,4],[2,6,3],[3,6,7],[0,4,2],[2,4,6],[1,3,5],[3,7,5]] "
      "solid true";
  const std::string cube = "box { <-1, -1, -1>, <1, 1, 1>";
  Scripts scenes;
  for (const auto& [one, two] : {std::pair{1.5, 1.2}, {1.2, 1.5}, {1.5, 1.5}, {0.7, 1.3}}) {
    for (const std::string& turned : {std::string{}, std::string(k_oblique)}) {
      scenes.emplace_back("cube twice", glass(cube, one, turned) + glass(cube, two, turned));
      scenes.emplace_back("cube and mesh", glass(cube, one, turned) + glass(cube_mesh, two, turned));
      scenes.emplace_back("mesh and cube", glass(cube_mesh, one, turned) + glass(cube, two, turned));
      scenes.emplace_back("side by side", glass("box { <-1, -1, -1>, <0.1, 1, 1>", one, turned) +
                                              glass("box { <0.1, -1, -1>, <1.2, 1, 1>", two, turned));
      scenes.emplace_back("one upon the other",
                          glass("box { <-1, -1, -1>, <1, 0.1, 1>", one, turned) +
                              glass("box { <-0.7, 0.1, -0.7>, <0.7, 1, 0.7>", two, turned));
      scenes.emplace_back(
          "in a corner", glass(cube, one, turned) + glass("box { <-0.3, -0.2, 0.1>, <1, 1, 1>", two, turned));
      scenes.emplace_back("ball twice", glass("sphere { <0, 0, 0>, 1", one, turned) +
                                            glass("sphere { <0, 0, 0>, 1", two, turned));
      scenes.emplace_back("ball in a cube",
                          glass(cube, one, turned) + glass("sphere { <0, 0, 0>, 1", two, turned));
      scenes.emplace_back("ball on a cube",
                          glass(cube, one, turned) + glass("sphere { <0.2, 2, 0.1>, 1", two, turned));
      scenes.emplace_back("three slabs", glass("box { <-1, -1, -1>, <-0.3, 1, 1>", one, turned) +
                                             glass("box { <-0.3, -1, -1>, <0.3, 1, 1>", two, turned) +
                                             glass("box { <0.3, -1, -1>, <1, 1, 1>", one, turned));
    }
    scenes.emplace_back("water to the ground", glass("plane { y, 0", one) + glass("plane { y, -0.4", two));
    scenes.emplace_back("water twice", glass("plane { y, 0", one) + glass("plane { <0, 2, 0>, 0", two));
  }
  return scenes;
}

Outcome touching(const Settings& settings) {
  const int size = settings.full ? 64 : 16;
  Measures measures;
  measures.limit = 1e-14;
  Verdict all;
  int number = 0;
  for (const auto& [name, text] : touching_solids()) {
    for (const Vec3 eye : {Vec3{0.3, 0.9, 4}, Vec3{0.13, 0.17, 0.11}, Vec3{0, 1, 0.2}}) {
      if (!settings.full && ++number % 3 != 0 && number % 7 != 0) continue;
      all.add(judge(fmt::format("{} from {}", name, at(eye)),
                    room(8) + text + view(eye, {0.05, -0.1, -1}, 60, size), measures));
    }
  }
  return outcome(all, measures);
}

}  // namespace

void add_media_touching_rows(Rows& rows) {
  rows.push_back({"media.touching", "solids that share faces, touch or are the same", touching});
}

}  // namespace lancer::stress
