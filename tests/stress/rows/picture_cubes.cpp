// Pictures of cubes along their edges, corners and sides.

#include <fmt/format.h>

#include "stress/rows/rows.hpp"
#include "stress/subjects/script.hpp"
#include "stress/truth/reference/pictures.hpp"

namespace lancer::stress {
namespace {

/// The cube [-1, 1]^3, or a part of it: as a box, or as twelve facets.
std::string cube(bool facets, Vec3 lo, Vec3 hi, const std::string& material, const std::string& turned) {
  if (!facets) return fmt::format("box {{ {}, {} {} {} }}\n", at(lo), at(hi), material, turned);
  const int faces[6][4] = {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1},
                           {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}};
  std::string out = "group {\n";
  for (const auto& face : faces) {
    Vec3 p[4];
    for (int i = 0; i < 4; ++i)
      p[i] = {face[i] & 1 ? hi.x : lo.x, face[i] & 2 ? hi.y : lo.y, face[i] & 4 ? hi.z : lo.z};
    out += fmt::format("facet {{ {}, {}, {} {} }}\n", at(p[0]), at(p[2]), at(p[1]), material);
    out += fmt::format("facet {{ {}, {}, {} {} }}\n", at(p[0]), at(p[3]), at(p[2]), material);
  }
  return out + turned + " }\n";
}

Outcome cubes(const Settings& settings) {
  // An odd size puts a column of pixels right on the middle line.
  const int size = settings.full ? 129 : 33;
  Scripts scripts;
  const std::string lamp = "settings { background 0.2 ambient 0.3 }\nlight { at <30, 41, -22> color 0.8 }\n";
  for (const bool facets : {false, true}) {
    const std::string kind = facets ? " as facets" : " as a box";
    for (const char* material : {"material { diffuse 0.9 }", "material { ambient 1 diffuse 0 }"}) {
      const auto solid = [&](const std::string& turned) {
        return lamp + cube(facets, {-1, -1, -1}, {1, 1, 1}, material, turned);
      };
      scripts.emplace_back("edge-on" + kind,
                           solid("") + view({5, 0, -5}, {-1, 0, 1}, 28.072486935852957, size));
      scripts.emplace_back("corner-on" + kind, solid("") + view({5, 5, -5}, {-1, -1, 1}, 22.62, size));
      scripts.emplace_back("side through the eye" + kind,
                           lamp + cube(facets, {0, -1, -1}, {1, 1, 1}, material, "") +
                               view({0, 0, 4}, {0, 0, -1}, 53.13010235415598, size));
      scripts.emplace_back("turned to an edge" + kind,
                           solid("rotate <0, 45, 0>") + view({0, 0, 7}, {0, 0, -1}, 28, size));
      scripts.emplace_back("turned to a corner" + kind, solid("rotate <45, 35.264389682754654, 0>") +
                                                            view({0, 0, 7}, {0, 0, -1}, 28, size));
      scripts.emplace_back("turned and turned" + kind,
                           solid("rotate <13, 0, 0> rotate <0, 77, 0> rotate <5, 6, 7> "
                                 "scale <1, 0.25, 0.5> translate <0.1, 0.2, 0.3>") +
                               view({1, 2, 7}, {-0.1, -0.25, -1}, 28, size));
    }
  }
  return outcome(scripts, Measures{});
}

}  // namespace

void add_picture_cubes_rows(Rows& rows) {
  rows.push_back(
      {"picture.cubes", "cubes, as boxes and as facets, seen along edges, corners and sides", cubes});
}

}  // namespace lancer::stress
