#pragma once
// Where a scene's surfaces lie, roughly: enough to tell that a light cannot reach any of them.

#include <vector>

#include "scene/scene.hpp"
#include "tracer/aabb.hpp"

namespace lancer::tracer {

class Extent {
 public:
  /// Work: the shapes and the points of meshes.
  explicit Extent(const scene::Scene& scene);

  /// At most the distance of p from any surface.
  double least_distance(Vec3 p) const;

  /// False only where no surface lies within the spot's cone.
  bool may_be_lit_by(const scene::Light& spot) const;

 private:
  struct Level {
    Vec3 point, normal;  // unit length
  };
  void add(const scene::Scene& scene, const scene::Shape& shape);
  void add_plane(const scene::Plane& plane, const Transform& transform);

  Aabb bounded_;  // all shapes but planes; empty where there are none
  std::vector<Level> planes_;
};

}  // namespace lancer::tracer
