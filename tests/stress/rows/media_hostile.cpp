// Scripts that mean harm.

#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <stdexcept>

#include "stress/rows/rows.hpp"
#include "stress/truth/reference/pictures.hpp"

namespace lancer::stress {
namespace {

constexpr const char* k_lamp = "light { at <3, 4, 5> }\n";
constexpr const char* k_ball = "sphere { <0, 0, 0>, 1 material { diffuse 0.7 specular 0.3 } }\n";

std::string seen(int size) {
  return fmt::format("view {{ eye <0, 0.5, 5> look <0, -0.1, -1> fov 50 size {}, {}  }}\n", size, size);
}

/// Vectors of huge and tiny length.
void add_lengths(Scripts& scenes, int size) {
  const std::string lamp = k_lamp, ball = k_ball;
  for (const char* length : {"1e300", "1e-300", "1e160", "1e-160", "5e-324"}) {
    scenes.emplace_back(fmt::format("look of length {}", length),
                        ball + lamp +
                            fmt::format("view {{ eye <0, 0, 5> look <0, 0, -{}> fov 40 size {}, {} }}\n",
                                        length, size, size));
    scenes.emplace_back(
        fmt::format("normal of length {}", length),
        ball + lamp + fmt::format("plane {{ point <0, -1, 0> normal <0, {}, 0> }}\n", length) + seen(size));
    scenes.emplace_back(fmt::format("sun of length {}", length),
                        ball + fmt::format("sun {{ direction <-{0}, -{0}, -{0}> }}\n", length) + seen(size));
    scenes.emplace_back(
        fmt::format("stripes of length {}", length),
        fmt::format("sphere {{ <0, 0, 0>, 1 material {{ diffuse stripes(1, 0, <{0}, {0}, 0>, 0.1) }} }}\n",
                    length) +
            lamp + seen(size));
  }
}

/// Things of huge and tiny size.
void add_scales(Scripts& scenes, int size) {
  const std::string lamp = k_lamp, ball = k_ball;
  for (const char* s : {"1e-150", "1e-100", "1e100", "1e150", "1e-200", "1e200", "1e-290", "1e290"}) {
    scenes.emplace_back(
        fmt::format("scaled by {}", s),
        fmt::format("let s = {}\nsphere {{ <0, 0, 0>, s material {{ diffuse 0.7 }} }}\n"
                    "box {{ <s, -s, 0>, <1.5 * s, s, s> }}\nplane {{ y, -s }}\n"
                    "facet {{ <-s, -s, 0>, <-2 * s, -s, 0>, <-s, s, s> }}\n"
                    "light {{ at <3 * s, 4 * s, 5 * s> }}\n"
                    "view {{ eye <0, 0.5 * s, 5 * s> look <0, -0.1, -1> fov 50 size {}, {} }}\n",
                    s, size, size));
    scenes.emplace_back(fmt::format("a plane of level {}", s),
                        ball + lamp + fmt::format("plane {{ y, -{} }}\n", s) + seen(size));
    scenes.emplace_back(fmt::format("a lamp at {}", s),
                        ball + fmt::format("light {{ at <{}, {}, {}> falloff 1 }}\n", s, s, s) + seen(size));
    scenes.emplace_back(
        fmt::format("an ellipsoid of {}", s),
        lamp + fmt::format("sphere {{ <0, 0, 0>, 1 scale <1, {}, 1> rotate <1, 2, 3> }}\n", s) + seen(size));
  }
}

/// No area, no room, no number to be small against.
void add_degenerate(Scripts& scenes, int size) {
  const std::string lamp = k_lamp, ball = k_ball;
  scenes.emplace_back("facets without an area",
                      lamp +
                          "mesh { points [<0,0,0>, <1,0,0>, <0,1,0>, <2,0,0>] faces "
                          "[[0,1,2],[0,1,3],[1,1,1],[0,0,2]] smooth true }\n" +
                          seen(size));
  scenes.emplace_back("facets of hardly any",
                      lamp +
                          "facet { <0,0,0>, <1,1e-300,0>, <1,0,1e-300> }\nfacet { <-1,0,0>, <1,0,0>, "
                          "<0,1e-16,0> }\nfacet { <0,0,0>, <1e-200,0,0>, <0,1e-200,0> }\n" +
                          ball + seen(size));
  scenes.emplace_back(
      "a flat box",
      lamp + "box { <-1, -1, 0>, <1, 1, 5e-324> }\nbox { <-2, -1, 1>, <-1, 1, 1.0000000000000002> }\n" +
          seen(size));
  scenes.emplace_back("a lamp on a surface",
                      ball + "light { at <0, 0, 1> falloff 1 }\nlight { at <0, 0, 0> }\n" + seen(size));
  scenes.emplace_back("an eye on a surface", ball + lamp + "plane { y, 0.5 }\n" + seen(size));
  scenes.emplace_back("no light comes through",
                      "settings { ior 1e-300 }\nsphere { <0, 0, 0>, 1 material { transmission 1 ior 1e300 "
                      "fresnel true } }\n" +
                          lamp + seen(size));
  scenes.emplace_back("glass of 1e300",
                      "settings { ior 1e300 }\nsphere { <0, 0, 0>, 1 material { transmission 1 ior 1e-300 "
                      "fresnel true } }\n" +
                          lamp + seen(size));
  scenes.emplace_back("glaring",
                      "settings { ambient 1e200 background 1e308 }\nsphere { <0, 0, 0>, 1 material { diffuse "
                      "1e200 specular 1e308 shininess 1e300 reflection 1e10 transmission 1e10 } }\n" +
                          lamp + seen(size));
  scenes.emplace_back(
      "a narrow view",
      ball + lamp +
          fmt::format("view {{ eye <0, 0, 5> look <0, 0, -1> fov 1e-300 size {}, {} }}\n", size, size));
  scenes.emplace_back(
      "a wide view",
      ball + lamp +
          fmt::format("view {{ eye <0, 0, 5> look <0, 0, -1> fov 179.99999999999997 size {}, {} }}\n", size,
                      size));
}

Scripts hostile_scripts(int size) {
  Scripts scenes;
  add_lengths(scenes, size);
  add_scales(scenes, size);
  add_degenerate(scenes, size);
  return scenes;
}

Outcome hostile(const Settings& settings) {
  const Scripts scenes = hostile_scripts(settings.full ? 32 : 12);
  Measure measure = measure_in_use("pixels");
  std::uint64_t no_numbers = 0;
  int refused = 0;
  Outcome out;
  for (const auto& [name, text] : scenes) {
    std::optional<Script> loaded;
    try {
      loaded.emplace(text);
    } catch (const std::runtime_error&) {
      ++refused;  // with a message, which is an answer too
      continue;
    }
    const Script& script = *loaded;
    for (const Color& c : drawn(script.scene, script.view))
      no_numbers += std::isnan(c.r + c.g + c.b) || c.r < 0 ? 1 : 0;
    Measures measures;
    const Verdict verdict = judge(name, script.scene, script.view, measures);
    measure.rays += verdict.pixels;
    measure.wrong += verdict.wrong;
    measure.in_band += verdict.in_band;
    if (verdict.wrong > verdict.in_band) out.note += verdict.where + "; ";
  }
  if (refused > 0) out.note += fmt::format("{} of {} scripts are refused", refused, scenes.size());
  out.measures.push_back(measure);
  out.limits = {{"pixels that are no number", static_cast<double>(no_numbers), 0},
                {"wrong pixels", static_cast<double>(measure.wrong - measure.in_band), 0}};
  return out;
}

}  // namespace

void add_media_hostile_rows(Rows& rows) {
  rows.push_back(
      {"media.hostile", "huge and tiny numbers, no area, no length: no pixel is no number", hostile});
}

}  // namespace lancer::stress
