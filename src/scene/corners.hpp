#pragma once
// The points of a scene that shapes with corners are made of.

#include "scene/scene.hpp"

namespace lancer::scene {

/// Calls visit(p) for each corner of a box, facet or mesh, where it is in the scene. Spheres and planes have
/// none.
template <class Visit>
void each_corner(const Scene& scene, const Shape& shape, Visit visit) {
  const Affine& map = scene.transforms[shape.transform].to_world;
  switch (shape.kind) {
    case ShapeKind::sphere:
    case ShapeKind::plane: break;
    case ShapeKind::box: {
      const Box& box = scene.boxes[shape.record];
      const Affine whole = then(scene.transforms[box.frame].to_world, map);
      for (int i = 0; i < 8; ++i) {
        visit(whole.point(
            {i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y, i & 4 ? box.hi.z : box.lo.z}));
      }
      break;
    }
    case ShapeKind::facet: {
      const Facet& facet = scene.facets[shape.record];
      for (const Vec3 p : {facet.a, facet.b, facet.c}) visit(map.point(p));
      break;
    }
    case ShapeKind::mesh:
      for (const Vec3 p : scene.meshes[shape.record].points) visit(map.point(p));
      break;
  }
}

}  // namespace lancer::scene
