#pragma once
// Where a scene's surfaces lie, roughly: enough to tell that a light cannot reach any of them.

#include <vector>

#include "scene/scene.hpp"
#include "tracer/aabb.hpp"

namespace lancer::tracer {

/// False only where the ball lies outside of the spot's cone.
bool may_light_ball(const scene::Light& spot, Vec3 center, double radius);

class Extent {
 public:
  /// Work: the shapes and the points of meshes.
  explicit Extent(const scene::Scene& scene);

  /// Around all shapes but planes; empty where there are none.
  const Aabb& bounded() const { return bounded_; }

  /// False only where no surface lies within the spot's cone.
  bool may_be_lit_by(const scene::Light& spot) const;

 private:
  struct Level {
    Vec3 point, normal;  // unit length
  };
  void add(const scene::Scene& scene, const scene::Shape& shape);
  void add_plane(const scene::Plane& plane, const Transform& transform);

  Aabb bounded_;
  std::vector<Level> planes_;
};

}  // namespace lancer::tracer
