#pragma once
// From a script to its scene, for the tests of what blocks mean.

#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "scene/scene.hpp"

namespace lancer::lang {

struct Built {
  scene::Scene scene;
  std::vector<std::string>
      messages;  // "E013 [-1] a sphere's radius is positive; this one is -1": the span's text in brackets
};

Built build(const std::string& text);

/// The scene of a script without mistakes and warnings.
scene::Scene scene_of(const std::string& text);
/// The one message of a script.
std::string refusal(const std::string& text);
bool is_near(Vec3 a, Vec3 b, double tolerance = 1e-12);

}  // namespace lancer::lang
