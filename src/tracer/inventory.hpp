#pragma once
// What a scene holds, as far as the plan asks: one look at each shape, and what counts for each material over
// the shapes that wear it. Materials that no shape wears do not exist.

#include <vector>

#include "scene/scene.hpp"

namespace lancer::tracer {

/// A material over all the shapes that wear it; `k_none` where there is no such shape.
struct Wearers {
  scene::Index any = scene::k_none;         // the first of all
  scene::Index caster = scene::k_none;      // that casts a shadow
  scene::Index solid = scene::k_none;       // that encloses something
  scene::Index solid_mesh = scene::k_none;  // of those, a mesh
};

/// Which coefficients of a material are not black at every point.
struct Terms {
  bool ambient = false, diffuse = false, specular = false, reflection = false, transmission = false;

  bool direct() const { return diffuse || specular; }
  bool onward() const { return reflection || transmission; }
};

struct Inventory {
  explicit Inventory(const scene::Scene& scene);

  std::vector<Wearers> wearers;  // of each material
  std::vector<Terms> terms;
  std::vector<scene::Index> solid_meshes;
  std::uint64_t primitives = 0;
  bool only_spheres_and_planes = true;
};

}  // namespace lancer::tracer
