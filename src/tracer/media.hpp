#pragma once
// Which solids a ray is inside of, and the refractive index that follows.

#include <vector>

#include "tracer/options.hpp"
#include "tracer/world.hpp"

namespace lancer::tracer {

/// That of the most recently entered solid still open, else of the surrounding space.
double refractive_index(const World& world, const OpenSolids& open);

/// The list after a surface of the shape was crossed: entering opens it, leaving closes that very shape.
/// Shapes that enclose nothing change nothing, nor does entering what is open or leaving what is not.
void cross(const World& world, OpenSolids& open, std::uint32_t shape, bool entering);

/// A solid around a point.
struct Surrounding {
  std::uint32_t shape = 0;
  bool touched = false;  // the point lies exactly on its surface
  // Of a mesh that is touched: on which of its facets the point is, and how often the others run around it.
  std::vector<std::uint32_t> on;
  double turns = 0;
};

/// The solids that p lies in or on, in the order in which they were added.
std::vector<Surrounding> solids_around(const World& world, Vec3 p);

/// Of these, the solids that a ray from there starts inside of, ordered by where it leaves them, the farthest
/// outermost; of equally far ones the one that was added first.
OpenSolids open_at(const World& world, const std::vector<Surrounding>& around, Vec3 origin, Vec3 direction,
                   Stats& stats);

}  // namespace lancer::tracer
