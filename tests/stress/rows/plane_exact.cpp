// Planes, and rays whose slope or height all but cancels or is nothing at all.

#include "stress/contest/harness.hpp"
#include "stress/methods/plane.hpp"
#include "stress/rows/rows.hpp"
#include "stress/subjects/cancelling.hpp"
#include "tracer/build.hpp"

namespace lancer::stress::flat {
namespace {

RaySet cancelling(const std::string& name, bool depth, std::vector<int> targets) {
  return {name, [=](Random& random, int shots) {
            const int target = targets[static_cast<std::size_t>(random.below(int(targets.size())))];
            const Across across = all_but_orthogonal(random, target);
            Batch batch;
            batch.scene = std::make_unique<scene::Scene>();
            tracer::test::add_plane(*batch.scene, {}, across.n);
            batch.world = tracer::prepare(*batch.scene);
            for (int i = 0; i < shots; ++i) {
              Shot shot;
              const double sign = random.sign(), size = random.signed_over_scales(0.1, 10);
              shot.ray.origin =
                  depth ? across.d * std::scalbn(sign, random.below(9) - 4) : normalize(across.n) * size;
              shot.ray.direction = depth ? random.direction() : across.d * sign;
              batch.shots.push_back(shot);
            }
            return batch;
          }};
}

Outcome plane_exact(const Settings& settings) {
  const std::vector<int> targets{1, -1, 3, -3, 256, -256};
  return measure(settings, "plane.exact",
                 {cancelling("slopes", false, targets), cancelling("along it", false, {0}),
                  cancelling("heights", true, targets), cancelling("starts on it", true, {0})},
                 with_those_in_use(plane_methods()), [](const tracer::World& world, const Sight& sight) {
                   return stress::first_hit(world.planes.at(0), sight);
                 });
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_plane_exact_rows(Rows& rows) {
  rows.push_back(
      {"plane.exact", "slopes and heights of some 2^-130 of their terms, and of 0", flat::plane_exact});
}
