#include "tracer/lights_in_reach.hpp"

#include <algorithm>
#include <limits>

#include "tracer/brightness.hpp"

namespace lancer::tracer {
namespace {

/// The largest sum of two coefficients of one material that some shape wears.
template <class First, class Second>
double largest_sum(const scene::Scene& scene, const Inventory& has, First first, Second second) {
  double most = 0;
  for (std::size_t m = 0; m < has.wearers.size(); ++m) {
    const scene::Material& material = scene.materials[m];
    if (has.wearers[m].any != scene::k_none)
      most =
          std::max(most, max_component(largest(scene, material.*first) + largest(scene, material.*second)));
  }
  return most;
}

/// What all surfaces that a ray sees, one in another, may count together, where each by itself counts 1.
double most_surfaces(const scene::Scene& scene, const Inventory& has, int depth) {
  const double onward = largest_sum(scene, has, &scene::Material::reflection, &scene::Material::transmission);
  double sum = 1, term = 1;
  for (int i = 0; i < depth; ++i) {
    term *= onward;
    sum += term;
    if (sum > 1e9) return std::numeric_limits<double>::infinity();
    // What is still to come is a geometric series of no more than the sum so far, times the term.
    if (term < 1e-9) return sum * (1 + 1e-6);
  }
  return sum;
}

}  // namespace

std::vector<scene::Index> dark_lights(const scene::Scene& scene, const Extent* extent) {
  std::vector<scene::Index> out;
  for (scene::Index i = 0; i < scene.lights.size(); ++i) {
    const scene::Light& light = scene.lights[i];
    const bool misses = extent && light.kind == scene::LightKind::spot && !extent->may_be_lit_by(light);
    if (is_black(light.color) || misses) out.push_back(i);
  }
  return out;
}

double most_sent(const scene::Scene& scene, const Inventory& has, int depth) {
  return most_surfaces(scene, has, depth) *
         largest_sum(scene, has, &scene::Material::diffuse, &scene::Material::specular);
}

}  // namespace lancer::tracer
