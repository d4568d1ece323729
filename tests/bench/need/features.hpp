#pragma once
// A plain scene, and what may be added to it: some of it shows in the picture, some does not.

#include <string>
#include <vector>

#include "tracer/render.hpp"

namespace lancer::need {

/// Something to add to a scene.
struct Feature {
  std::string name;
  std::string script;  // statements
  bool shows = false;  // the picture is another one with it
};

/// In the order in which they are added, those that do not show first.
const std::vector<Feature>& features();

/// The plain scene: a floor, a wall, a row of balls before it, a lamp.
std::string plain_script();

/// What drawing a script took.
struct Drawn {
  tracer::Stats stats;
  std::vector<float> picture;
  double script_seconds = 0;
};

/// The script's first view, small, on one thread, to an error of 0.01.
Drawn draw(const std::string& script, int columns, int rows, int samples);

}  // namespace lancer::need
