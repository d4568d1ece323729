// Light through media: solids in, across, beside and upon each other, angles about the critical one, long
// ways within glass, energy that must come back whole, and input that means harm.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "stress/random.hpp"
#include "stress/reference/pictures.hpp"
#include "tracer/media.hpp"
#include "tracer/shade.hpp"

namespace lancer::stress {
namespace {

/// Scripts and what they are called.
using Named = std::vector<std::pair<std::string, std::string>>;

std::string at(Vec3 p) { return fmt::format("<{}, {}, {}>", p.x, p.y, p.z); }

/// A solid about the origin, two units wide, without the closing brace.
struct Solid {
  std::string name, begin, turn;

  /// Scaled, moved and clad.
  std::string placed(double scale, Vec3 to, double ior) const {
    return fmt::format(
        "{} {} scale {} translate {} material {{ ambient 0.05 diffuse 0 transmission rgb(0.9, 0.8, 0.95) ior "
        "{} "
        "fresnel true }} }}\n",
        begin, turn, scale, at(to), ior);
  }
};

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

/// An opaque room with light that differs from place to place.
std::string room(int depth) {
  return fmt::format(
      "settings {{ background 0.1 ambient 1 depth {} }}\n"
      "sphere {{ <0, 0, 0>, 40 material {{ ambient gradient(rgb(0.9, 0.1, 0.5), rgb(0.1, 0.8, 0.3), <-9, "
      "-30, -30>, "
      "<9, 30, 30>) diffuse 0 }} }}\n",
      depth);
}

std::string view(Vec3 eye, Vec3 look, double fov, int size) {
  return fmt::format("view {{ eye {} look {} fov {} size {}, {} }}\n", at(eye), at(look), fov, size, size);
}

constexpr double k_indices[][2] = {{1.5, 1.2}, {1.2, 1.5}, {1.5, 0.8}, {1.5, 1.5}};

/// Pairs of all kinds: one in the other, across it, beside it; the eye outside, between and within.
Outcome pairs(const Settings& settings, double inner, Vec3 to) {
  const int size = settings.full ? 48 : 10;
  Measures measures{1e-12, {}, true};
  Verdict all;
  int number = 0;
  for (const Solid& a : solids()) {
    for (const Solid& b : solids()) {
      for (const auto& index : k_indices) {
        ++number;
        if (!settings.full && number % 4 != (number / 20) % 4) continue;
        for (const Vec3 eye :
             {Vec3{0.3, 0.2, 4}, to + Vec3{0.11, 0.07, 0.13} * inner, Vec3{-0.45, -0.3, 0.2}}) {
          const std::string name = fmt::format("{} of {} and {} of {} at {} from {}", a.name, index[0],
                                               b.name, index[1], at(to), at(eye));
          all.add(judge(name,
                        room(5) + a.placed(1, {}, index[0]) + b.placed(inner, to, index[1]) +
                            view(eye, {0.05, 0.03, -1}, 60, size),
                        measures));
        }
      }
    }
  }
  return outcome(all, measures);
}

/// Solids that share faces, touch or are the same.
Named touching_solids() {
  const std::string clear = "material { ambient 0 diffuse 0 transmission 0.95 ior ";
  const auto glass = [&](const std::string& shape, double ior, const std::string& turn = "") {
    return fmt::format("{} {}{} }} {} }}\n", shape, clear, ior, turn);
  };
  const std::string cube_mesh =
      "mesh { points [<-1,-1,-1>, <1,-1,-1>, <-1,1,-1>, <1,1,-1>, <-1,-1,1>, <1,-1,1>, <-1,1,1>, <1,1,1>] "
      "faces "
      "[[0,2,1],[1,2,3],[4,5,6],[5,7,6],[0,1,4],[1,5,4],[2,6,3],[3,6,7],[0,4,2],[2,4,6],[1,3,5],[3,7,5]] "
      "solid true";
  const std::string cube = "box { <-1, -1, -1>, <1, 1, 1>";
  const std::string turn = "rotate <31, 17, 53> scale 0.7 translate <0.1, 0.3, -0.2>";
  Named scenes;
  for (const auto& [one, two] : {std::pair{1.5, 1.2}, {1.2, 1.5}, {1.5, 1.5}, {0.7, 1.3}}) {
    for (const std::string& turned : {std::string{}, turn}) {
      scenes.emplace_back("cube twice", glass(cube, one, turned) + glass(cube, two, turned));
      scenes.emplace_back("cube and mesh", glass(cube, one, turned) + glass(cube_mesh, two, turned));
      scenes.emplace_back("mesh and cube", glass(cube_mesh, one, turned) + glass(cube, two, turned));
      scenes.emplace_back("side by side", glass("box { <-1, -1, -1>, <0.1, 1, 1>", one, turned) +
                                              glass("box { <0.1, -1, -1>, <1.2, 1, 1>", two, turned));
      scenes.emplace_back("one upon the other",
                          glass("box { <-1, -1, -1>, <1, 0.1, 1>", one, turned) +
                              glass("box { <-0.7, 0.1, -0.7>, <0.7, 1, 0.7>", two, turned));
      scenes.emplace_back(
          "in a corner", glass(cube, one, turned) + glass("box { <-0.3, -0.2, 0.1>, <1, 1, 1>", two, turned));
      scenes.emplace_back("ball twice", glass("sphere { <0, 0, 0>, 1", one, turned) +
                                            glass("sphere { <0, 0, 0>, 1", two, turned));
      scenes.emplace_back("ball in a cube",
                          glass(cube, one, turned) + glass("sphere { <0, 0, 0>, 1", two, turned));
      scenes.emplace_back("ball on a cube",
                          glass(cube, one, turned) + glass("sphere { <0.2, 2, 0.1>, 1", two, turned));
      scenes.emplace_back("three slabs", glass("box { <-1, -1, -1>, <-0.3, 1, 1>", one, turned) +
                                             glass("box { <-0.3, -1, -1>, <0.3, 1, 1>", two, turned) +
                                             glass("box { <0.3, -1, -1>, <1, 1, 1>", one, turned));
    }
    scenes.emplace_back("water to the ground", glass("plane { y, 0", one) + glass("plane { y, -0.4", two));
    scenes.emplace_back("water twice", glass("plane { y, 0", one) + glass("plane { <0, 2, 0>, 0", two));
  }
  return scenes;
}

Outcome touching(const Settings& settings) {
  const int size = settings.full ? 64 : 16;
  Measures measures;
  measures.limit = 1e-14;
  Verdict all;
  int number = 0;
  for (const auto& [name, text] : touching_solids()) {
    for (const Vec3 eye : {Vec3{0.3, 0.9, 4}, Vec3{0.13, 0.17, 0.11}, Vec3{0, 1, 0.2}}) {
      if (!settings.full && ++number % 3 != 0 && number % 7 != 0) continue;
      all.add(judge(fmt::format("{} from {}", name, at(eye)),
                    room(8) + text + view(eye, {0.05, -0.1, -1}, 60, size), measures));
    }
  }
  return outcome(all, measures);
}

// --- The critical angle

/// A ray in glass that arrives at its boundary, a plane.
struct Arrival {
  Vec3 normal, direction;
  double from = 1, to = 1;
};

struct Critical {
  std::uint64_t rays = 0, wrong = 0, in_band = 0;
  double reflectance = 0, direction = 0;  // the largest errors beyond what 4 ulp of the angle account for
};

reference::Vector nudged(const reference::Vector& d, const reference::Vector& n,
                         const reference::Real& part) {
  // Only the angle: longer or shorter along the surface.
  const reference::Vector up = n * dot(d, n);
  const reference::Vector along = d - up;
  const reference::Real sine = length(along) * (1 + part);
  if (sine >= 1) return d;
  return unit(along) * sine + unit(up) * sqrt(1 - sine * sine);
}

void arrive(const Arrival& a, Critical& out) {
  scene::Scene scene;
  scene.settings.ior = a.to;
  scene::Material glass;
  glass.ambient.color = glass.diffuse.color = {};
  glass.transmission.color = grey(1);
  glass.ior = a.from;
  glass.fresnel = true;
  scene.materials.push_back(glass);
  scene.planes.push_back({{}, a.normal, 0});
  scene::Shape shape;
  shape.kind = scene::ShapeKind::plane;
  scene.shapes.push_back(shape);
  const tracer::World world = tracer::prepare(scene);
  const tracer::Plan plan;
  tracer::Stats stats;
  tracer::Ray ray{-a.direction, a.direction, 0, {}, {}};
  ray.open.push_back(0);
  tracer::Hit hit;
  ++out.rays;
  if (!tracer::closest(world, ray, stats, hit)) {
    ++out.wrong;
    return;
  }
  const tracer::Shaded mine = tracer::shade({&world, &plan, nullptr}, ray, hit, true, stats);
  const reference::Vector n = -unit(reference::exact(a.normal)), d = unit(reference::exact(a.direction));
  const reference::Optics truth = optics(d, n, a.from, a.to);
  const reference::Real part = reference::Real(4) * 0x1p-52;
  const reference::Optics more = optics(nudged(d, n, part), n, a.from, a.to),
                          less = optics(nudged(d, n, -part), n, a.from, a.to);
  const bool band = more.total != less.total;
  if (!mine.transmitted != truth.total) {
    ++out.wrong;
    out.in_band += band ? 1 : 0;
    return;
  }
  if (!mine.reflected) {
    ++out.wrong;
    return;
  }
  const auto beyond = [](const reference::Real& value, const reference::Real& wanted,
                         const reference::Real& a_side, const reference::Real& b_side) {
    const reference::Real spread =
        std::max(reference::Real(abs(a_side - wanted)), reference::Real(abs(b_side - wanted)));
    return reference::Real(abs(value - wanted) - spread).convert_to<double>();
  };
  // Under total reflection all of T comes from the mirror direction too.
  const double share = mine.reflected->share.r;
  out.reflectance =
      std::max(out.reflectance, beyond(share, truth.reflectance, more.reflectance, less.reflectance));
  const auto compare = [&](Vec3 got, const reference::Vector& wanted, const reference::Vector& p,
                           const reference::Vector& q) {
    for (int axis = 0; axis < 3; ++axis)
      out.direction = std::max(out.direction, beyond(got[axis], wanted[axis], p[axis], q[axis]));
  };
  compare(mine.reflected->ray.direction, truth.mirrored, more.mirrored, less.mirrored);
  if (mine.transmitted && !band)
    compare(mine.transmitted->ray.direction, truth.refracted, more.refracted, less.refracted);
}

Outcome critical(const Settings& settings) {
  const std::pair<double, double> indices[] = {{1.5, 1},      {1.33, 1},   {2.4, 1.5},
                                               {1.5, 1.4999}, {1.0003, 1}, {2, 1}};
  Critical all;
  for (const auto& [from, to] : indices) {
    for (int k = 3; k <= 17; ++k) {
      for (int i = 0; i < (settings.full ? 2000 : 60); ++i) {
        Random random(settings.seed, "media.critical", static_cast<std::uint64_t>(k * 100000 + i));
        Arrival a;
        a.from = from;
        a.to = to;
        a.normal = i % 3 == 0 ? Vec3{0, 0, 1} : random.direction();
        const double off = k == 17 ? 0 : (i % 2 == 0 ? 1 : -1) * std::pow(10.0, -k) * random.between(0.5, 2);
        const reference::Vector n = unit(reference::exact(a.normal));
        const reference::Vector along = unit(cross(n, reference::exact(random.direction())));
        reference::Real sine = reference::Real(to) / from * (1 + reference::Real(off));
        if (sine > 1) sine = 1 - reference::Real("1e-9");
        const reference::Vector d = along * sine + n * sqrt(1 - sine * sine);
        a.direction =
            normalize({d.x.convert_to<double>(), d.y.convert_to<double>(), d.z.convert_to<double>()});
        arrive(a, all);
      }
    }
  }
  Outcome out;
  Measure measure;
  measure.method = "reflect or refract";
  measure.in_use = true;
  measure.rays = all.rays;
  measure.wrong = all.wrong;
  measure.in_band = all.in_band;
  out.measures.push_back(measure);
  out.limits = {{"wrong about total reflection", static_cast<double>(all.wrong - all.in_band), 0},
                {"reflectance beyond the band", all.reflectance, 1e-15},
                {"direction beyond the band", all.direction, 4e-16}};
  return out;
}

// --- Long ways

/// What happened along a way: which surfaces were met, how, and with what open.
struct Step {
  std::size_t body = 0;
  bool entering = false, through = false;
  std::vector<std::size_t> open;
  reference::Vector direction, point;

  bool same_course(const Step& other) const {
    return body == other.body && entering == other.entering && through == other.through && open == other.open;
  }
};

/// Goes through where `through` says so and it can, else is mirrored.
using Choice = std::function<bool(int step)>;

std::vector<Step> true_way(const reference::Tracer& tracer, const scene::Scene& scene, reference::Ray ray,
                           int steps, const Choice& choice) {
  std::vector<Step> way;
  reference::Meeting met;
  for (int i = 0; i < steps && tracer.closest(ray, met); ++i) {
    const scene::Material& m = scene.materials[scene.shapes[met.body].material];
    const std::vector<std::size_t> beyond = tracer.crossed(ray, met);
    const reference::Vector n = met.entering ? met.normal : -met.normal;
    const reference::Optics to = optics(unit(ray.direction), n, tracer.index(ray.open), tracer.index(beyond));
    const bool through = !is_black(m.transmission.color) && !to.total && choice(i);
    ray = tracer.onwards(met, through ? to.refracted : to.mirrored, through ? beyond : ray.open);
    way.push_back({met.body, met.entering, through, ray.open, ray.direction, met.point});
  }
  return way;
}

std::vector<Step> lancers_way(const scene::Scene& scene, Vec3 origin, Vec3 direction, int steps,
                              const Choice& choice) {
  const tracer::World world = tracer::prepare(scene);
  const tracer::Plan plan;
  tracer::Stats stats;
  tracer::Ray ray{origin, direction, 0, {}, {}};
  ray.open = tracer::open_at(world, tracer::solids_around(world, origin), origin, direction, stats);
  std::vector<Step> way;
  tracer::Hit hit;
  for (int i = 0; i < steps && tracer::closest(world, ray, stats, hit); ++i) {
    tracer::Shaded shaded = tracer::shade({&world, &plan, nullptr}, ray, hit, true, stats);
    const bool through = shaded.transmitted && choice(i);
    if (!through && !shaded.reflected) break;
    ray = through ? shaded.transmitted->ray : shaded.reflected->ray;
    Step step{hit.shape,
              hit.root.entering,
              through,
              {},
              reference::exact(ray.direction),
              reference::exact(hit.point)};
    for (const std::uint32_t shape : ray.open) step.open.push_back(shape);
    way.push_back(step);
  }
  return way;
}

/// Glass that sends some of the light back everywhere.
std::string half_glass(double ior) {
  return fmt::format("material {{ ambient 0 diffuse 0 reflection 0.2 transmission 0.7 ior {} }} }}\n", ior);
}

/// Solids with flat faces, in which small errors stay small.
Named rooms_of_cubes() {
  const std::string turn = "rotate <31, 17, 53> scale 0.7 translate <0.1, 0.3, -0.2> ";
  // A room of mirrors, so that no way ends.
  const std::string begin =
      "box { <-3, -2.5, -2>, <2.5, 3, 2.2> material { ambient 0 diffuse 0 reflection 1 } }\n";
  const std::string cube = "box { <-1, -1, -1>, <1, 1, 1> ";
  return {{"cube", begin + cube + half_glass(1.5)},
          {"turned cube", begin + cube + turn + half_glass(1.5)},
          {"cube in a cube",
           begin + cube + half_glass(1.5) + "box { <-0.5, -0.6, -0.4>, <0.3, 0.2, 0.7> " + half_glass(1.2)},
          {"turned cubes across", begin + cube + turn + half_glass(1.5) + cube +
                                      "rotate <5, 50, 7> translate <0.4, 0.2, 0.1> " + half_glass(1.3)},
          {"cubes side by side", begin + "box { <-1, -1, -1>, <0.1, 1, 1> " + turn + half_glass(1.5) +
                                     "box { <0.1, -1, -1>, <1, 1, 1> " + turn + half_glass(1.2)},
          {"cube twice", begin + cube + turn + half_glass(1.5) + cube + turn + half_glass(1.2)},
          {"cube and mesh",
           begin + cube + half_glass(1.5) +
               "mesh { points [<0.9,0,0>, <-1,0,0>, <0,0.8,0>, <0,-1,0>, <0,0,1>, <0,0,-0.7>] faces [[0,2,4],"
               "[2,1,4],[1,3,4],[3,0,4],[2,0,5],[1,2,5],[3,1,5],[0,3,5]] solid true " +
               half_glass(1.1)}};
}

/// On how many first steps do the ways agree?
std::size_t same_steps(const std::vector<Step>& a, const std::vector<Step>& b) {
  std::size_t same = 0;
  while (same < a.size() && same < b.size() && a[same].same_course(b[same])) ++same;
  return same;
}

/// What became of all ways.
struct Ways {
  std::uint64_t count = 0, wrong = 0, in_band = 0;
  double direction = 0, place = 0;  // the largest errors of those with the right course
  std::string where;
};

/// Both go the same way, from o along d.
void compare_ways(const std::string& name, const scene::Scene& scene, const reference::Tracer& truth, Vec3 o,
                  Vec3 d, const Choice& choice, Ways& all) {
  constexpr int k_bounces = 40;
  const auto true_from = [&](const reference::Vector& direction) {
    return true_way(truth, scene, truth.from_eye(reference::exact(o), direction), k_bounces, choice);
  };
  const std::vector<Step> mine = lancers_way(scene, o, d, k_bounces, choice);
  const std::vector<Step> wanted = true_from(reference::exact(d));
  const std::size_t same = same_steps(mine, wanted);
  ++all.count;
  if (same < k_bounces) {
    // Would a slightly other start have gone another way too?
    bool band = false;
    for (int k = 0; k < 6; ++k) {
      reference::Vector other = reference::exact(d);
      other[k / 2] += k % 2 == 0 ? 1e-14 : -1e-14;
      band = band || same_steps(true_from(other), wanted) <= same;
    }
    ++all.wrong;
    all.in_band += band ? 1 : 0;
    if (!band) all.where = fmt::format("wrong: {}, bounce {}, from {} along {}", name, same, at(o), at(d));
    return;
  }
  for (std::size_t k = 0; k < same; ++k) {
    const auto apart = [](const reference::Vector& a, const reference::Vector& b) {
      return largest(a - b).convert_to<double>();
    };
    all.direction = std::max(all.direction, apart(mine[k].direction, unit(wanted[k].direction)));
    all.place = std::max(all.place, apart(mine[k].point, wanted[k].point));
  }
}

Outcome bounces(const Settings& settings) {
  Ways all;
  for (const auto& [name, text] : rooms_of_cubes()) {
    const Script script(text + view({0, 0, 0}, {0, 0, -1}, 60, 4));
    const reference::Tracer truth(script.scene);
    for (int i = 0; i < (settings.full ? 4000 : 120); ++i) {
      Random random(settings.seed, name, static_cast<std::uint64_t>(i));
      const Vec3 o = random.in_cube(0.6), d = random.direction();
      const std::uint64_t way = random.bits();
      // Every other one stays inside as long as it can.
      const Choice choice = [&](int step) {
        return i % 2 == 1 && (mix(way + static_cast<std::uint64_t>(step)) & 1) == 1;
      };
      compare_ways(name, script.scene, truth, o, d, choice, all);
    }
  }
  Measure measure;
  measure.method = "ways of forty bounces";
  measure.in_use = true;
  measure.rays = all.count;
  measure.wrong = all.wrong;
  measure.in_band = all.in_band;
  Outcome out;
  out.measures.push_back(measure);
  out.limits = {{"ways with other surfaces or open solids", static_cast<double>(all.wrong - all.in_band), 0},
                {"direction", all.direction, 1e-12},
                {"place", all.place, 1e-10}};
  out.note = all.where;
  return out;
}

// --- Energy

/// Surfaces that return all that they get.
Named furnaces() {
  const std::string glass = "material { ambient 0 diffuse 0 transmission 1 ior 1.5 fresnel true } }\n";
  const std::string half = "material { ambient 0 diffuse 0 reflection 0.25 transmission 0.75 } }\n";
  const std::string bubble = "material { ambient 0 diffuse 0 transmission 1 ior 0.67 fresnel true } }\n";
  Named scenes = {
      {"mirror ball", "sphere { <0, 0, 0>, 1 material { ambient 0 diffuse 0 reflection 1 } }\n"},
      {"mirror box in a corner of mirrors",
       "box { <-1, -1, -1>, <1, 1, 1> rotate <10, 20, 30> material { ambient 0 diffuse 0 reflection 1 } }\n"
       "plane { y, -1.6 material { ambient 0 diffuse 0 reflection 1 } }\n"
       "plane { x, -1.9 material { ambient 0 diffuse 0 reflection 1 } }\n"}};
  for (const Solid& solid : solids()) {
    const std::string begin = solid.begin + " " + solid.turn + " ";
    scenes.emplace_back("glass " + solid.name, begin + glass);
    scenes.emplace_back("half-silvered " + solid.name, begin + half);
    scenes.emplace_back("thin " + solid.name, begin + bubble);
  }
  return scenes;
}

Outcome furnace(const Settings& settings) {
  const int size = settings.full ? 64 : 16;
  double worst = 0, cut = 0, at_depth = 0;
  Measure measure;
  measure.method = "white pixels";
  measure.in_use = true;
  Outcome out;
  for (const auto& scene : furnaces()) {
    const std::string &name = scene.first, &text = scene.second;
    const auto script = [&](int depth) {
      return Script(fmt::format("settings {{ background 1 ambient 0 depth {} }}\n", depth) + text +
                    view({0.3, 0.4, 4}, {-0.06, -0.1, -1}, 40, size));
    };
    const Script whole = script(100000);
    double here = 0;
    for (const Color& c : drawn(whole.scene, whole.view)) {
      ++measure.rays;
      here = std::max(here, reference::difference(c, grey(1)));
      if (!(std::fabs(c.r - 1) <= 1e-12)) ++measure.wrong;
    }
    if (here > worst) out.note = "largest error: " + name;
    worst = std::max(worst, here);
    // Cut off early: what is missing is what was not followed.
    const Script early = script(5);
    Measures measures;
    measures.limit = 1e-12;
    const Verdict verdict = judge(name, early.scene, early.view, measures);
    at_depth = std::max(at_depth, verdict.worst);
    for (const Color& c : drawn(early.scene, early.view)) cut = std::max(cut, c.r - 1);
  }
  out.measures.push_back(measure);
  out.limits = {{"energy", worst, 1e-12},
                {"energy more than whole, cut off at depth 5", cut, 1e-12},
                {"energy cut off at depth 5", at_depth, 1e-12}};
  return out;
}

// --- Hostile input

/// Huge and tiny numbers, no area, no length.
Named hostile_scripts(int size) {
  const std::string lamp = "light { at <3, 4, 5> }\n";
  const auto seen = [&](const std::string& more = "") {
    return "view { eye <0, 0.5, 5> look <0, -0.1, -1> fov 50 size " +
           fmt::format("{}, {} {} }}\n", size, size, more);
  };
  const std::string ball = "sphere { <0, 0, 0>, 1 material { diffuse 0.7 specular 0.3 } }\n";
  Named scenes;
  for (const char* length : {"1e300", "1e-300", "1e160", "1e-160", "5e-324"}) {
    scenes.emplace_back(fmt::format("look of length {}", length),
                        ball + lamp +
                            fmt::format("view {{ eye <0, 0, 5> look <0, 0, -{}> fov 40 size {}, {} }}\n",
                                        length, size, size));
    scenes.emplace_back(
        fmt::format("normal of length {}", length),
        ball + lamp + fmt::format("plane {{ point <0, -1, 0> normal <0, {}, 0> }}\n", length) + seen());
    scenes.emplace_back(fmt::format("sun of length {}", length),
                        ball + fmt::format("sun {{ direction <-{0}, -{0}, -{0}> }}\n", length) + seen());
    scenes.emplace_back(
        fmt::format("stripes of length {}", length),
        fmt::format("sphere {{ <0, 0, 0>, 1 material {{ diffuse stripes(1, 0, <{0}, {0}, 0>, 0.1) }} }}\n",
                    length) +
            lamp + seen());
  }
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
                        ball + lamp + fmt::format("plane {{ y, -{} }}\n", s) + seen());
    scenes.emplace_back(fmt::format("a lamp at {}", s),
                        ball + fmt::format("light {{ at <{}, {}, {}> falloff 1 }}\n", s, s, s) + seen());
    scenes.emplace_back(
        fmt::format("an ellipsoid of {}", s),
        lamp + fmt::format("sphere {{ <0, 0, 0>, 1 scale <1, {}, 1> rotate <1, 2, 3> }}\n", s) + seen());
  }
  scenes.emplace_back("facets without an area",
                      lamp +
                          "mesh { points [<0,0,0>, <1,0,0>, <0,1,0>, <2,0,0>] faces "
                          "[[0,1,2],[0,1,3],[1,1,1],[0,0,2]] smooth true }\n" +
                          seen());
  scenes.emplace_back("facets of hardly any",
                      lamp +
                          "facet { <0,0,0>, <1,1e-300,0>, <1,0,1e-300> }\nfacet { <-1,0,0>, <1,0,0>, "
                          "<0,1e-16,0> }\nfacet { <0,0,0>, <1e-200,0,0>, <0,1e-200,0> }\n" +
                          ball + seen());
  scenes.emplace_back(
      "a flat box",
      lamp + "box { <-1, -1, 0>, <1, 1, 5e-324> }\nbox { <-2, -1, 1>, <-1, 1, 1.0000000000000002> }\n" +
          seen());
  scenes.emplace_back("a lamp on a surface",
                      ball + "light { at <0, 0, 1> falloff 1 }\nlight { at <0, 0, 0> }\n" + seen());
  scenes.emplace_back("an eye on a surface", ball + lamp + "plane { y, 0.5 }\n" + seen());
  scenes.emplace_back("no light comes through",
                      "settings { ior 1e-300 }\nsphere { <0, 0, 0>, 1 material { transmission 1 ior 1e300 "
                      "fresnel true } }\n" +
                          lamp + seen());
  scenes.emplace_back("glass of 1e300",
                      "settings { ior 1e300 }\nsphere { <0, 0, 0>, 1 material { transmission 1 ior 1e-300 "
                      "fresnel true } }\n" +
                          lamp + seen());
  scenes.emplace_back("glaring",
                      "settings { ambient 1e200 background 1e308 }\nsphere { <0, 0, 0>, 1 material { diffuse "
                      "1e200 specular 1e308 shininess 1e300 reflection 1e10 transmission 1e10 } }\n" +
                          lamp + seen());
  scenes.emplace_back(
      "a narrow view",
      ball + lamp +
          fmt::format("view {{ eye <0, 0, 5> look <0, 0, -1> fov 1e-300 size {}, {} }}\n", size, size));
  scenes.emplace_back(
      "a wide view",
      ball + lamp +
          fmt::format("view {{ eye <0, 0, 5> look <0, 0, -1> fov 179.99999999999997 size {}, {} }}\n", size,
                      size));
  return scenes;
}

Outcome hostile(const Settings& settings) {
  const Named scenes = hostile_scripts(settings.full ? 32 : 12);
  Measure measure;
  measure.method = "pixels";
  measure.in_use = true;
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

void add_media_rows(Rows& rows) {
  rows.push_back({"media.nested", "solids in solids of other indices", [](const Settings& s) {
                    return pairs(s, 0.5, {0.05, -0.04, 0.03});
                  }});
  rows.push_back({"media.overlapping", "solids that overlap", [](const Settings& s) {
                    return pairs(s, 0.8, {0.9, 0.3, -0.2});
                  }});
  rows.push_back({"media.touching", "solids that share faces, touch or are the same", touching});
  rows.push_back({"media.critical", "total reflection within 1e-3 to 1e-16 of the critical angle", critical});
  rows.push_back(
      {"media.bounces", "forty bounces in cubes of glass: surfaces, open solids, directions", bounces});
  rows.push_back({"media.furnace", "white all around stays white", furnace});
  rows.push_back(
      {"media.hostile", "huge and tiny numbers, no area, no length: no pixel is no number", hostile});
}

}  // namespace lancer::stress
