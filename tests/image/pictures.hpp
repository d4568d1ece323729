#pragma once
// Small images for the tests of the formats.

#include <algorithm>
#include <initializer_list>

#include "image/image.hpp"

/// An image of these values, row by row from the top.
inline lancer::image::Image make_image(int width, int height, std::initializer_list<float> values) {
  lancer::image::Image image(width, height);
  auto next = values.begin();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (float& channel : image.pixel(x, y)) channel = *next++;
    }
  }
  return image;
}

/// An image in which every value differs: value i is i / 64 (exact as a float), so the first are dark and the
/// later ones brighter than white.
inline lancer::image::Image make_ramp(int width, int height) {
  lancer::image::Image image(width, height);
  float next = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (float& channel : image.pixel(x, y)) {
        channel = next;
        next += 1.0F / 64;
      }
    }
  }
  return image;
}
