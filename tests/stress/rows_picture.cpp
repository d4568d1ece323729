// Pictures against the truth: a scene of every kind at all scales, places and distances, and those in which
// surfaces coincide, touch or are seen along their edges.

#include <cmath>
#include <fmt/format.h>

#include "stress/reference/pictures.hpp"
#include "tracer/render.hpp"

namespace lancer::stress {
namespace {

/// Numbers as they are written in a script.
std::string at(Vec3 p) { return fmt::format("<{}, {}, {}>", p.x, p.y, p.z); }

std::string view(Vec3 eye, Vec3 look, double fov, int size, const std::string& more = "") {
  return fmt::format("view {{ eye {} look {} fov {} size {}, {} {} }}\n", at(eye), at(look), fov, size, size,
                     more);
}

/// A scene of every kind, about six units wide; each point p of it stands at p s + shift.
struct Standard {
  double s = 1;
  Vec3 shift;

  std::string point(double x, double y, double z) const { return at(Vec3{x, y, z} * s + shift); }

  std::string text(int size) const {
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
};

Verdict judge_all(const std::vector<std::pair<std::string, std::string>>& scripts, const Measures& measures) {
  Verdict all;
  for (const auto& [name, text] : scripts) all.add(judge(name, text, measures));
  return all;
}
using Scripts = std::vector<std::pair<std::string, std::string>>;

constexpr Measures k_near{1e-7, {}, true};

Outcome scales(const Settings& settings) {
  Scripts scripts;
  for (int k = -9; k <= 9; k += settings.full ? 1 : 3) {
    scripts.emplace_back(fmt::format("scale 1e{}", k),
                         Standard{std::pow(10.0, k), {}}.text(settings.full ? 128 : 40));
  }
  return outcome(judge_all(scripts, k_near), k_near);
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
  return outcome(judge_all(scripts, k_near), k_near);
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
  return outcome(judge_all(scripts, k_near), k_near);
}

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
  return outcome(judge_all(scripts, {}), {});
}

Outcome coincident(const Settings& settings) {
  const int size = settings.full ? 128 : 40;
  const std::string red = "material { ambient rgb(9, 2, 1) diffuse 0 }",
                    blue = "material { ambient rgb(1, 3, 8) diffuse 0 }";
  const std::string turn = "rotate <31, 17, 53> scale 0.7 translate <0.1, 0.3, -0.2>";
  struct Pair {
    std::string name, a, b, turned;
  };
  const auto object = [](const std::string& kind, const std::string& numbers) {
    return kind + " { " + numbers + " ";
  };
  const std::vector<Pair> pairs = {
      {"box on plane", object("box", "<-0.7, -0.6, -3.1>, <1.4, 0.5, -4.0>"),
       object("plane", "<0, 0, -1>, 3.1"), ""},
      {"box in box", object("box", "<-1, -1, -1>, <1, 1, 1>"),
       object("box", "<-0.3, -0.4, -0.5>, <0.6, 0.7, 1>"), ""},
      {"turned box in box", object("box", "<-1.1, -1.3, -0.9>, <1, 1, 0.7>"),
       object("box", "<-0.3, -0.4, -0.5>, <0.6, 0.7, 0.7>"), turn},
      {"boxes side by side", object("box", "<-1.1, -1.3, -0.9>, <0.1, 1, 0.7>"),
       object("box", "<0.1, -1.3, -0.9>, <1.3, 0.6, 0.7>"), turn},
      {"a cube by points on a box", object("cube", "<-0.5, -0.5, 1>, <0.5, -0.5, 1>, <-0.5, 0.5, 1>"),
       object("box", "<-1, -1, -1>, <1, 1, 1>"), turn},
      {"spheres", object("sphere", "<0.1, 0.2, -0.3>, 1.1"), object("sphere", "<0.1, 0.2, -0.3>, 1.1"), ""},
      {"turned spheres", object("sphere", "<0.1, 0.2, -0.3>, 1.1"), object("sphere", "<0.1, 0.2, -0.3>, 1.1"),
       turn},
      {"facets in a plane", object("facet", "<-1.5, -1.1, 0.2>, <1.3, -0.7, 0.2>, <0.1, 1.3, 0.2>"),
       object("facet", "<-1.4, 0.9, 0.2>, <0.3, -1.2, 0.2>, <1.5, 1.1, 0.2>"), turn},
      {"facet on an oblique plane", object("facet", "<1, 0, 0>, <0, 1, 0>, <0, 0, 1>"),
       object("plane", "<1, 1, 1>, 0.5773502691896258"), ""},
      {"facet on a box", object("facet", "<-0.9, -0.7, 1>, <0.8, -0.9, 1>, <0.2, 0.9, 1>"),
       object("box", "<-1, -1, -1>, <1, 1, 1>"), turn},
      {"planes", object("plane", "<1, 2, 3>, 0.3"), object("plane", "<0.1, 0.2, 0.3>, 0.3"), ""},
      {"planes by points", object("plane", "point <0.3, 0.1, 0.2> normal <0.3, -0.1, 0.7>"),
       object("plane", "points <0.3, 0.1, 0.2>, <0.4, 0.4, 0.2>, <1, 0.1, -0.1>"), ""}};
  Measures measures;
  Scripts scripts;
  for (const Pair& pair : pairs) {
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
  return outcome(judge_all(scripts, measures), measures);
}

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
  return outcome(judge_all(scripts, k_near), k_near);
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
  return outcome(judge_all(scripts, measures), measures);
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
  return outcome(judge_all(scripts, measures), measures);
}

/// Pixels whose bits differ.
std::uint64_t other_bits(const image::Image& a, const image::Image& b) {
  std::uint64_t count = a.data().size() == b.data().size() ? 0 : 1;
  for (std::size_t i = 0; i < a.data().size() && i < b.data().size(); ++i)
    count += a.data()[i] == b.data()[i] ? 0 : 1;
  return count;
}

Outcome bits(const Settings& settings) {
  const int size = settings.full ? 128 : 48;
  tracer::Options options;
  options.samples = settings.full ? 4 : 1;
  const auto picture = [&](double s, int threads) {
    const Script script(Standard{s, {}}.text(size));
    options.threads = threads;
    return tracer::render(script.scene, script.view, options).image;
  };
  const image::Image plain = picture(1, 1);
  Outcome out;
  for (const int k : {-100, -40, -10, -1, 1, 10, 40, 100}) {
    out.limits.push_back({fmt::format("pixels changed by 2^{}", k),
                          static_cast<double>(other_bits(plain, picture(std::ldexp(1.0, k), 1))), 0});
  }
  for (const int threads : {2, 7}) {
    out.limits.push_back({fmt::format("pixels changed by {} threads", threads),
                          static_cast<double>(other_bits(plain, picture(1, threads))), 0});
  }
  return out;
}

}  // namespace

void add_picture_rows(Rows& rows) {
  rows.push_back({"picture.scales", "every kind, scaled by 1e-9 to 1e9", scales});
  rows.push_back({"picture.moved", "every kind, moved by 1e3 to 1e9 sizes", moved});
  rows.push_back({"picture.far", "every kind, seen from 1e1 to 1e9 sizes", far});
  rows.push_back(
      {"picture.cubes", "cubes, as boxes and as facets, seen along edges, corners and sides", cubes});
  rows.push_back({"picture.coincident", "coincident surfaces of all kinds: one colour", coincident});
  rows.push_back({"picture.gaps", "patterned planes, coincident and nearly so: no speckle", gaps});
  rows.push_back({"picture.meshes", "facets met at corners and edges: no holes", meshes});
  rows.push_back({"picture.grazing", "a ball on the ground in ever lower light", grazing});
  rows.push_back({"picture.mirrors", "a hall of mirrors, fifty and more bounces", mirrors});
  rows.push_back({"picture.glass", "inside glass and through it, at all scales", glass});
  rows.push_back(
      {"picture.bits", "the same bits when scaled by powers of two and by any number of threads", bits});
}

}  // namespace lancer::stress
