#pragma once
// Colours in linear light, Rec. 709 primaries. Components are not bounded: radiance may exceed 1.

#include <algorithm>

namespace lancer {

struct Color {
  double r = 0, g = 0, b = 0;
  friend constexpr bool operator==(const Color&, const Color&) = default;
};

constexpr Color grey(double level) { return {level, level, level}; }
constexpr Color operator+(Color a, Color b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
constexpr Color operator-(Color a, Color b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
constexpr Color operator*(Color a, Color b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
constexpr Color operator*(Color a, double s) { return {a.r * s, a.g * s, a.b * s}; }
constexpr Color operator*(double s, Color a) { return a * s; }
constexpr Color& operator+=(Color& a, Color b) { return a = a + b; }
constexpr double max_component(Color c) { return std::max({c.r, c.g, c.b}); }
constexpr bool is_black(Color c) { return c.r == 0 && c.g == 0 && c.b == 0; }

}  // namespace lancer
