#include "lang/blackbody.hpp"

#include <algorithm>
#include <array>

#include "base/math.hpp"
#include "base/vec.hpp"

namespace lancer::lang {
namespace {

constexpr double k_shortest = 380;  // nm
constexpr double k_longest = 780;
constexpr double k_interval = 10;
constexpr double k_second_radiation = 1.438776877e7;  // hc/k in nm K (CODATA 2018)

/// The colour matching functions of the CIE 1931 standard observer.
constexpr std::array<Vec3, 41> k_observer{{
    {0.0014, 0.0000, 0.0065}, {0.0042, 0.0001, 0.0201}, {0.0143, 0.0004, 0.0679}, {0.0435, 0.0012, 0.2074},
    {0.1344, 0.0040, 0.6456}, {0.2839, 0.0116, 1.3856}, {0.3483, 0.0230, 1.7471}, {0.3362, 0.0380, 1.7721},
    {0.2908, 0.0600, 1.6692}, {0.1954, 0.0910, 1.2876}, {0.0956, 0.1390, 0.8130}, {0.0320, 0.2080, 0.4652},
    {0.0049, 0.3230, 0.2720}, {0.0093, 0.5030, 0.1582}, {0.0633, 0.7100, 0.0782}, {0.1655, 0.8620, 0.0422},
    {0.2904, 0.9540, 0.0203}, {0.4334, 0.9950, 0.0087}, {0.5945, 0.9950, 0.0039}, {0.7621, 0.9520, 0.0021},
    {0.9163, 0.8700, 0.0017}, {1.0263, 0.7570, 0.0011}, {1.0622, 0.6310, 0.0008}, {1.0026, 0.5030, 0.0003},
    {0.8544, 0.3810, 0.0002}, {0.6424, 0.2650, 0.0000}, {0.4479, 0.1750, 0.0000}, {0.2835, 0.1070, 0.0000},
    {0.1649, 0.0610, 0.0000}, {0.0874, 0.0320, 0.0000}, {0.0468, 0.0170, 0.0000}, {0.0227, 0.0082, 0.0000},
    {0.0114, 0.0041, 0.0000}, {0.0058, 0.0021, 0.0000}, {0.0029, 0.0010, 0.0000}, {0.0014, 0.0005, 0.0000},
    {0.0007, 0.0002, 0.0000}, {0.0003, 0.0001, 0.0000}, {0.0002, 0.0001, 0.0000}, {0.0001, 0.0000, 0.0000},
    {0.0000, 0.0000, 0.0000},
}};

/// 1 - e^-x for x > 0, without cancellation.
double one_minus_exp(double x) { return x < 1e-5 ? x - x * x / 2 : 1 - math::exp(-x); }

/// Planck's law at a wavelength in nm, as a share of the radiance at the longest one, which is out of the way
/// of under- and overflow.
double relative_radiance(double wavelength, double kelvin) {
  const double x = k_second_radiation / wavelength / kelvin;
  const double x_longest = k_second_radiation / k_longest / kelvin;
  const double ratio = k_longest / wavelength;
  const double fifth = ratio * ratio * ratio * ratio * ratio;
  return fifth * math::exp(x_longest - x) * one_minus_exp(x_longest) / one_minus_exp(x);
}

/// CIE XYZ to linear Rec. 709 with white D65.
Color to_rec709(Vec3 xyz) {
  return {dot({3.2404542, -1.5371385, -0.4985314}, xyz), dot({-0.9692660, 1.8760108, 0.0415560}, xyz),
          dot({0.0556434, -0.2040259, 1.0572252}, xyz)};
}

}  // namespace

Color blackbody(double kelvin) {
  // Beyond these the colour does not change any more, and the ratios would leave the range of numbers.
  const double t = std::clamp(kelvin, 100.0, 1e12);
  Vec3 xyz;
  for (std::size_t i = 0; i < k_observer.size(); ++i) {
    const double wavelength = k_shortest + k_interval * static_cast<double>(i);
    xyz = xyz + k_observer[i] * relative_radiance(wavelength, t);
  }
  const Color c = to_rec709(xyz);
  const double largest = max_component(c);
  return {std::max(c.r, 0.0) / largest, std::max(c.g, 0.0) / largest, std::max(c.b, 0.0) / largest};
}

}  // namespace lancer::lang
