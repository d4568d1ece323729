// Long ways within glass: which surfaces are met, what is open, and where the ray goes.

#include <algorithm>
#include <fmt/format.h>
#include <functional>

#include "stress/random.hpp"
#include "stress/rows/rows.hpp"
#include "stress/subjects/script.hpp"
#include "stress/truth/reference/pictures.hpp"
#include "tracer/media.hpp"
#include "tracer/shade.hpp"

namespace lancer::stress {
namespace {

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
Scripts rooms_of_cubes() {
  const std::string turn = std::string(k_oblique) + " ";
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
  Outcome out;
  out.measures.push_back(measure_in_use("ways of forty bounces", all.count, all.wrong, all.in_band));
  out.limits = {{"ways with other surfaces or open solids", static_cast<double>(all.wrong - all.in_band), 0},
                {"direction", all.direction, 1e-12},
                {"place", all.place, 1e-10}};
  out.note = all.where;
  return out;
}

}  // namespace

void add_media_bounces_rows(Rows& rows) {
  rows.push_back(
      {"media.bounces", "forty bounces in cubes of glass: surfaces, open solids, directions", bounces});
}

}  // namespace lancer::stress
