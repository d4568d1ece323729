#include "stress/methods_plane.hpp"
#include "stress/rays_plane.hpp"

namespace lancer::stress {

void add_plane_rows(Rows& rows) {
  std::vector<Method> methods = plane_methods();
  for (Method& method : methods_in_use()) methods.push_back(std::move(method));
  add_plane_rows(rows, methods, [](const tracer::World& world, const Sight& sight) {
    return first_hit(world.planes.at(0), sight);
  });
}

}  // namespace lancer::stress
