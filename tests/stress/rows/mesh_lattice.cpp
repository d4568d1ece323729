// Solids built of unit cubes, as one closed mesh each, and rays exactly through their corners, along and
// across their edges: where walls jut out and fall back at one corner, the facets around it say nothing one
// by one.

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <vector>

#include "stress/contest/judgement.hpp"
#include "stress/contest/line.hpp"
#include "stress/rows/rows.hpp"
#include "stress/truth/number.hpp"
#include "tracer/build.hpp"
#include "tracer/media.hpp"
#include "tracer/shadow.hpp"

namespace lancer::stress::flat {
namespace {

constexpr int k_side = 4;  // cells each way

struct Cell {
  int at[3];

  Cell beside(int axis, int step) const {
    Cell out = *this;
    out.at[axis] += step;
    return out;
  }
};

/// Unit cubes of the lattice from <0, 0, 0> to <4, 4, 4>.
class Cubes {
 public:
  bool has(const Cell& c) const { return is_inside(c) && filled_[index(c)]; }
  void set(const Cell& c, bool filled) { filled_[index(c)] = filled; }

  static bool is_inside(const Cell& c) {
    return std::all_of(c.at, c.at + 3, [](int i) { return i >= 0 && i < k_side; });
  }

  /// Does the surface run through each edge at most once, and around each corner? Else no closed mesh has it.
  bool has_a_surface() const {
    for (int x = 0; x <= k_side; ++x) {
      for (int y = 0; y <= k_side; ++y) {
        for (int z = 0; z <= k_side; ++z) {
          if (!is_simple_at({{x, y, z}})) return false;
        }
      }
    }
    return true;
  }

 private:
  static std::size_t index(const Cell& c) {
    return static_cast<std::size_t>((c.at[2] * k_side + c.at[1]) * k_side + c.at[0]);
  }

  /// Are those of the eight cells around a corner that are filled joined by their sides, and those that are
  /// not?
  bool is_simple_at(const Cell& corner) const {
    return pieces_at(corner, true) <= 1 && pieces_at(corner, false) <= 1;
  }

  int pieces_at(const Cell& corner, bool filled) const {
    const auto is_wanted = [&](int octant) {
      Cell c = corner;
      for (int i = 0; i < 3; ++i) c.at[i] -= (octant >> i) & 1;
      return has(c) == filled;
    };
    std::array<bool, 8> seen{};
    int pieces = 0;
    for (int first = 0; first < 8; ++first) {
      if (seen[static_cast<std::size_t>(first)] || !is_wanted(first)) continue;
      ++pieces;
      std::vector<int> waiting{first};
      while (!waiting.empty()) {
        const int octant = waiting.back();
        waiting.pop_back();
        if (seen[static_cast<std::size_t>(octant)]) continue;
        seen[static_cast<std::size_t>(octant)] = true;
        for (int i = 0; i < 3; ++i) {
          if (is_wanted(octant ^ (1 << i))) waiting.push_back(octant ^ (1 << i));
        }
      }
    }
    return pieces;
  }

  std::array<bool, k_side * k_side * k_side> filled_{};
};

/// Cubes added and taken away by chance, as long as the solid keeps a surface.
Cubes random_cubes(Random& random) {
  Cubes cubes;
  for (int i = 0; i < 150; ++i) {
    Cell c{};
    for (int& place : c.at) place = random.below(k_side);
    const bool before = cubes.has(c);
    cubes.set(c, !before);
    if (!cubes.has_a_surface()) cubes.set(c, before);
  }
  return cubes;
}

class MeshMaker {
 public:
  explicit MeshMaker(Random& random) : random_(random) {}

  /// The side of a cell towards +axis or -axis, split along one of its diagonals.
  void add_side(const Cell& cell, int axis, bool upper) {
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    std::array<std::uint32_t, 4> corner{};
    for (int i = 0; i < 4; ++i) {
      Cell at = upper ? cell.beside(axis, 1) : cell;
      at.at[j] += i == 1 || i == 2 ? 1 : 0;
      at.at[k] += i >= 2 ? 1 : 0;
      corner[static_cast<std::size_t>(i)] = point(at);
    }
    if (!upper) std::swap(corner[1], corner[3]);
    const auto turn = static_cast<std::size_t>(random_.below(2));
    const auto c = [&](std::size_t i) { return corner[(i + turn) % 4]; };
    mesh_.faces.push_back({c(0), c(1), c(2)});
    mesh_.faces.push_back({c(0), c(2), c(3)});
  }

  scene::Mesh take() {
    mesh_.solid = true;
    return std::move(mesh_);
  }

 private:
  std::uint32_t point(const Cell& at) {
    const auto [found, is_new] =
        points_.try_emplace({at.at[0], at.at[1], at.at[2]}, static_cast<std::uint32_t>(mesh_.points.size()));
    if (is_new) {
      mesh_.points.push_back(
          {static_cast<double>(at.at[0]), static_cast<double>(at.at[1]), static_cast<double>(at.at[2])});
    }
    return found->second;
  }

  Random& random_;
  scene::Mesh mesh_;
  std::map<std::array<int, 3>, std::uint32_t> points_;
};

/// Calls visit(cell, axis, upper) for every side of a filled cell with an empty one behind it.
template <class Visit>
void for_each_side(const Cubes& cubes, Visit visit) {
  for (int i = 0; i < k_side * k_side * k_side; ++i) {
    const Cell cell{{i % k_side, i / k_side % k_side, i / k_side / k_side}};
    if (!cubes.has(cell)) continue;
    for (int axis = 0; axis < 3; ++axis) {
      for (const bool upper : {false, true}) {
        if (!cubes.has(cell.beside(axis, upper ? 1 : -1))) visit(cell, axis, upper);
      }
    }
  }
}

/// In numbers that are exact; the direction's are in the ratio of those of the ray's, which has unit length.
struct LatticeRay {
  Vec3 origin, way;
};

/// How often a ray crosses the solid that runs beside this one, moved by <e, e^2, e^3> for a small e;
/// crossings at one place of the ray that is not moved count once for each way that is left over, and in and
/// out where none is.
int crossings_beside(const Cubes& cubes, const LatticeRay& ray) {
  const Real small[3] = {Real(0x1p-40), Real(0x1p-80), Real(0x1p-120)};
  std::map<double, int> ways;
  const auto meet = [&](const Cell& cell, int axis, bool upper) {
    if (ray.way[axis] == 0) return;
    const double wall = cell.at[axis] + (upper ? 1 : 0);
    const Real t = (Real(wall) - ray.origin[axis] - small[axis]) / Real(ray.way[axis]);
    if (!(t > 0)) return;
    for (const int i : {(axis + 1) % 3, (axis + 2) % 3}) {
      const Real at = Real(ray.origin[i]) + small[i] + t * Real(ray.way[i]);
      if (!(at > cell.at[i] && at < cell.at[i] + 1)) return;
    }
    ways[(wall - ray.origin[axis]) / ray.way[axis]] += (ray.way[axis] < 0) == upper ? 1 : -1;
  };
  for_each_side(cubes, meet);
  int count = 0;
  for (const auto& [t, way] : ways) count += way == 0 ? 2 : 1;
  return count;
}

/// From outside, through corners of the lattice, their edges, or in the plane of their sides.
LatticeRay random_ray(Random& random) {
  LatticeRay out;
  for (int i = 0; i < 3; ++i) {
    out.way[i] = random.sign() * (random.below(4) == 0 ? 0 : 1);
    out.origin[i] = random.below(k_side + 1);
  }
  if (out.way == Vec3{}) out.way[random.below(3)] = 1;
  // Off the lattice's corners, but not off the edges along that axis.
  if (random.below(2) == 0) {
    const int axis = random.below(3);
    out.origin[axis] += (1 + random.below(7)) / 8.0;
  }
  out.origin = out.origin - out.way * 8;
  return out;
}

/// How many surfaces a ray meets on its way, which must lead in and out by turns, and out in the end; else
/// -1.
int walk(const tracer::World& world, tracer::Ray ray) {
  int count = 0;
  tracer::Stats stats;
  tracer::Hit hit;
  const Vec3 direction = ray.direction;
  for (; closest(world, ray, stats, hit) && count < 100; ++count) {
    if (hit.root.entering != ray.open.empty()) return -1;
    tracer::OpenSolids open = ray.open;
    cross(world, open, hit.shape, hit.root.entering);
    ray = ray_from(world, hit, direction);
    ray.open = open;
  }
  return ray.open.empty() ? count : -1;
}

double light(const tracer::World& world, const tracer::Ray& ray) {
  tracer::Stats stats;
  const double forever = std::numeric_limits<double>::infinity();
  return light_through(world, tracer::ShadowWork::filtered, ray, forever, stats).r;
}

void shoot_exactly(Judgement& judgement, const Cubes& cubes, const tracer::World& world, Random& random) {
  const LatticeRay exact = random_ray(random);
  tracer::Ray ray;
  ray.origin = exact.origin;
  ray.direction = normalize(exact.way);
  const auto text = [&] { return told(ray.origin, ray.direction); };
  const int right = crossings_beside(cubes, exact);
  judgement.check(light(world, ray) == std::ldexp(1.0, -right), "shadow", text);
  // Where a ray only touches, it may be in and out once more, and it goes on from a point that is rounded.
  const int met = walk(world, ray);
  judgement.check(right > 0 ? met > 0 : met >= 0, "walk", text);
}

/// As near to a corner or an edge as rounding lets a ray be that comes from anywhere.
void shoot_nearly(Judgement& judgement, const tracer::World& world, Random& random) {
  Vec3 target;
  for (int i = 0; i < 3; ++i) target[i] = random.below(k_side + 1);
  if (random.below(2) == 0) target[random.below(3)] += random.unit();
  tracer::Ray ray;
  ray.origin = Vec3{2, 2, 2} + random.direction() * random.between(4, 9);
  ray.direction = normalize(target - ray.origin);
  const auto text = [&] { return told(ray.origin, ray.direction); };
  const int surfaces = -std::ilogb(light(world, ray));
  judgement.check(surfaces % 2 == 0, "shadow, nearly", text);
  judgement.check(walk(world, ray) >= 0, "walk, nearly", text);
}

Outcome lattice(const Settings& settings) {
  const std::uint64_t solids = settings.full ? 400 : 20, rays = settings.full ? 500 : 100;
  Judgement judgement;
  for (std::uint64_t i = 0; i < solids; ++i) {
    Random random(settings.seed, "mesh.lattice", i);
    const Cubes cubes = random_cubes(random);
    MeshMaker maker(random);
    for_each_side(cubes, [&](const Cell& cell, int axis, bool upper) { maker.add_side(cell, axis, upper); });
    scene::Scene scene;
    tracer::test::add_mesh(scene, maker.take(), tracer::test::clear(0.5, 1));
    const tracer::World world = tracer::prepare(scene);
    for (std::uint64_t ray = 0; ray < rays; ++ray) {
      shoot_exactly(judgement, cubes, world, random);
      shoot_nearly(judgement, world, random);
    }
  }
  return judgement.outcome();
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_mesh_lattice_rows(Rows& rows) {
  rows.push_back({"mesh.lattice",
                  "closed meshes of unit cubes, through their corners, along and across their edges",
                  flat::lattice});
}
