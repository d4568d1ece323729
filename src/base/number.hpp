#pragma once
// Numbers as text.

#include <string>

namespace lancer {

/// The fewest digits that read back the same, as JavaScript prints a number: no exponent for 1e-6 <= |v| <
/// 1e21, "1e+21", "1.5e-7" beyond; never "-0".
std::string to_text(double value);

/// With exactly `digits` (0..100) digits after the point, the exact value correctly rounded (halves to even);
/// never "-0.00".
std::string to_fixed(double value, int digits);

}  // namespace lancer
