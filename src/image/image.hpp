#pragma once
// A picture: linear light, three floats a pixel, rows from the top.

#include <cstddef>
#include <span>
#include <vector>

#include "base/color.hpp"

namespace lancer::image {

class Image {
 public:
  Image() = default;
  Image(int width, int height)
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3) {}

  int width() const { return width_; }
  int height() const { return height_; }

  /// r, g, b of the pixel in column x from the left and row y from the top.
  std::span<float, 3> pixel(int x, int y) { return std::span<float, 3>(pixels_.data() + offset(x, y), 3); }
  std::span<const float, 3> pixel(int x, int y) const {
    return std::span<const float, 3>(pixels_.data() + offset(x, y), 3);
  }
  std::span<const float> row(int y) const {
    return std::span<const float>(pixels_).subspan(offset(0, y), static_cast<std::size_t>(width_) * 3);
  }
  const std::vector<float>& data() const { return pixels_; }

 private:
  std::size_t offset(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) * 3;
  }
  int width_ = 0;
  int height_ = 0;
  std::vector<float> pixels_;
};

}  // namespace lancer::image
