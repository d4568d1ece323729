#pragma once
// The colour of things that glow.

#include "base/color.hpp"

namespace lancer::lang {

/// The colour of a black body of a temperature in kelvin (> 0): Planck's law, seen by the CIE 1931 standard
/// observer, in linear Rec. 709 primaries, what lies outside of them clipped, the largest component 1.
Color blackbody(double kelvin);

}  // namespace lancer::lang
