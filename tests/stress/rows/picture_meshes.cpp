// Pictures of meshes of which each pixel is seen through a corner or an edge.

#include <fmt/format.h>

#include "stress/rows/rows.hpp"
#include "stress/subjects/script.hpp"
#include "stress/truth/reference/pictures.hpp"

namespace lancer::stress {
namespace {

/// A square of n x n cells of two facets, in which each pixel of an n x n picture looks at a corner or the
/// middle of an edge.
std::string cells(int n, bool corners, double slope, double scale, double away, bool solid_mesh) {
  std::string points, faces;
  for (int j = 0; j <= n + 1; ++j) {
    for (int i = 0; i <= n + 1; ++i) {
      const double x = (i - (n + 1) * 0.5) * scale, y = (j - (n + 1) * 0.5) * scale;
      points += fmt::format("{}, ", at({x + away, y + away, (slope * (i + 2 * j)) * scale}));
      if (i > n || j > n) continue;
      const int a = j * (n + 2) + i;
      faces += fmt::format("[{}, {}, {}], [{}, {}, {}], ", a, a + 1, a + n + 3, a, a + n + 3, a + n + 2);
    }
  }
  const double shift = corners ? 0 : 0.5;
  std::string out = "settings { background 0 ambient 1 }\n";
  out += fmt::format("mesh {{ points [{}] faces [{}] {} material {{ ambient 1 diffuse 0 }} }}\n", points,
                     faces, solid_mesh ? "smooth true" : "");
  return out + fmt::format("view {{ eye {} look <0, 0, -1> width {} size {}, {} }}\n",
                           at({away + shift * scale, away, 400 * scale}), n * scale, n, n);
}

Outcome meshes(const Settings& settings) {
  const int n = settings.full ? 64 : 16;
  Verdict all;
  for (const bool corners : {true, false}) {
    for (const double slope : {0.0, 0.25, 0.37}) {
      for (const double scale : {1.0, 1e-4, 0x1p-10}) {
        for (const double away : {0.0, 1e5 * scale}) {
          const std::string name =
              fmt::format("{} slope {} scale {} moved {}", corners ? "corners" : "edges", slope, scale, away);
          const Script script(cells(n, corners, slope, scale, away, false));
          // Everything is seen in the same light: what is not 1 is a hole.
          Verdict verdict;
          const std::vector<Color> seen = drawn(script.scene, script.view);
          for (const Color& c : seen) {
            ++verdict.pixels;
            if (c.r == 1) continue;
            ++verdict.wrong;
            verdict.worst = 1;
            verdict.where = name;
          }
          all.add(verdict);
        }
      }
    }
  }
  return outcome(all, {});
}

}  // namespace

void add_picture_meshes_rows(Rows& rows) {
  rows.push_back({"picture.meshes", "facets met at corners and edges: no holes", meshes});
}

}  // namespace lancer::stress
