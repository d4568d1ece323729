#pragma once
// Colours into pictures.

#include <algorithm>
#include <limits>

#include "base/color.hpp"
#include "image/image.hpp"

namespace lancer::tracer {

/// What is too large for a float becomes the largest one.
inline void put(image::Image& image, int x, int y, Color color) {
  const auto as_float = [](double radiance) {
    return static_cast<float>(std::min(radiance, static_cast<double>(std::numeric_limits<float>::max())));
  };
  const auto out = image.pixel(x, y);
  out[0] = as_float(color.r);
  out[1] = as_float(color.g);
  out[2] = as_float(color.b);
}

}  // namespace lancer::tracer
