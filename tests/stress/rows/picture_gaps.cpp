// Pictures of patterned planes that coincide or all but do.

#include <cmath>
#include <fmt/format.h>

#include "stress/rows/rows.hpp"
#include "stress/subjects/script.hpp"
#include "stress/truth/reference/pictures.hpp"

namespace lancer::stress {
namespace {

/// Two planes `gap` apart, in parts of the height that they are seen from, both of the same pattern kind.
std::string planes_apart(double gap, double height, double scale, const std::string& pattern, Vec3 normal,
                         int size) {
  const double level = height * 0.25 * scale;
  std::string out = "settings { background 0 ambient 1 }\n";
  const std::string cells = fmt::format(fmt::runtime(pattern), scale);
  out += fmt::format("plane {{ {}, {} material {{ ambient {} diffuse 0 }} }}\n", at(normal), level, cells);
  out += fmt::format("plane {{ {}, {} material {{ ambient 0.25 diffuse 0 }} }}\n", at(normal),
                     level - level * gap);
  return out + view(normal * ((0.25 + 0.5) * height * scale), {0.3, -0.1, -1}, 90, size);
}

Outcome gaps(const Settings& settings) {
  const int size = settings.full ? 96 : 32;
  Measures one, apart;
  one.tolerance.coincident = 1e-13;
  apart.tolerance.coincident = 2e-15;
  apart.excuse_near_things = true;
  Verdict all;
  for (const char* pattern : {"checker(0.9, 0.5, {})", "stripes(0.9, 0.5, <1, 0, 1>, {})",
                              "stripes(0.9, 0.5, <0.1, 0.7, 0.2>, {})"}) {
    for (const Vec3 normal : {Vec3{0, 1, 0}, Vec3{0.28, 0.96, 0}}) {
      for (const double height : {1e-3, 1.0, 40.0}) {
        for (const double scale : {1e-9, 1.0, 1e6}) {
          for (const double gap : {0.0, 1e-15, -1e-15, 1e-12, 1e-9, -1e-12}) {
            const Script script(planes_apart(gap, height, scale, pattern, normal, size));
            const std::string name = fmt::format("gap {} height {} scale {} {}", gap, height, scale, pattern);
            // Near enough for rounding they are one; far away from it, where their points have large
            // coordinates, rounding is larger.
            const bool near = std::fabs(gap) <= 1e-15;
            Verdict verdict = judge(name, script.scene, script.view, near ? one : apart);
            // Where rounding may make them one plane, they may be met in either order, but in one.
            if (near && gap != 0 && verdict.wrong > 0)
              verdict = judge(name, script.scene, script.view, apart);
            all.add(verdict);
          }
        }
      }
    }
  }
  return outcome(all, {});
}

}  // namespace

void add_picture_gaps_rows(Rows& rows) {
  rows.push_back({"picture.gaps", "patterned planes, coincident and nearly so: no speckle", gaps});
}

}  // namespace lancer::stress
