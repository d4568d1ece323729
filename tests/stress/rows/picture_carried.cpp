// A scene that is carried away as a whole, its view with it, shows the same picture.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "stress/random.hpp"
#include "stress/rows/rows.hpp"
#include "stress/subjects/script.hpp"
#include "stress/truth/reference/pictures.hpp"

namespace lancer::stress::carried {
namespace {

constexpr double k_limit = 1e-7;

std::string material(Random& random) {
  switch (random.below(4)) {
    case 0: return "material { diffuse 0.05 transmission 0.9 ior 1.5 fresnel true }";
    case 1: return "material { diffuse 0.1 reflection 0.8 }";
    case 2: return "material { diffuse checker(rgb(0.9, 0.2, 0.1), rgb(0.1, 0.3, 0.8), 0.7) reflection 0.2 }";
    default: return "material { diffuse rgb(0.2, 0.8, 0.4) specular 0.5 }";
  }
}

std::string turn(Random& random) {
  const Vec3 angles = random.in_cube(180), by = random.in_cube(2.5);
  return fmt::format("rotate {} translate {}", at(angles), at(by));
}

std::string thing(Random& random) {
  const std::string look = material(random), turned = turn(random);
  const Vec3 sizes{random.between(0.2, 1), random.between(0.2, 1), random.between(0.3, 1.2)};
  const Vec3 a = random.in_cube(2), b = random.in_cube(2), c = random.in_cube(2), center = random.in_cube(1);
  switch (random.below(4)) {
    case 0: return fmt::format("sphere {{ {}, {} {} }}\n", at(a), sizes.z, look);
    case 1:
      return fmt::format("sphere {{ <0, 0, 0>, 1 scale {} {} {} }}\n", at({sizes.x, sizes.y, 0.5}), turned,
                         look);
    case 2: return fmt::format("box {{ <-0.5, -0.4, -0.3>, <0.5, 0.4, 0.3> {} {} }}\n", turned, look);
    default:
      return fmt::format("group {{ facet {{ {}, {}, {} }} cube {{ center {} side 0.7 }} {} {} }}\n", at(a),
                         at(b), at(c), at(center), turned, look);
  }
}

/// Mirrors and glass about the origin, all of it in one group with the lights and the view.
std::string script(Random random, const std::string& carry, int size) {
  std::string out = "settings { background rgb(0.1, 0.2, 0.3) depth 6 }\ngroup {\n";
  for (int i = 0; i < 6; ++i) out += thing(random);
  out += fmt::format("plane {{ point <0, -3, 0> normal <0.1, 1, 0.05> {} }}\n", material(random));
  out += "light { at <5, 6, 3> color 0.8 }\nsun { direction <-1, -2, -1.5> color 0.4 }\n";
  out += fmt::format("view {{ eye {} look_at <0, 0, 0> fov 50 size {}, {} }}\n", at(random.direction() * 6),
                     size, size);
  return out + carry + " }\n";
}

Verdict compare(const std::string& name, const std::vector<Color>& here, const std::vector<Color>& there) {
  Verdict verdict;
  for (std::size_t i = 0; i < here.size(); ++i) {
    ++verdict.pixels;
    const double error = reference::difference(here[i], there[i]);
    if (error > k_limit) ++verdict.wrong;
    if (error <= verdict.worst) continue;
    verdict.worst = error;
    verdict.where = fmt::format("{}, pixel {}: {} for {}", name, i, there[i].r, here[i].r);
  }
  return verdict;
}

Outcome rows(const Settings& settings) {
  const std::pair<const char*, const char*> ways[] = {
      {"by 2^30", "translate <2^30, -3 * 2^28, 2^29>"},
      {"by 1e9", "translate <1e9, -3e9, 2e9>"},
      {"along y by 1e6", "translate <0, 1e6, 0>"},
      {"out, turned by quarters and out again",
       "translate <1e9, 0, 0> rotate <90, 180, 0> translate <0, 1e9, 0>"},
      {"and enlarged", "scale 1e9 translate <1e18, 0, -3e18>"},
  };
  Verdict all;
  for (std::uint64_t i = 0; i < (settings.full ? 200U : 4U); ++i) {
    const Random random(settings.seed, "picture.carried", i);
    const auto picture = [&](const char* carry) {
      const Script loaded(script(random, carry, settings.full ? 64 : 32));
      return drawn(loaded.scene, loaded.view);
    };
    const std::vector<Color> here = picture("");
    for (const auto& [name, carry] : ways) {
      all.add(compare(fmt::format("{} {}", i, name), here, picture(carry)));
    }
  }
  return outcome(all, {k_limit, {}, false});
}

}  // namespace
}  // namespace lancer::stress::carried

void lancer::stress::add_picture_carried_rows(Rows& rows) {
  rows.push_back(
      {"picture.carried", "mirrors and glass, carried away with the view: the same picture", carried::rows});
}
