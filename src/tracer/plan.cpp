#include "tracer/plan.hpp"

#include <algorithm>

#include "tracer/pattern.hpp"
#include "tracer/world.hpp"

namespace lancer::tracer {
namespace {

template <class Test>
bool any_shape(const scene::Scene& scene, Test test) {
  return std::any_of(scene.shapes.begin(), scene.shapes.end(),
                     [&](const scene::Shape& shape) { return test(shape, scene.materials[shape.material]); });
}

bool any_transmission(const scene::Scene& scene, bool casters_only) {
  return any_shape(scene, [&](const scene::Shape& shape, const scene::Material& material) {
    return (shape.shadow || !casters_only) && !is_black(scene, material.transmission);
  });
}

bool any_other_index(const scene::Scene& scene) {
  for (std::uint32_t shape = 0; shape < scene.shapes.size(); ++shape) {
    const double ior = scene.materials[scene.shapes[shape].material].ior;
    if (encloses(scene, shape) && ior != scene.settings.ior) return true;
  }
  return false;
}

void plan_shadows(const scene::Scene& scene, Plan& plan) {
  const bool any_caster =
      any_shape(scene, [](const scene::Shape& shape, const auto&) { return shape.shadow; });
  if (scene.settings.shadows == scene::Shadows::off) {
    plan.shadows = ShadowWork::none;
    plan.reasons.emplace_back("no shadow rays: the settings turn shadows off");
  } else if (scene.lights.empty()) {
    plan.shadows = ShadowWork::none;
    plan.reasons.emplace_back("no shadow rays: there is no light");
  } else if (!any_caster) {
    plan.shadows = ShadowWork::none;
    plan.reasons.emplace_back("no shadow rays: no shape casts a shadow");
  } else if (scene.settings.shadows == scene::Shadows::opaque) {
    plan.shadows = ShadowWork::blocked;
    plan.reasons.emplace_back("shadow rays stop at the first surface: the settings make all shadows opaque");
  } else if (!any_transmission(scene, true)) {
    plan.shadows = ShadowWork::blocked;
    plan.reasons.emplace_back("shadow rays stop at the first surface: no shape lets light through");
  }
}

}  // namespace

Plan plan(const scene::Scene& scene, const scene::View&, const Options&) {
  Plan plan;
  plan_shadows(scene, plan);
  plan.transmits = any_transmission(scene, false);
  plan.reflects = any_shape(scene, [&](const scene::Shape&, const scene::Material& material) {
    return !is_black(scene, material.reflection) ||
           (material.fresnel && !is_black(scene, material.transmission));
  });
  if (!plan.reflects) plan.reasons.emplace_back("no reflected rays: no material reflects");
  if (!plan.transmits) plan.reasons.emplace_back("no transmitted rays: no material lets light through");
  plan.media = plan.transmits && any_other_index(scene);
  if (plan.transmits && !plan.media) {
    plan.reasons.emplace_back("no lists of open solids: all refractive indices are the same");
  }
  return plan;
}

}  // namespace lancer::tracer
