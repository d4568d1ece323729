// Spheres, for the rays that round solids have in common.

#include "stress/methods/sphere.hpp"

#include "stress/rows/round.hpp"
#include "stress/rows/rows.hpp"

namespace lancer::stress {
namespace {

Placed add_sphere(Random& random, scene::Scene& scene, const Placing& placing) {
  scene::Sphere sphere;
  sphere.radius = random.over_scales(placing.least, placing.most);
  if (placing.whole) {
    sphere.radius = std::ceil(sphere.radius);
    for (int i = 0; i < 3; ++i) sphere.center[i] = random.below(17) - 8;
  } else {
    const Vec3 away = random.direction() * (placing.moved * sphere.radius);
    sphere.center = away + random.in_cube(2 * sphere.radius);
    if (placing.moved == 0 && random.below(4) == 0) sphere.center = {};
  }
  scene.spheres.push_back(sphere);
  scene.materials.emplace_back();
  scene.shapes.emplace_back();
  const double r = sphere.radius;
  Placed placed{then(scaling({r, r, r}), translation(sphere.center)), {}, r};
  placed.to_ball = *inverse(placed.to_world);
  return placed;
}

}  // namespace

void add_sphere_rows(Rows& rows) {
  add_round_rows(
      rows, {"sphere", add_sphere}, with_those_in_use(sphere_methods()),
      [](const tracer::World& world, const Sight& sight) { return first_hit(world.spheres.at(0), sight); });
}

}  // namespace lancer::stress
