#pragma once
// Scene + View + options -> Image: the shared ray tracer's one verb.

#include "image/image.hpp"
#include "scene/scene.hpp"
#include "tracer/options.hpp"

namespace lancer::tracer {

/// The samples of a picture that is drawn to an error and in which no pixel is in doubt: those of the first
/// look. The size in pixels; none has none.
std::uint64_t least_samples(std::uint64_t columns, std::uint64_t rows);

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
