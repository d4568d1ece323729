#pragma once
// Light as it is shown, as near as an estimate of errors needs it.

#include <array>

#include "base/color.hpp"

namespace lancer::tracer {

/// Linear light times exposure, clamped to [0, 1], sRGB-encoded, from a table: off by less than 1e-4.
class Display {
 public:
  /// `exposure` is positive.
  explicit Display(double exposure);

  float shown(float light) const {
    const float at = light * scale_;
    if (!(at > 0)) return 0;
    if (at >= k_cells) return 1;
    const int cell = static_cast<int>(at);
    const float low = table_[static_cast<std::size_t>(cell)];
    return low + (table_[static_cast<std::size_t>(cell) + 1] - low) * (at - static_cast<float>(cell));
  }

  /// By how much what is shown of `light` changes, at the most, where that changes by `error` up or down.
  float change(double light, double error) const {
    const float here = shown(static_cast<float>(light));
    const float up = shown(static_cast<float>(light + error)) - here,
                down = here - shown(static_cast<float>(light - error));
    return up > down ? up : down;
  }

 private:
  static constexpr int k_cells = 2048;

  float scale_;
  std::array<float, k_cells + 1> table_;
};

}  // namespace lancer::tracer
