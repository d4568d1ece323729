#include "stress/subjects/standard.hpp"

#include <fmt/format.h>

#include "stress/subjects/script.hpp"

namespace lancer::stress {

std::string Standard::point(double x, double y, double z) const { return at(Vec3{x, y, z} * s + shift); }

std::string Standard::text(int size) const {
  std::string out = "settings { background rgb(0.1, 0.2, 0.4)  depth 6 }\n";
  out += fmt::format("plane {{ point {} normal y material {{ diffuse checker(white, 0.3, {}) }} }}\n",
                     point(0, 0, 0), 0.5 * s);
  out += fmt::format("sphere {{ {}, {} material {{ diffuse 0.7 specular 0.5 }} }}\n", point(0, 1, 0), s);
  out += fmt::format("box {{ {}, {} material {{ diffuse rgb(0.9, 0.3, 0.2) }} }}\n", point(1.25, 0, 0.5),
                     point(2.25, 1, -0.5));
  out +=
      fmt::format("cube {{ points {}, {}, {} material {{ diffuse rgb(0.2, 0.8, 0.3) reflection 0.2 }} }}\n",
                  point(-2, 0.25, 0.75), point(-1.25, 0.5, 1), point(-2.25, 1, 0.75));
  // Boxes and balls that are not along the axes have to be written around the origin.
  out += fmt::format(
      "sphere {{ <0, 0, 0>, 1 material {{ diffuse 0.6 }} scale {} rotate <20, 30, 40> translate {} }}\n",
      at(Vec3{0.75, 0.25, 0.5} * s), point(0.5, 0.5, 2));
  out += fmt::format("facet {{ {}, {}, {} material {{ diffuse 0.8 }} }}\n", point(-3, 0, -1),
                     point(-1, 0, -2), point(-2, 2.5, -1.5));
  out +=
      fmt::format("sphere {{ {}, {} material {{ diffuse 0.05 transmission 0.9 ior 1.5 fresnel true }} }}\n",
                  point(-0.75, 0.5, 2), 0.5 * s);
  out += fmt::format("plane {{ point {} normal <0.25, 0, 1> material {{ diffuse 0.1 reflection 0.7 }} }}\n",
                     point(0, 0, -4));
  out += fmt::format("light {{ at {} color 0.7 }}\n", point(-4, 6, 5));
  out += fmt::format("light {{ at {} color 0.3 }}\n", point(5, 3, 4));
  return out + view(Vec3{0.25, 1.5, 6} * s + shift, {0, 0, -1}, 53, size);
}

}  // namespace lancer::stress
