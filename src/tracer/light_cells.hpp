#pragma once
// Which lights are asked where there are many that reach a part of the scene only: worked out once for each
// cell of space in which a ray meets something. Cells are cubes, the larger the farther they lie from the
// scene's middle.

#include <unordered_map>
#include <vector>

#include "scene/scene.hpp"
#include "tracer/options.hpp"

namespace lancer::tracer {

struct Plan;

/// Decided by the plan.
struct LightCellPlan {
  bool used = false;
  Vec3 middle;
  double reach = 1;    // from the middle, in which cells have `size`; twice as far, twice the size
  double size = 1;     // edge of a cell
  bool spots = false;  // leave out spots whose cones miss the cell
  double faint = 0;    // leave out lamps that together bring no more than this into the cell
};

/// One thread's cells.
class LightCells {
 public:
  struct Cell {
    std::vector<scene::Index> lights;           // to be asked, in order
    std::uint64_t outside_cone = 0, faint = 0;  // how many are not
  };

  LightCells(const scene::Scene& scene, const Plan& plan) : scene_(&scene), plan_(&plan) {}

  /// p in the space of the scene.
  const Cell& at(Vec3 p);

 private:
  struct Key {
    double x = 0, y = 0, z = 0, size = 0;
    friend bool operator==(const Key&, const Key&) = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  Key key_of(Vec3 p) const;
  Cell made(const Key& key) const;

  const scene::Scene* scene_;
  const Plan* plan_;
  std::unordered_map<Key, Cell, Hash> cells_;
  Key last_;
  const Cell* last_cell_ = nullptr;
};

}  // namespace lancer::tracer
