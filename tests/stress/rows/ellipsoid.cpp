// Ellipsoids of axes 1 : 1e+-4 in any position, for the rays that round solids have in common.

#include "stress/methods/ellipsoid.hpp"

#include <algorithm>
#include <cmath>

#include "stress/rows/round.hpp"
#include "stress/rows/rows.hpp"
#include "stress/subjects/placement.hpp"

namespace lancer::stress {
namespace {

constexpr double k_thinnest = 1e-4;  // of the largest half axis

/// The largest is `size`, the ratios are anything between 1 and 1e4.
Vec3 half_axes(Random& random, double size) {
  Vec3 out;
  for (int i = 0; i < 3; ++i) out[i] = size * random.over_scales(k_thinnest, 1);
  out[random.below(3)] = size;
  const int thin = random.below(6);  // often a disc or a needle of the extreme ratio
  if (thin < 3 && out[thin] != size) out[thin] = size * k_thinnest;
  return out;
}

/// Powers of two, one of them different from the others.
Vec3 whole_half_axes(Random& random) {
  const double size = std::scalbn(1.0, random.below(4));
  Vec3 out{size, size, size};
  out[random.below(3)] = size / std::scalbn(1.0, 1 + random.below(6));
  return out;
}

Placed add_ellipsoid(Random& random, scene::Scene& scene, const Placing& placing) {
  const double size = random.over_scales(placing.least, placing.most);
  scene::Sphere sphere;
  Affine map;
  Vec3 center;
  if (placing.whole) {
    map = scaling(whole_half_axes(random));
    for (int i = 0; i < 3; ++i) center[i] = random.below(17) - 8;
  } else {
    map = scaling(half_axes(random, size));
    // A turn before the scaling makes no other solid, but a matrix of other numbers.
    if (random.below(2) == 0) map = then(any_turn(random), map);
    map = then(map, any_turn(random));
    const Vec3 away = random.direction() * (placing.moved * size);
    center = away + random.in_cube(2 * size);
    if (random.below(2) == 0) {
      sphere.radius = random.between(0.5, 2);
      map = then(scaling({1 / sphere.radius, 1 / sphere.radius, 1 / sphere.radius}), map);
    }
  }
  map = then(map, translation(center));
  if (!placing.whole && placing.moved == 0 && random.below(2) == 0) sphere.center = random.in_cube(1);
  scene.spheres.push_back(sphere);
  scene.materials.emplace_back();
  scene.transforms.push_back({map, *inverse(map)});
  scene.shapes.emplace_back();
  scene.shapes.back().transform = 1;
  const double r = sphere.radius;
  Placed placed{then(then(scaling({r, r, r}), translation(sphere.center)), map), {}, size};
  if (placing.whole) placed.size = max_abs({map.rows[0].x, map.rows[1].y, map.rows[2].z});
  placed.to_ball = *inverse(placed.to_world);
  return placed;
}

}  // namespace

void add_ellipsoid_rows(Rows& rows) {
  add_round_rows(rows, {"ellipsoid", add_ellipsoid}, with_those_in_use(ellipsoid_methods()),
                 [](const tracer::World& world, const Sight& sight) {
                   return first_hit(world.ellipsoids.at(0), sight);
                 });
}

}  // namespace lancer::stress
