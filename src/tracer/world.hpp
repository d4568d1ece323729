#pragma once
// A scene prepared for tracing: every shape as one or more primitives in world space, numbered in the order
// in which the shapes were added, and the tree over those that have bounds.

#include <atomic>
#include <cstdint>
#include <vector>

#include "scene/scene.hpp"
#include "tracer/bvh.hpp"
#include "tracer/shapes/box.hpp"
#include "tracer/shapes/ellipsoid.hpp"
#include "tracer/shapes/facet.hpp"
#include "tracer/shapes/plane_roots.hpp"
#include "tracer/shapes/sphere_quads.hpp"
#include "tracer/shapes/sphere_roots.hpp"

namespace lancer::tracer {

enum class Kind : std::uint8_t { sphere, ellipsoid, plane, box, facet };

struct Primitive {
  Kind kind = Kind::sphere;
  std::uint32_t record = 0;  // in the list of its kind
  std::uint32_t shape = 0;   // in Scene::shapes
};

/// A mesh that encloses a volume.
struct SolidMesh {
  std::uint32_t shape = 0;
  Aabb bounds;
};

struct World {
  const scene::Scene* scene = nullptr;
  Vec3 origin;  // of the world's own space, in the scene's; everything below is in the world's
  std::vector<SpherePrimitive> spheres;
  std::vector<EllipsoidPrimitive> ellipsoids;
  std::vector<PlanePrimitive> planes;
  std::vector<BoxPrimitive> boxes;
  std::vector<FacetPrimitive> facets;

  std::vector<Primitive> primitives;
  std::vector<std::uint32_t> first_primitive;  // of each shape, and one past the last
  SphereQuads listed_spheres;                  // primitives that are in no tree: spheres
  std::vector<std::uint32_t> unbounded;        // and all others
  std::vector<std::uint32_t> bounded;          // the primitive of each item of the tree
  Bvh tree;
  std::vector<SolidMesh> solid_meshes;
  std::vector<scene::Light> lights;

  bool has_facets() const { return !facets.empty(); }
  const scene::Shape& shape_of(std::uint32_t primitive) const {
    return scene->shapes[primitives[primitive].shape];
  }
  const scene::Material& material_of(std::uint32_t shape) const {
    return scene->materials[scene->shapes[shape].material];
  }
};

/// `scene` must outlive the world, whose own space starts at `origin` of the scene's. Facets without an area
/// are left out. Without a tree all primitives are `unbounded`: asked one by one. Once `cancel` is set it
/// returns soon, with an unusable world.
World prepare(const scene::Scene& scene, Vec3 origin = {}, const std::atomic<bool>* cancel = nullptr,
              bool with_tree = true);

/// Does the shape have an inside? All have but facets and open meshes.
bool encloses(const scene::Scene& scene, std::uint32_t shape);

// --- What every kind of primitive can do; see shapes/
// --------------------------------------------------------------

/// Of one facet or, by the tests of box.hpp and ellipsoid.hpp, of what is neither sphere nor plane.
Roots other_roots(const World& world, const Primitive& primitive, const Probe& probe);

/// Calls use(roots) with those of the primitive, and returns what it does. A ray at an edge or corner that
/// facets share meets every one of them; those of a mesh that encloses something as a ray beside it does
/// (shapes/rim.hpp), the others it passes.
template <class Use>
auto with_roots(const World& world, const Primitive& p, const Probe& probe, const Use& use) {
  switch (p.kind) {
    case Kind::sphere: return use(roots(world.spheres[p.record], probe));
    case Kind::plane: return use(roots(world.planes[p.record], probe));
    case Kind::ellipsoid:
    case Kind::box:
    case Kind::facet: break;
  }
  return use(other_roots(world, p, probe));
}
inline Roots roots(const World& world, std::uint32_t primitive, const Probe& probe) {
  return with_roots(world, world.primitives[primitive], probe, [](const Roots& found) { return found; });
}
/// Of a convex solid.
Root exit(const World& world, std::uint32_t primitive, Vec3 origin, Vec3 direction);
/// The crossing that `root` is near, to the last bit.
Landing land(const World& world, std::uint32_t primitive, Vec3 origin, Vec3 direction, const Root& root);
/// Outward, unit length, at a point on the primitive.
Vec3 normal(const World& world, std::uint32_t primitive, Vec3 p, int face);
Vec3 project(const World& world, std::uint32_t primitive, Vec3 p, int face);
/// How far rounding may have moved the surface from where its shape and transform put it.
double slack(const World& world, std::uint32_t primitive);
/// Of all but planes.
inline Aabb bounds(const World& world, std::uint32_t primitive) {
  const Primitive& p = world.primitives[primitive];
  switch (p.kind) {
    case Kind::sphere: return bounds(world.spheres[p.record]);
    case Kind::ellipsoid: return bounds(world.ellipsoids[p.record]);
    case Kind::box: return bounds(world.boxes[p.record]);
    case Kind::facet: return bounds(world.facets[p.record]);
    case Kind::plane: break;
  }
  return {};
}
/// The part of the ray within the primitive's own bounds. A root counts only where this is not empty, which
/// makes the answer the same for every tree.
inline Interval own_interval(const World& world, std::uint32_t primitive, const Probe& probe) {
  if (world.primitives[primitive].kind == Kind::plane) return {0, k_infinity};
  return interval(bounds(world, primitive), probe);
}

constexpr bool is_convex_solid(Kind kind) {
  return kind == Kind::sphere || kind == Kind::ellipsoid || kind == Kind::box;
}

/// < 0: p lies inside the shape, which encloses something; 0: exactly on its surface; > 0: outside.
double side(const World& world, std::uint32_t shape, Vec3 p);

}  // namespace lancer::tracer
