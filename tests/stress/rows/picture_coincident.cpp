// Pictures of surfaces that coincide.

#include "stress/rows/rows.hpp"
#include "stress/subjects/script.hpp"
#include "stress/truth/reference/pictures.hpp"

namespace lancer::stress {
namespace {

/// Two things that coincide, and how both are turned.
struct Pair {
  std::string name, a, b, turned;
};

std::vector<Pair> coincident_pairs() {
  const auto object = [](const std::string& kind, const std::string& numbers) {
    return kind + " { " + numbers + " ";
  };
  return {
      {"box on plane", object("box", "<-0.7, -0.6, -3.1>, <1.4, 0.5, -4.0>"),
       object("plane", "<0, 0, -1>, 3.1"), ""},
      {"box in box", object("box", "<-1, -1, -1>, <1, 1, 1>"),
       object("box", "<-0.3, -0.4, -0.5>, <0.6, 0.7, 1>"), ""},
      {"turned box in box", object("box", "<-1.1, -1.3, -0.9>, <1, 1, 0.7>"),
       object("box", "<-0.3, -0.4, -0.5>, <0.6, 0.7, 0.7>"), k_oblique},
      {"boxes side by side", object("box", "<-1.1, -1.3, -0.9>, <0.1, 1, 0.7>"),
       object("box", "<0.1, -1.3, -0.9>, <1.3, 0.6, 0.7>"), k_oblique},
      {"a cube by points on a box", object("cube", "<-0.5, -0.5, 1>, <0.5, -0.5, 1>, <-0.5, 0.5, 1>"),
       object("box", "<-1, -1, -1>, <1, 1, 1>"), k_oblique},
      {"spheres", object("sphere", "<0.1, 0.2, -0.3>, 1.1"), object("sphere", "<0.1, 0.2, -0.3>, 1.1"), ""},
      {"turned spheres", object("sphere", "<0.1, 0.2, -0.3>, 1.1"), object("sphere", "<0.1, 0.2, -0.3>, 1.1"),
       k_oblique},
      {"facets in a plane", object("facet", "<-1.5, -1.1, 0.2>, <1.3, -0.7, 0.2>, <0.1, 1.3, 0.2>"),
       object("facet", "<-1.4, 0.9, 0.2>, <0.3, -1.2, 0.2>, <1.5, 1.1, 0.2>"), k_oblique},
      {"facet on an oblique plane", object("facet", "<1, 0, 0>, <0, 1, 0>, <0, 0, 1>"),
       object("plane", "<1, 1, 1>, 0.5773502691896258"), ""},
      {"facet on a box", object("facet", "<-0.9, -0.7, 1>, <0.8, -0.9, 1>, <0.2, 0.9, 1>"),
       object("box", "<-1, -1, -1>, <1, 1, 1>"), k_oblique},
      {"planes", object("plane", "<1, 2, 3>, 0.3"), object("plane", "<0.1, 0.2, 0.3>, 0.3"), ""},
      {"planes by points", object("plane", "point <0.3, 0.1, 0.2> normal <0.3, -0.1, 0.7>"),
       object("plane", "points <0.3, 0.1, 0.2>, <0.4, 0.4, 0.2>, <1, 0.1, -0.1>"), ""}};
}

Outcome coincident(const Settings& settings) {
  const int size = settings.full ? 128 : 40;
  const std::string red = "material { ambient rgb(9, 2, 1) diffuse 0 }",
                    blue = "material { ambient rgb(1, 3, 8) diffuse 0 }";
  Measures measures;
  Scripts scripts;
  for (const Pair& pair : coincident_pairs()) {
    for (const bool swapped : {false, true}) {
      const std::string first = (swapped ? pair.b : pair.a) + red,
                        second = (swapped ? pair.a : pair.b) + blue;
      const std::string both = first + pair.turned + " }\n" + second + pair.turned + " }\n";
      scripts.emplace_back(pair.name, "settings { background 0.1 }\n" + both +
                                          view({2, 1.5, 5.3}, {-0.38, -0.28, -1}, 35, size));
      // The same, each turned by itself in other steps that come to the same.
      if (pair.turned.empty()) continue;
      scripts.emplace_back(
          pair.name + ", grouped",
          "settings { background 0.1 }\n" + first + pair.turned + " }\ngroup { " + second +
              "rotate <31, 17, 53> } scale 0.7 translate <0.1, 0, -0.2> translate <0, 0.3, 0> }\n" +
              view({2, 1.5, 5.3}, {-0.38, -0.28, -1}, 35, size));
    }
  }
  return outcome(scripts, measures);
}

}  // namespace

void add_picture_coincident_rows(Rows& rows) {
  rows.push_back({"picture.coincident", "coincident surfaces of all kinds: one colour", coincident});
}

}  // namespace lancer::stress
