#include "tracer/inventory.hpp"

#include "tracer/pattern.hpp"
#include "tracer/world.hpp"

namespace lancer::tracer {
namespace {

Terms terms_of(const scene::Scene& scene, const scene::Material& m) {
  const auto shows = [&](const scene::Texture& texture) { return !is_black(scene, texture); };
  return {shows(m.ambient), shows(m.diffuse), shows(m.specular),
          shows(m.reflection) || (m.fresnel && shows(m.transmission)), shows(m.transmission)};
}

}  // namespace

Inventory::Inventory(const scene::Scene& scene)
    : wearers(scene.materials.size()), terms(scene.materials.size()) {
  for (scene::Index i = 0; i < scene.shapes.size(); ++i) {
    const scene::Shape& shape = scene.shapes[i];
    const bool is_mesh = shape.kind == scene::ShapeKind::mesh;
    primitives += is_mesh ? scene.meshes[shape.record].faces.size() : 1;
    if (shape.kind != scene::ShapeKind::sphere && shape.kind != scene::ShapeKind::plane) {
      only_spheres_and_planes = false;
    }
    Wearers& worn = wearers[shape.material];
    const auto first = [&](scene::Index& place) {
      if (place == scene::k_none) place = i;
    };
    if (worn.any == scene::k_none) terms[shape.material] = terms_of(scene, scene.materials[shape.material]);
    first(worn.any);
    if (shape.shadow) first(worn.caster);
    if (!encloses(scene, i)) continue;
    first(worn.solid);
    if (!is_mesh) continue;
    first(worn.solid_mesh);
    solid_meshes.push_back(i);
  }
}

}  // namespace lancer::tracer
