#include "image/tone.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include "base/math.hpp"

namespace lancer::image {

namespace {

double exact_code(double light, double codes) { return std::round(math::linear_to_srgb(light) * codes); }

/// The least double whose code is at least `code`: from the inverse curve, then to the exact place, a few
/// units in the last place away.
double least_light(int code) {
  constexpr double beyond = 2;
  double light = math::srgb_to_linear((code - 0.5) / 255);
  while (exact_code(light, 255) >= code) light = std::nextafter(light, 0.0);
  while (exact_code(light, 255) < code) light = std::nextafter(light, beyond);
  return light;
}

/// The sRGB curve by the C library, good to some units in the last place, which differ between machines.
double rough_srgb(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

}  // namespace

ToneCurve::ToneCurve(double exposure) : exposure_(exposure), first_(), cell_() {
  for (int code = 1; code <= 255; ++code) first_[static_cast<std::size_t>(code)] = least_light(code);
  first_[256] = std::numeric_limits<double>::infinity();
  std::size_t code = 0;
  for (std::size_t cell = 0; cell < cell_.size(); ++cell) {
    const double light = static_cast<double>(cell) / k_cells;
    while (first_[code + 1] <= light) ++code;
    cell_[cell] = static_cast<std::uint8_t>(code);
  }
}

std::uint16_t ToneCurve::to_16bit(float light) const {
  const double value = exposed(light);
  const double rough = rough_srgb(value) * 65535;
  const double code = std::round(rough);
  // Only so near to the middle between two codes can the rough curve round the other way.
  const bool doubtful = std::fabs(std::fabs(rough - code) - 0.5) < 1e-6;
  return static_cast<std::uint16_t>(doubtful ? exact_code(value, 65535) : code);
}

}  // namespace lancer::image
