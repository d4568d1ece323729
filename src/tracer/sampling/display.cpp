#include "tracer/sampling/display.hpp"

#include "base/math.hpp"

namespace lancer::tracer {

Display::Display(double exposure) : scale_(static_cast<float>(exposure * k_cells)), table_() {
  for (std::size_t i = 0; i < table_.size(); ++i) {
    table_[i] = static_cast<float>(math::linear_to_srgb(static_cast<double>(i) / k_cells));
  }
}

}  // namespace lancer::tracer
