#include "tracer/surface.hpp"

#include "tracer/pattern.hpp"

namespace lancer::tracer {
namespace {

/// The normals at the facet's corners, in the shape's own space; null where it is flat.
bool corner_normals(const World& world, const Hit& hit, std::array<Vec3, 3>& normals) {
  const scene::Scene& scene = *world.scene;
  const scene::Shape& shape = scene.shapes[hit.shape];
  if (shape.kind == scene::ShapeKind::facet) {
    const scene::Facet& facet = scene.facets[shape.record];
    if (facet.normals == scene::k_none) return false;
    normals = scene.facet_normals[facet.normals];
    return true;
  }
  if (shape.kind != scene::ShapeKind::mesh) return false;
  const scene::Mesh& mesh = scene.meshes[shape.record];
  if (mesh.normals.empty()) return false;
  const auto& face = mesh.faces[world.facets[world.primitives[hit.primitive].record].face];
  for (std::size_t corner = 0; corner < 3; ++corner) normals[corner] = mesh.normals[face[corner]];
  return true;
}

Vec3 shading_normal(const World& world, const Ray& ray, const Hit& hit) {
  const Vec3 flat = hit.root.entering ? hit.normal : -hit.normal;
  if (world.primitives[hit.primitive].kind != Kind::facet) return flat;
  std::array<Vec3, 3> corners;
  if (!corner_normals(world, hit, corners)) return flat;
  const Barycentric weight = barycentric(world.facets[world.primitives[hit.primitive].record], hit.point);
  const Vec3 own = corners[0] * weight.a + corners[1] * weight.b + corners[2] * weight.c;
  const Transform& transform = world.scene->transforms[world.scene->shapes[hit.shape].transform];
  const Vec3 smooth = normalize(transform.normal_to_world(own));
  if (max_abs(smooth) == 0) return flat;
  return dot(smooth, ray.direction) > 0 ? -smooth : smooth;
}

}  // namespace

Surface surface_at(const World& world, const MaterialNeeds& needs, const Ray& ray, const Hit& hit,
                   bool follow, Stats& stats) {
  const scene::Scene& scene = *world.scene;
  const scene::Material& m = world.material_of(hit.shape);
  OwnPoint at;
  if (needs.pattern) {
    at = own_point(world, hit.shape, hit.point, pattern_error(world, hit.primitive, hit.point));
  }
  const auto color = [&](const scene::Texture& texture, bool needed) {
    if (texture.pattern == scene::k_none) return texture.color;
    if (!needed) return Color{};
    ++stats.pattern_lookups;
    return color_at(scene.patterns[texture.pattern], at);
  };
  return {shading_normal(world, ray, hit),
          color(m.ambient, needs.ambient),
          color(m.diffuse, needs.diffuse),
          color(m.specular, needs.specular),
          color(m.reflection, needs.reflection && follow),
          color(m.transmission, needs.transmission && follow),
          m.shininess,
          m.fresnel};
}

}  // namespace lancer::tracer
