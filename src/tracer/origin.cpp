#include "tracer/origin.hpp"

#include <algorithm>

#include "scene/corners.hpp"
#include "tracer/aabb.hpp"

namespace lancer::tracer {
namespace {

class Spread {
 public:
  explicit Spread(const scene::Scene& scene) : scene_(scene) {
    for (const scene::Shape& shape : scene.shapes) add(shape);
  }

  bool may_move(int axis, double eye) const {
    const double lo = places_.lo[axis], hi = places_.hi[axis];
    if (!(lo <= hi)) return false;
    return eye > 0 ? lo >= eye / 2 && hi <= eye * 2 : hi <= eye / 2 && lo >= eye * 2;
  }

 private:
  void add(const scene::Shape& shape) {
    const Transform& transform = scene_.transforms[shape.transform];
    const Affine& map = transform.to_world;
    switch (shape.kind) {
      case scene::ShapeKind::sphere: places_.add(map.point(scene_.spheres[shape.record].center)); break;
      case scene::ShapeKind::plane: add(scene_.planes[shape.record], transform); break;
      case scene::ShapeKind::box: add(scene_.boxes[shape.record], map); break;
      case scene::ShapeKind::facet:
      case scene::ShapeKind::mesh: scene::each_corner(scene_, shape, [&](Vec3 p) { places_.add(p); }); break;
    }
  }

  void add(const scene::Box& box, const Affine& map) {
    const Affine& frame = scene_.transforms[box.frame].to_world;
    for (const Vec3 corner : {box.lo, box.hi}) places_.add(map.point(frame.point(corner)));
  }

  /// A plane has a place along the axis that it lies across; one across none has no coordinate to be rounded
  /// but its level.
  void add(const scene::Plane& plane, const Transform& transform) {
    const Vec3 normal = transform.normal_to_world(plane.normal), at = transform.to_world.point(plane.point);
    for (int axis = 0; axis < 3; ++axis) {
      if (normal[(axis + 1) % 3] != 0 || normal[(axis + 2) % 3] != 0) continue;
      places_.lo[axis] = std::min(places_.lo[axis], at[axis]);
      places_.hi[axis] = std::max(places_.hi[axis], at[axis]);
    }
  }

  const scene::Scene& scene_;
  Aabb places_;
};

}  // namespace

Vec3 world_origin(const scene::Scene& scene, Vec3 eye) {
  const Spread spread(scene);
  Vec3 origin;
  for (int axis = 0; axis < 3; ++axis) {
    if (spread.may_move(axis, eye[axis])) origin[axis] = eye[axis];
  }
  return origin;
}

}  // namespace lancer::tracer
