#include "stress/subjects/glass.hpp"

#include <fmt/format.h>

#include "stress/subjects/script.hpp"

namespace lancer::stress {

std::string Solid::placed(double scale, Vec3 to, double ior) const {
  return fmt::format(
      "{} {} scale {} translate {} material {{ ambient 0.05 diffuse 0 transmission rgb(0.9, 0.8, 0.95) ior "
      "{} "
      "fresnel true }} }}\n",
      begin, turn, scale, at(to), ior);
}

const std::vector<Solid>& solids() {
  static const std::vector<Solid> all = {
      {"sphere", "sphere { <0, 0, 0>, 1", ""},
      {"ellipsoid", "sphere { <0, 0, 0>, 1", "scale <1, 0.7, 1.2> rotate <10, 20, 30>"},
      {"box", "box { <-1, -0.9, -0.8>, <0.8, 0.9, 1>", ""},
      {"turned box", "box { <-1, -0.9, -0.8>, <0.8, 0.9, 1>", "rotate <20, 40, 10>"},
      {"mesh",
       "mesh { points [<1,0,0>, <-1,0,0>, <0,1,0>, <0,-1,0>, <0,0,1>, <0,0,-1>] "
       "faces [[0,2,4],[2,1,4],[1,3,4],[3,0,4],[2,0,5],[1,2,5],[3,1,5],[0,3,5]] solid true",
       "scale 1.3 rotate <5, 10, 15>"}};
  return all;
}

std::string room(int depth) {
  return fmt::format(
      "settings {{ background 0.1 ambient 1 depth {} }}\n"
      "sphere {{ <0, 0, 0>, 40 material {{ ambient gradient(rgb(0.9, 0.1, 0.5), rgb(0.1, 0.8, 0.3), <-9, "
      "-30, -30>, "
      "<9, 30, 30>) diffuse 0 }} }}\n",
      depth);
}

}  // namespace lancer::stress
