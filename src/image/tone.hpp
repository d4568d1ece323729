#pragma once
// The tone curve, here and nowhere else: linear light times exposure, clamped to [0, 1], sRGB-encoded and
// rounded to the nearest code. Exact: every code is the one that math::linear_to_srgb gives, by way of tables
// or short cuts.

#include <array>
#include <cstddef>
#include <cstdint>

namespace lancer::image {

class ToneCurve {
 public:
  /// `exposure` is positive.
  explicit ToneCurve(double exposure);

  /// The 8-bit code of linear light; no number counts as black.
  std::uint8_t to_8bit(float light) const {
    const double value = exposed(light);
    const std::size_t code = cell_[static_cast<std::size_t>(value * k_cells)];
    return static_cast<std::uint8_t>(value >= first_[code + 1] ? code + 1 : code);
  }

  /// The 16-bit code of linear light; no number counts as black.
  std::uint16_t to_16bit(float light) const;

 private:
  // The darkest codes lie 1 / (255 * 12.92) apart in linear light, brighter ones farther: no cell of 1/4096
  // holds two of the places where the code changes.
  static constexpr int k_cells = 4096;

  double exposed(float light) const {
    const double value = light * exposure_;
    if (!(value > 0)) return 0;  // no number, too
    return value < 1 ? value : 1;
  }

  double exposure_;
  std::array<double, 257> first_;  // the least light that has the code; beyond the last, infinity
  std::array<std::uint8_t, k_cells + 1> cell_;  // the code at a cell's lower end
};

}  // namespace lancer::image
