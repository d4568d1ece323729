// Pictures of every kind of shape at all scales and places, and from afar.

#include <cmath>
#include <fmt/format.h>

#include "stress/rows/rows.hpp"
#include "stress/subjects/script.hpp"
#include "stress/subjects/standard.hpp"
#include "stress/truth/reference/pictures.hpp"

namespace lancer::stress {
namespace {

Outcome scales(const Settings& settings) {
  Scripts scripts;
  for (int k = -9; k <= 9; k += settings.full ? 1 : 3) {
    scripts.emplace_back(fmt::format("scale 1e{}", k),
                         Standard{std::pow(10.0, k), {}}.text(settings.full ? 128 : 40));
  }
  return outcome(scripts, k_near_excused);
}

Outcome moved(const Settings& settings) {
  const int size = settings.full ? 128 : 40;
  Scripts scripts;
  for (int k = 3; k <= 9; k += settings.full ? 1 : 3) {
    const Vec3 away = Vec3{1, -0.75, -0.5} * std::pow(10.0, k);
    scripts.emplace_back(fmt::format("moved by 1e{}", k), Standard{1, away}.text(size));
    std::string grouped = Standard{}.text(size);
    const std::size_t first = grouped.find("plane"), view_at = grouped.find("view {");
    grouped = grouped.substr(0, first) + "group {\n" + grouped.substr(first, view_at - first) +
              fmt::format("translate {} }}\n", at(away)) +
              view(Vec3{0.25, 1.5, 6} + away, {0, 0, -1}, 53, size);
    scripts.emplace_back(fmt::format("a group moved by 1e{}", k), grouped);
  }
  return outcome(scripts, k_near_excused);
}

/// A shape about the origin, one unit in size, from afar along `way`, filling most of the picture.
std::string from_afar(double distance, Vec3 way, const std::string& shape, int size) {
  const double fov = 2 * std::atan(1.6 / distance) * 57.29577951308232;
  return "settings { background 0 ambient 0.1 }\n" + shape + "light { at <3, 4, 5> }\n" +
         view(way * distance, -way, fov, size);
}

Outcome far(const Settings& settings) {
  const std::pair<const char*, const char*> shapes[] = {
      {"sphere", "sphere { <0.0123, -0.0317, 0>, 1 material { diffuse 0.9 } }\n"},
      {"glowing sphere", "sphere { <0.0123, -0.0317, 0>, 1 material { ambient 9 diffuse 0 } }\n"},
      {"ellipsoid",
       "sphere { <0, 0, 0>, 1 scale <1.2, 0.5, 0.8> rotate <10, 20, 30> material { diffuse 0.9 } }\n"},
      {"turned box",
       "box { <-0.7, -0.6, -0.5>, <0.7, 0.6, 0.5> rotate <25, 35, 10> material { diffuse 0.9 } }\n"},
      {"facet", "facet { <-1, -0.5, 0.1>, <1, -0.6, -0.1>, <0.1, 1, 0> material { diffuse 0.9 } }\n"}};
  Scripts scripts;
  for (int k = 1; k <= 9; k += settings.full ? 1 : 2) {
    for (const auto& [name, shape] : shapes) {
      const int size = settings.full ? 128 : 32;
      const double distance = std::pow(10.0, k);
      scripts.emplace_back(fmt::format("{} from 1e{}", name, k), from_afar(distance, {0, 0, 1}, shape, size));
      scripts.emplace_back(fmt::format("{} from 1e{} aslant", name, k),
                           from_afar(distance, {0.48, 0.6, 0.64}, shape, size));
    }
  }
  return outcome(scripts, k_near_excused);
}

}  // namespace

void add_picture_places_rows(Rows& rows) {
  rows.push_back({"picture.scales", "every kind, scaled by 1e-9 to 1e9", scales});
  rows.push_back({"picture.moved", "every kind, moved by 1e3 to 1e9 sizes", moved});
  rows.push_back({"picture.far", "every kind, seen from 1e1 to 1e9 sizes", far});
}

}  // namespace lancer::stress
