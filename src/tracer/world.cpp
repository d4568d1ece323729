#include "tracer/world.hpp"

#include "tracer/prepare.hpp"
#include "tracer/shapes/rim.hpp"
#include "tracer/shapes/solid_angle.hpp"

namespace lancer::tracer {

World prepare(const scene::Scene& scene, Vec3 origin, const std::atomic<bool>* cancel, bool with_tree) {
  World world;
  world.scene = &scene;
  world.origin = origin;
  world.lights = scene.lights;
  for (scene::Light& light : world.lights) {
    const Place at = Place{light.at, light.at_rest}.from(origin);
    light.at = at.at;
    light.at_rest = at.rest;
  }
  for (std::uint32_t shape = 0; shape < scene.shapes.size(); ++shape) {
    world.first_primitive.push_back(static_cast<std::uint32_t>(world.primitives.size()));
    add_primitives(world, shape);
  }
  world.first_primitive.push_back(static_cast<std::uint32_t>(world.primitives.size()));

  for (std::uint32_t primitive = 0; primitive < world.primitives.size(); ++primitive) {
    const Primitive& p = world.primitives[primitive];
    if (!with_tree && p.kind == Kind::sphere) {
      world.listed_spheres.add(world.spheres[p.record], primitive);
    } else if (!with_tree || p.kind == Kind::plane) {
      world.unbounded.push_back(primitive);
    } else {
      world.bounded.push_back(primitive);
    }
  }
  for (std::uint32_t shape = 0; shape < scene.shapes.size(); ++shape) {
    if (scene.shapes[shape].kind != scene::ShapeKind::mesh || !encloses(scene, shape)) continue;
    SolidMesh mesh{shape, {}};
    for (std::uint32_t p = world.first_primitive[shape]; p < world.first_primitive[shape + 1]; ++p) {
      mesh.bounds.add(bounds(world, p));
    }
    world.solid_meshes.push_back(mesh);
  }
  world.tree = Bvh(
      static_cast<std::uint32_t>(world.bounded.size()),
      [&](std::uint32_t item) { return bounds(world, world.bounded[item]); }, cancel);
  return world;
}

bool encloses(const scene::Scene& scene, std::uint32_t shape) {
  const scene::Shape& s = scene.shapes[shape];
  if (s.kind == scene::ShapeKind::mesh) return scene.meshes[s.record].solid;
  return s.kind != scene::ShapeKind::facet;
}

namespace {

/// Of a facet; at its rim, where it is of a closed mesh, only if a ray beside that one crosses it.
Roots facet_roots(const World& world, const Primitive& p, const Probe& probe) {
  const FacetPrimitive& facet = world.facets[p.record];
  Roots found = roots(facet, probe);
  if (found.root[0].rim && encloses(*world.scene, p.shape) &&
      !is_crossed_beside(facet, probe.origin, probe.direction)) {
    found.count = 0;
    found.passes = true;
  }
  return found;
}

}  // namespace

Roots other_roots(const World& world, const Primitive& p, const Probe& probe) {
  switch (p.kind) {
    case Kind::ellipsoid: return roots(world.ellipsoids[p.record], probe);
    case Kind::box: return roots(world.boxes[p.record], probe);
    case Kind::facet: return facet_roots(world, p, probe);
    case Kind::sphere:
    case Kind::plane: break;
  }
  return {};
}

Root exit(const World& world, std::uint32_t primitive, Vec3 origin, Vec3 direction) {
  const Primitive p = world.primitives[primitive];
  switch (p.kind) {
    case Kind::sphere: return exit(world.spheres[p.record], origin, direction);
    case Kind::ellipsoid: return exit(world.ellipsoids[p.record], origin, direction);
    case Kind::box: return exit(world.boxes[p.record], origin, direction);
    case Kind::plane:
    case Kind::facet: break;
  }
  return {};
}

Landing land(const World& world, std::uint32_t primitive, Vec3 origin, Vec3 direction, const Root& root) {
  const Primitive p = world.primitives[primitive];
  switch (p.kind) {
    case Kind::sphere: return land(world.spheres[p.record], origin, direction, root);
    case Kind::ellipsoid: return land(world.ellipsoids[p.record], origin, direction, root);
    case Kind::plane: return land(world.planes[p.record], origin, direction, root);
    case Kind::box: return land(world.boxes[p.record], origin, direction, root);
    case Kind::facet: return land(world.facets[p.record], origin, direction, root);
  }
  return {};
}

Vec3 normal(const World& world, std::uint32_t primitive, Vec3 at, int face) {
  const Primitive p = world.primitives[primitive];
  switch (p.kind) {
    case Kind::sphere: return normal(world.spheres[p.record], at);
    case Kind::ellipsoid: return normal(world.ellipsoids[p.record], at);
    case Kind::plane: return normal(world.planes[p.record]);
    case Kind::box: return normal(world.boxes[p.record], face);
    case Kind::facet: return normal(world.facets[p.record]);
  }
  return {};
}

Vec3 project(const World& world, std::uint32_t primitive, Vec3 at, int face) {
  const Primitive p = world.primitives[primitive];
  switch (p.kind) {
    case Kind::sphere: return project(world.spheres[p.record], at);
    case Kind::ellipsoid: return project(world.ellipsoids[p.record], at);
    case Kind::plane: return project(world.planes[p.record], at);
    case Kind::box: return project(world.boxes[p.record], at, face);
    case Kind::facet: return project(world.facets[p.record], at);
  }
  return at;
}

double slack(const World& world, std::uint32_t primitive) {
  const Primitive p = world.primitives[primitive];
  switch (p.kind) {
    case Kind::sphere: return world.spheres[p.record].slack;
    case Kind::ellipsoid: return world.ellipsoids[p.record].slack;
    case Kind::plane: return world.planes[p.record].slack;
    case Kind::box: return world.boxes[p.record].slack;
    case Kind::facet: return world.facets[p.record].slack;
  }
  return 0;
}

double side(const World& world, std::uint32_t shape, Vec3 at) {
  const std::uint32_t first = world.first_primitive[shape], last = world.first_primitive[shape + 1];
  if (first == last) return 1;
  const Primitive p = world.primitives[first];
  switch (p.kind) {
    case Kind::sphere: return side(world.spheres[p.record], at);
    case Kind::ellipsoid: return side(world.ellipsoids[p.record], at);
    case Kind::plane: return side(world.planes[p.record], at);
    case Kind::box: return side(world.boxes[p.record], at);
    case Kind::facet: break;
  }
  double turns = 0;
  for (std::uint32_t i = first; i < last; ++i) {
    const Seen seen = seen_from(world.facets[world.primitives[i].record], at);
    if (seen.touched) return 0;
    turns += seen.turns;
  }
  return turns > 0.5 ? -1 : 1;
}

}  // namespace lancer::tracer
