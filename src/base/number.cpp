#include "base/number.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace lancer {
namespace {

/// |v| = 0.digits * 10^point, with the fewest digits that read back the same.
struct Decimal {
  std::string digits;
  int point;
};

Decimal shortest(double magnitude) {
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), magnitude, std::chars_format::scientific)
          .ptr;
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  const std::size_t e = text.find('e');
  Decimal out{std::string(text.substr(0, 1)), 0};
  if (e > 1) out.digits += text.substr(2, e - 2);
  const std::size_t first = text[e + 1] == '+' ? e + 2 : e + 1;
  std::from_chars(text.data() + first, text.data() + text.size(), out.point);
  out.point += 1;
  return out;
}

/// Where the point goes and when there is an exponent: ECMA-262, Number::toString.
std::string lay_out(const Decimal& d) {
  const int count = static_cast<int>(d.digits.size());
  const auto at = static_cast<std::size_t>(d.point);
  if (count <= d.point && d.point <= 21) return d.digits + std::string(at - d.digits.size(), '0');
  if (0 < d.point && d.point <= 21) return d.digits.substr(0, at) + "." + d.digits.substr(at);
  if (-6 < d.point && d.point <= 0)
    return "0." + std::string(static_cast<std::size_t>(-d.point), '0') + d.digits;
  const int exponent = d.point - 1;
  std::string out = d.digits.substr(0, 1);
  if (count > 1) out += "." + d.digits.substr(1);
  return out + (exponent < 0 ? "e-" : "e+") + std::to_string(std::abs(exponent));
}

}  // namespace

std::string to_text(double value) {
  if (std::isnan(value)) return "NaN";
  if (value == 0) return "0";
  const std::string sign = value < 0 ? "-" : "";
  if (std::isinf(value)) return sign + "Infinity";
  return sign + lay_out(shortest(std::fabs(value)));
}

std::string to_fixed(double value, int digits) {
  if (!std::isfinite(value)) return to_text(value);
  std::array<char, 512> buffer{};  // 309 digits before the point, at most 100 behind it
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, digits)
          .ptr;
  std::string text(buffer.data(), end);
  if (text[0] == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

}  // namespace lancer
