#pragma once
// Scene + View + options -> Image: the shared ray tracer's one verb.

#include "image/image.hpp"
#include "scene/scene.hpp"
#include "tracer/options.hpp"

namespace lancer::tracer {

struct Rendered {
  image::Image image;
  Stats stats;
  bool cancelled = false;
};

/// Renders `view` of `scene`. The image is the same bytes for any number of threads and any order of tiles.
/// Never throws but for want of memory.
Rendered render(const scene::Scene& scene, const scene::View& view, const Options& options = {},
                const Watch& watch = {});

}  // namespace lancer::tracer
