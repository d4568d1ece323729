#pragma once
// What is asked of a pixel.

#include "tracer/sampling/display.hpp"

namespace lancer::tracer {

struct Demand {
  const Display* display = nullptr;  // how light is shown
  double error = 0;                  // the most that a pixel may be off, display units
};

}  // namespace lancer::tracer
