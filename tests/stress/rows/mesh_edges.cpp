// Hits exactly on the edges and diagonals of a cube of facets, and all that goes on from there.

#include <fmt/format.h>
#include <limits>

#include "stress/contest/judgement.hpp"
#include "stress/contest/line.hpp"
#include "stress/rows/rows.hpp"
#include "stress/subjects/placement.hpp"
#include "stress/truth/way_out.hpp"
#include "tracer/build.hpp"
#include "tracer/media.hpp"
#include "tracer/shadow.hpp"

namespace lancer::stress::flat {
namespace {

constexpr std::uint32_t k_cube = 0;

/// The cube [-1, 1]^3 as a solid mesh of twelve facets, of glass that keeps half.
struct FacetCube {
  Affine map;
  scene::Scene scene;
  tracer::World world;

  explicit FacetCube(const Affine& placed) : map(placed) {
    tracer::test::add_mesh(scene, tracer::test::cube_mesh(true), tracer::test::clear(0.5, 1), map);
    world = tracer::prepare(scene);
  }
};

/// A ray that meets the cube at `at`, in its own space.
struct Arrival {
  Vec3 at, way;
  bool inside = false;  // it starts within

  /// Does a direction lead into the cube from there?
  bool goes_in(Vec3 d) const {
    for (int i = 0; i < 3; ++i) {
      if (std::fabs(at[i]) == 1 && !(d[i] * at[i] < -1e-3)) return false;
    }
    return true;
  }

  bool runs_in_a_side() const {
    for (int i = 0; i < 3; ++i) {
      if (std::fabs(at[i]) == 1 && way[i] == 0) return true;
    }
    return false;
  }
};

/// Exactly through an edge or corner, in numbers that are exact.
Arrival at_rim(Random& random, bool inside) {
  Arrival out;
  out.inside = inside;
  for (int i = 0; i < 3; ++i) out.at[i] = random.sign();
  const int axis = random.below(3);
  for (int i = 0; i < 3; ++i) out.way[i] = -out.at[i];
  out.way[axis] = (random.below(9) - 4) / 4.0;
  if (random.below(3) > 0) out.at[axis] = (random.below(15) - 7) / 8.0;
  if (inside) out.way = -out.way;
  // Within, the start is half a step back.
  if (inside && std::fabs(out.at[axis] - out.way[axis] / 2) >= 1) out.way[axis] = 0;
  if (inside && std::fabs(out.at[axis]) == 1) out.way[axis] = out.at[axis];
  return out;
}

/// Exactly through a diagonal of a side or what would be the other one.
Arrival at_diagonal(Random& random, bool inside) {
  Arrival out;
  out.inside = inside;
  const int axis = random.below(3), j = (axis + 1) % 3, k = (axis + 2) % 3;
  const double side = random.sign(), place = (random.below(13) - 6) / 8.0;
  out.at[axis] = side;
  out.at[j] = place;
  out.at[k] = place * random.sign();
  out.way[axis] = inside ? side : -side;
  if (random.below(2) == 0) out.way[j] = random.below(2) / 16.0;
  return out;
}

/// Next to the edge only.
Arrival near_rim(Random& random, bool inside) {
  Arrival out = at_rim(random, inside);
  const double far = random.between(2, 4);
  const Vec3 from = inside ? random.in_cube(0.5) : out.at * far + random.in_ball() * 0.5;
  out.way = (out.at - from) * (inside ? 2 : 0.5);  // as of the others, the start is half or two steps back
  return out;
}

Vec3 onwards(Random& random, const tracer::Ray& ray, Vec3 normal, int sort) {
  const Vec3 d = random.direction();
  if (sort == 0) return normalize(ray.direction - normal * (2 * dot(ray.direction, normal)));
  if (sort == 1) return ray.direction;
  if (sort > 2) return d;
  return normalize(d - normal * dot(d, normal) + normal * (random.sign() * 1e-6));  // all but along it
}

double light(const FacetCube& cube, const tracer::Ray& ray) {
  tracer::Stats stats;
  return light_through(cube.world, tracer::ShadowWork::filtered, ray, std::numeric_limits<double>::infinity(),
                       stats)
      .r;
}

/// From where a ray met the cube: nothing outwards, the far side inwards, and the light that comes that way.
void go_on(Judgement& judgement, const char* set, const FacetCube& cube, const Arrival& arrival,
           const tracer::Hit& hit, Vec3 d) {
  tracer::Ray ray = ray_from(cube.world, hit, d);
  const bool outwards = dot(d, hit.normal) > 0;
  if (!outwards) ray.open.push_back(k_cube);
  const auto text = [&] { return "going on, " + told(ray.origin, ray.direction); };
  tracer::Stats stats;
  tracer::Hit next;
  if (outwards) {
    judgement.check_start(closest(cube.world, ray, stats, next), set, text);
    judgement.check(light(cube, ray) == 1, set, text);
  } else if (arrival.goes_in(inverse(cube.map)->vector(d))) {
    const bool found = closest(cube.world, ray, stats, next);
    if (!judgement.check(found && !next.root.entering && next.root.t > 1e-4, set, text)) return;
    judgement.add_distance(ulps(next.root.t, farthest_facet(cube.world, ray.origin, ray.direction).t));
    judgement.check(light(cube, ray) == 0.5, set, text);
  }
}

void visit(Judgement& judgement, const char* set, const FacetCube& cube, const Arrival& arrival,
           Random& random) {
  tracer::Ray ray;
  ray.origin = cube.map.point(arrival.at - arrival.way * (arrival.inside ? 0.5 : 2));
  const bool exact = cube.map == Affine{};
  ray.direction = normalize(exact ? arrival.way : cube.map.point(arrival.at) - ray.origin);
  if (arrival.inside) ray.open.push_back(k_cube);
  const auto text = [&] { return told(ray.origin, ray.direction); };
  tracer::Stats stats;
  tracer::Hit hit;
  const bool found = closest(cube.world, ray, stats, hit);
  // Past the edge, for rounding or as a ray does that runs beside the plane of a side.
  if (!found && (!exact || arrival.runs_in_a_side())) return;
  if (!judgement.check(found && hit.root.entering != arrival.inside, set, text)) return;
  if (exact && (arrival.inside || arrival.goes_in(arrival.way)))
    judgement.check(light(cube, ray) == (arrival.inside ? 0.5 : 0.25), set, text);
  for (int sort = 0; sort < 6; ++sort)
    go_on(judgement, set, cube, arrival, hit, onwards(random, ray, hit.normal, sort));
}

/// An open mesh of two sheets: from the front of the lower to the back of the upper.
void between_sheets(Judgement& judgement, const Settings& settings) {
  scene::Scene scene;
  scene::Mesh sheets;
  sheets.points = {{-2, 0, -2}, {2, 0, -2}, {0, 0, 2}, {-2, 1, -2}, {2, 1, -2}, {0, 1, 2}};
  sheets.faces = {{0, 2, 1}, {3, 5, 4}};
  tracer::test::add_mesh(scene, sheets);
  const tracer::World world = tracer::prepare(scene);
  for (std::uint64_t i = 0; i < 500; ++i) {
    Random random(settings.seed, "mesh.edges/sheets", i);
    const auto way = [&](double up) {
      const Vec3 aside = random.in_cube(0.3);
      return normalize(Vec3{aside.x, up, aside.z});
    };
    tracer::Ray ray;
    ray.origin = Vec3{0, 0.5, -0.3} + random.in_cube(0.3);
    ray.direction = way(-1);
    tracer::Stats stats;
    tracer::Hit hit, next;
    const bool found = closest(world, ray, stats, hit) &&
                       closest(world, ray_from(world, hit, way(1)), stats, next) &&
                       next.root.entering == false && hit.root.entering;
    judgement.check(found, "sheets", [&] { return told(ray.origin, ray.direction); });
  }
}

Outcome edges(const Settings& settings) {
  const std::uint64_t cubes = settings.full ? 300 : 12, rays = settings.full ? 400 : 60;
  Judgement judgement;
  struct Sort {
    const char* name;
    bool moved;
    Arrival (*make)(Random&, bool);
  };
  for (const Sort& sort : {Sort{"at the rim", false, at_rim}, Sort{"at a diagonal", false, at_diagonal},
                           Sort{"next to the rim", true, near_rim}}) {
    for (std::uint64_t i = 0; i < cubes; ++i) {
      Random random(settings.seed, std::string("mesh.edges/") + sort.name, i);
      const Affine map = sort.moved ? turned(random, i % 2 == 0 ? 9 : 9e4) : Affine{};
      const FacetCube cube(map);
      for (std::uint64_t ray = 0; ray < rays; ++ray) {
        const Arrival arrival = sort.make(random, random.below(2) == 0);
        visit(judgement, sort.name, cube, arrival, random);
      }
    }
  }
  between_sheets(judgement, settings);
  return judgement.outcome();
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_mesh_edges_rows(Rows& rows) {
  rows.push_back({"mesh.edges",
                  "hits exactly on edges and diagonals of a cube, and all that goes on from there",
                  flat::edges});
}
