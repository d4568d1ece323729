#pragma once
// lancer render: a script becomes pictures.

#include <cstdint>
#include <string>

#include "app/command_line.hpp"
#include "app/console.hpp"

namespace lancer::app {

/// What drawing one view took.
struct RenderStats {
  std::string path, view;
  int width = 0, height = 0;
  int samples = 0;          // of each pixel; 0: as many as each needed
  double error = 0;         // asked for; 0: none
  std::uint64_t steps = 0;  // of the script
  std::uint64_t shapes = 0, lights = 0;
  tracer::Stats tracer;
  double total_seconds = 0;  // drawing, encoding and writing
};

/// The exit code.
int render(const RenderCommand& command, const Console& console);

}  // namespace lancer::app
