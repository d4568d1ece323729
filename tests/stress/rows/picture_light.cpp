// Pictures of light on its way: grazing the ground, between mirrors, through glass.

#include <cmath>
#include <fmt/format.h>

#include "stress/rows/rows.hpp"
#include "stress/subjects/script.hpp"
#include "stress/truth/reference/pictures.hpp"

namespace lancer::stress {
namespace {

Outcome grazing(const Settings& settings) {
  Scripts scripts;
  for (int k = 0; k <= 9; k += settings.full ? 1 : 3) {
    const double height = std::pow(10.0, 2 - k);
    scripts.emplace_back(
        fmt::format("light {} above the ground", height),
        fmt::format(
            "settings {{ background 0 ambient 1 shadows \"opaque\" }}\nlight {{ at <-1000, {}, 300> }}\n"
            "plane {{ y, 0 material {{ ambient 0 diffuse {} }} }}\n"
            "sphere {{ <0, 1, 0>, 1 material {{ ambient 0.5 diffuse 0.3 }} }}\n"
            "sphere {{ <0, 0, 0>, 1 material {{ ambient 0.4 diffuse 0.2 }} scale <1, 0.25, 0.5> translate "
            "<2, 0.25, 1> }}\n",
            height, 1000 / height) +
            view({0, 1.5, 6}, {0, 0, -1}, 36.86989764584402, settings.full ? 128 : 48));
  }
  return outcome(scripts, k_near_excused);
}

Outcome mirrors(const Settings& settings) {
  Measures measures;
  measures.limit = 1e-14;
  Scripts scripts;
  for (const double slant : {10.0, 30.0, 51.3}) {
    scripts.emplace_back(
        fmt::format("hall, slant {}", slant),
        "settings { background 0 ambient 1 depth 400 }\n"
        "plane { <0, 0, -1>, 0 material { ambient 0 diffuse 0 reflection 0.99 } }\n"
        "plane { <0, 0, -1>, 1 material { ambient 0 diffuse 0 reflection 0.99 } }\n"
        "plane { <1, 0, 0>, 1 material { ambient 1 diffuse 0 } }\n"
        "plane { <1, 0, 0>, -1 material { ambient 0.5 diffuse 0 } }\n" +
            view({0, 0, -0.5}, {1, 0, -slant}, 14.250032697803595, settings.full ? 96 : 32, "up y"));
  }
  return outcome(scripts, measures);
}

Outcome glass(const Settings& settings) {
  Measures measures;
  measures.limit = 1e-14;
  Scripts scripts;
  for (const double s : {1e-9, 1e-4, 1.0, 1e4, 1e9}) {
    const std::string behind = fmt::format(
        "plane {{ <0.3, 0.2, -1>, {} material {{ ambient gradient(0.9, 0.2, {}, {}) diffuse 0 }} }}\n"
        "sphere {{ {}, {} material {{ ambient 0.3 diffuse 0 }} }}\n",
        6.5 * s, at(Vec3{-20, -20, 0} * s), at(Vec3{20, 20, 0} * s), at(Vec3{0.3, 0.2, -3} * s), 0.5 * s);
    const std::string clear = "material { ambient 0 diffuse 0 transmission 1 ior 1.5 }";
    const std::string begin = "settings { background 0.1 ambient 1 depth 60 shadows \"opaque\" }\n" + behind;
    const int size = settings.full ? 128 : 32;
    scripts.emplace_back(fmt::format("in a glass ball, scale {}", s),
                         begin + fmt::format("sphere {{ <0, 0, 0>, {} {} }}\n", s, clear) +
                             view(Vec3{0.6, 0, 0} * s, {0, 0, -1}, 79.6, size));
    scripts.emplace_back(fmt::format("through a glass ball, scale {}", s),
                         begin +
                             fmt::format("sphere {{ {}, {} {} }}\n", at(Vec3{0.01, 0.02, 0} * s), s, clear) +
                             view(Vec3{0, 0, 5} * s, {0, 0, -1}, 25.6, size));
    scripts.emplace_back(fmt::format("in a glass cube, scale {}", s),
                         begin +
                             fmt::format("box {{ {}, {} {} rotate <10, 20, 30> }}\n",
                                         at(Vec3{-1, -1, -1} * s), at(Vec3{1, 1, 1} * s), clear) +
                             view(Vec3{0.4, 0.1, 0.2} * s, {0, 0, -1}, 79.6, size));
    scripts.emplace_back(
        fmt::format("in a glass ellipsoid, scale {}", s),
        begin +
            fmt::format("sphere {{ <0, 0, 0>, {} {} scale <1, 0.7, 1.2> rotate <10, 20, 30> }}\n", s, clear) +
            view(Vec3{0.4, 0.1, 0.2} * s, {0, 0, -1}, 79.6, size));
  }
  return outcome(scripts, measures);
}

}  // namespace

void add_picture_light_rows(Rows& rows) {
  rows.push_back({"picture.grazing", "a ball on the ground in ever lower light", grazing});
  rows.push_back({"picture.mirrors", "a hall of mirrors, fifty and more bounces", mirrors});
  rows.push_back({"picture.glass", "inside glass and through it, at all scales", glass});
}

}  // namespace lancer::stress
