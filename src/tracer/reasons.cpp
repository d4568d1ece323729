// The words of a plan's decisions.

#include <cstring>

#include "tracer/plan.hpp"

namespace lancer::tracer {
namespace {

const char* kind_of(const scene::Shape& shape) {
  switch (shape.kind) {
    case scene::ShapeKind::sphere: return "sphere";
    case scene::ShapeKind::plane: return "plane";
    case scene::ShapeKind::box: return "box";
    case scene::ShapeKind::facet: return "facet";
    case scene::ShapeKind::mesh: return "mesh";
  }
  return "";
}

const char* kind_of(const scene::Light& light) {
  switch (light.kind) {
    case scene::LightKind::point: return "light";
    case scene::LightKind::sun: return "sun";
    case scene::LightKind::spot: return "spot";
  }
  return "";
}

/// By its name, or as a listing counts those of its kind without one.
template <class T>
std::string label(const scene::Scene& scene, const std::vector<T>& all, scene::Index index) {
  if (all[index].name != 0) return "`" + scene.names[all[index].name] + "`";
  std::size_t number = 0;
  for (scene::Index i = 0; i <= index; ++i) {
    if (all[i].name == 0 && std::strcmp(kind_of(all[i]), kind_of(all[index])) == 0) ++number;
  }
  return std::string(kind_of(all[index])) + " " + std::to_string(number);
}

std::string label(const scene::Scene& scene, const Thing& thing) {
  return thing.kind == Thing::Kind::shape ? label(scene, scene.shapes, thing.index)
                                          : label(scene, scene.lights, thing.index);
}

std::string listed(const scene::Scene& scene, const Decision& decision) {
  std::string out;
  const std::size_t named = decision.things.size(), more = decision.count - named;
  for (std::size_t i = 0; i < named; ++i) {
    if (i > 0) out += more == 0 && i + 1 == named ? " and " : ", ";
    out += label(scene, decision.things[i]);
  }
  return more == 0 ? out : out + " and " + std::to_string(more) + " more";
}

}  // namespace

std::string in_words(const scene::Scene& scene, const Decision& decision) {
  std::string out = decision.reason;
  const std::size_t place = out.find("{}");
  if (place != std::string::npos) out.replace(place, 2, listed(scene, decision));
  return out;
}

}  // namespace lancer::tracer
