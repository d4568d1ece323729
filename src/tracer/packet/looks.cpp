#include "tracer/packet/looks.hpp"

#include "tracer/pattern.hpp"

namespace lancer::tracer {
namespace {

bool is_smooth(const scene::Scene& scene, std::uint32_t index) {
  const scene::Shape& shape = scene.shapes[index];
  if (shape.kind == scene::ShapeKind::facet) return scene.facets[shape.record].normals != scene::k_none;
  return shape.kind == scene::ShapeKind::mesh && !scene.meshes[shape.record].normals.empty();
}

Ground ground(const World& world, const Primitive& p) {
  switch (p.kind) {
    case Kind::sphere: return Ground::sphere;
    case Kind::facet: return Ground::facet;
    case Kind::box: return world.boxes[p.record].aligned ? Ground::box : Ground::turned_box;
    case Kind::ellipsoid: return Ground::other;
    case Kind::plane: break;
  }
  const int across = world.planes[p.record].across;
  return across < 0 ? Ground::tilted_plane : static_cast<Ground>(static_cast<int>(Ground::plane_x) + across);
}

Paint paint_of(const scene::Scene& scene, const scene::Material& m, const MaterialNeeds& needs) {
  const auto word = [](bool is) { return is ? -1LL : 0LL; };
  return {Color{} + m.ambient.color * scene.settings.ambient,
          m.diffuse.color,
          m.specular.color,
          m.reflection.color,
          m.transmission.color,
          m.shininess,
          word(m.fresnel),
          word(needs.direct),
          word(needs.onward)};
}

}  // namespace

Looks Looks::of(const World& world, const Plan& plan) {
  Looks out;
  const scene::Scene& scene = *world.scene;
  std::vector<bool> plain;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    const MaterialNeeds& needs = plan.needs_of(static_cast<scene::Index>(i));
    out.materials.push_back(paint_of(scene, scene.materials[i], needs));
    plain.push_back(!needs.pattern && !has_pattern(scene.materials[i]));
  }
  out.primitives.reserve(world.primitives.size());
  for (const Primitive& p : world.primitives) {
    const std::uint32_t material = scene.shapes[p.shape].material;
    const bool is_plain = plain[material] && !(p.kind == Kind::facet && is_smooth(scene, p.shape));
    out.primitives.push_back({p.shape, material, ground(world, p), is_plain, is_convex_solid(p.kind)});
  }
  return out;
}

}  // namespace lancer::tracer
