// Planes and their hard rays.

#include "stress/methods/plane.hpp"

#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <stdexcept>
#include <utility>

#include "stress/contest/harness.hpp"
#include "stress/rows/rows.hpp"
#include "stress/subjects/axis.hpp"
#include "stress/subjects/placement.hpp"

namespace lancer::stress {
namespace {

/// A plane has no size; this is that of the numbers around.
struct Placing {
  double least = 0.25, most = 4;
  double moved = 0;                    // how far from the origin, in sizes
  double shortest = 0.5, longest = 2;  // of the normal
};

/// Where a plane lies.
struct Placed {
  Vec3 base;  // on it, but for rounding
  Vec3 normal;
  double size = 1;
};

using MakeShot = std::function<Shot(Random&, const Placed&, const tracer::World&)>;

Vec3 some_normal(Random& random) {
  if (random.below(3) != 0) return random.direction();
  Vec3 axis;
  axis[random.below(3)] = random.sign();
  return axis;
}

void add_plane(Random& random, scene::Scene& scene, const Placing& placing, double size) {
  scene::Plane plane;
  const Vec3 normal = some_normal(random), away = random.direction() * (placing.moved * size);
  plane.normal = normal * random.over_scales(placing.shortest, placing.longest);
  plane.point = away + random.in_cube(size);
  if (random.below(2) == 0) plane.offset = size * random.between(-2, 2);
  scene.planes.push_back(plane);
  scene.materials.emplace_back();
  scene.shapes.emplace_back();
  scene.shapes.back().kind = scene::ShapeKind::plane;
  if (random.below(4) != 0) return;
  const Affine turn = any_turn(random);
  const Affine map = then(turn, scaling({1, random.between(0.5, 2), random.between(0.5, 2)}));
  scene.transforms.push_back({map, *inverse(map)});
  scene.shapes.back().transform = 1;
}

RaySet ray_set(std::string name, const Placing& placing, MakeShot make_shot) {
  const auto make = [placing, make_shot = std::move(make_shot)](Random& random, int shots) {
    Batch batch;
    batch.scene = std::make_unique<scene::Scene>();
    const double size = random.over_scales(placing.least, placing.most);
    add_plane(random, *batch.scene, placing, size);
    batch.world = tracer::prepare(*batch.scene);
    const tracer::PlanePrimitive& plane = batch.world.planes.at(0);
    const Vec3 normal = normalize(plane.normal);
    const Placed placed{plane.point + normal * (plane.level / length(plane.normal)), normal, size};
    for (int i = 0; i < shots; ++i) batch.shots.push_back(make_shot(random, placed, batch.world));
    return batch;
  };
  return {std::move(name), make};
}

/// On the plane, at most ten sizes from its base.
Vec3 foot(Random& random, const Placed& placed) {
  const Vec3 aside = random.across(placed.normal);
  return placed.base + aside * (placed.size * random.between(0, 10));
}

Shot shot_of(const Placed& placed, Vec3 foot, double height, Vec3 direction) {
  Shot shot;
  shot.ray.origin = foot + placed.normal * (height * placed.size);
  shot.ray.direction = normalize(direction);
  return shot;
}

/// Falls or rises by `slope` a unit of length.
Vec3 sloping(Random& random, const Placed& placed, double slope) {
  return random.across(placed.normal) + placed.normal * slope;
}

/// From a height of `least` to `most` sizes, on any side, in any direction, every other one grazing.
MakeShot any_from(double least, double most) {
  return [=](Random& random, const Placed& placed, const tracer::World&) {
    const double height = random.signed_over_scales(least, most);
    const Vec3 direction = random.below(2) == 0
                               ? random.direction()
                               : sloping(random, placed, random.signed_over_scales(1e-16, 0.1));
    return shot_of(placed, foot(random, placed), height, direction);
  };
}

std::vector<RaySet> grazing_sets() {
  std::vector<RaySet> sets;
  for (int k = 1; k <= 16; ++k) {
    const double slope = std::stod(fmt::format("1e-{}", k));
    sets.push_back(ray_set(fmt::format("n . d = {:.0e}", slope), {},
                           [slope](Random& random, const Placed& placed, const tracer::World&) {
                             const double height = random.signed_over_scales(0.1, 10);
                             const Vec3 start = foot(random, placed);
                             const Vec3 way = sloping(random, placed, random.sign() * slope);
                             return shot_of(placed, start, height, way);
                           }));
  }
  return sets;
}

std::vector<RaySet> height_sets() {
  std::vector<RaySet> sets;
  for (const double height : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9}) {
    sets.push_back(ray_set(fmt::format("{:.0e} sizes", height), {}, any_from(height, 2 * height)));
  }
  return sets;
}

std::vector<RaySet> scaled_sets() {
  std::vector<RaySet> sets;
  for (const double size : {1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9}) {
    sets.push_back(ray_set(fmt::format("size {:.0e}", size), {size, 2 * size}, any_from(0.1, 10)));
  }
  for (const int k : {-100, -50, 50, 100}) {
    const double size = std::ldexp(1.0, k);
    sets.push_back(ray_set(fmt::format("size 2^{}", k), {size, 2 * size}, any_from(0.1, 10)));
  }
  return sets;
}

std::vector<RaySet> moved_sets() {
  std::vector<RaySet> sets;
  for (const double moved : {1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9}) {
    sets.push_back(ray_set(fmt::format("by {:.0e} sizes", moved), {0.25, 4, moved}, any_from(0.1, 10)));
  }
  return sets;
}

/// The ray that goes on from where a ray met the plane.
Shot leaving(Random& random, const Placed& placed, const tracer::World& world, Vec3 direction) {
  const double height = random.signed_over_scales(0.1, 10);
  const Vec3 start = foot(random, placed);
  const Vec3 aim = foot(random, placed) - (start + placed.normal * (height * placed.size));
  const Shot shot = shot_of(placed, start, height, aim);
  tracer::Stats stats;
  tracer::Hit hit;
  if (!tracer::closest(world, shot.ray, stats, hit)) throw std::runtime_error("a ray misses the plane ahead");
  return {tracer::ray_from(world, hit, normalize(direction)), true};
}

std::vector<RaySet> surface_sets() {
  return {
      ray_set("any way", {},
              [](Random& random, const Placed& placed, const tracer::World& world) {
                return leaving(random, placed, world, random.direction());
              }),
      ray_set("along it, all but", {}, [](Random& random, const Placed& placed, const tracer::World& world) {
        const double slope = random.signed_over_scales(1e-17, 0.1);
        return leaving(random, placed, world, sloping(random, placed, slope));
      })};
}

std::vector<RaySet> axis_sets() {
  return {ray_set("along an axis", {}, [](Random& random, const Placed& placed, const tracer::World&) {
    const double height = random.signed_over_scales(0.1, 10);
    Shot shot = shot_of(placed, foot(random, placed), height, {1, 0, 0});
    shot.ray.direction = along_axis(random, random.below(3));
    return shot;
  })};
}

std::vector<RaySet> length_sets() {
  std::vector<RaySet> sets;
  for (const auto& [least, most] : {std::pair{1e-160, 1e-150}, {1e-100, 1e100}, {1e150, 1e160}}) {
    const std::string range = fmt::format("{:.0e} to {:.0e}", least, most);
    sets.push_back(ray_set(
        "directions of " + range, {},
        [least = least, most = most](Random& random, const Placed& placed, const tracer::World& world) {
          Shot shot = any_from(0.1, 10)(random, placed, world);
          const double factor = random.over_scales(least, most);
          shot.ray.direction = normalize(shot.ray.direction * factor);
          return shot;
        }));
    sets.push_back(ray_set("normals of " + range, {0.25, 4, 0, least, most}, any_from(0.1, 10)));
  }
  return sets;
}

std::vector<RaySet> mixed_sets() {
  std::vector<RaySet> sets;
  for (const double moved : {0.0, 1e3, 1e6, 1e9}) {
    sets.push_back(ray_set(moved == 0 ? "near the origin" : fmt::format("moved by {:.0e} sizes", moved),
                           {1e-9, 1e9, moved}, any_from(1e-12, 1e9)));
  }
  return sets;
}

}  // namespace

void add_plane_rows(Rows& rows) {
  const std::vector<Method> methods = with_those_in_use(plane_methods());
  const Oracle oracle = [](const tracer::World& world, const Sight& sight) {
    return first_hit(world.planes.at(0), sight);
  };
  const auto add = [&](const std::string& what, std::string about, std::vector<RaySet> sets) {
    const std::string name = "plane." + what;
    rows.push_back({name, std::move(about), [=](const Settings& settings) {
                      return measure(settings, name, sets, methods, oracle);
                    }});
  };
  add("uniform", "any directions, from 0.1 to 10 sizes above or below, half of them grazing",
      {ray_set("any", {}, any_from(0.1, 10))});
  add("grazing", "slopes of 1e-1 to 1e-16", grazing_sets());
  add("heights", "starts 1e-15 to 1e9 sizes above or below", height_sets());
  add("scaled", "of sizes 1e-9 to 1e9 and 2^-100 to 2^100", scaled_sets());
  add("moved", "1e3 to 1e9 sizes from the origin", moved_sets());
  add("on_surface", "rays that leave the plane never meet it", surface_sets());
  add("axis_parallel", "directions with components of 0, -0 and next to nothing", axis_sets());
  add("lengths", "directions and normals that were 1e-160 to 1e160 long", length_sets());
  add("mixed", "every size, place and height together", mixed_sets());
}

}  // namespace lancer::stress
