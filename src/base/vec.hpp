#pragma once
// Three doubles: points, directions and offsets in right-handed space. Arithmetic is component by component.

#include <cmath>

namespace lancer {

struct Vec3 {
  double x = 0, y = 0, z = 0;

  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
  constexpr double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(Vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vec3 operator*(double s, Vec3 a) { return a * s; }
constexpr Vec3 operator/(Vec3 a, double s) { return {a.x / s, a.y / s, a.z / s}; }

constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// As std::fmax: of a number and NaN, the number.
constexpr double larger(double a, double b) { return b > a || a != a ? b : a; }
inline double max_abs(Vec3 a) { return larger(std::fabs(a.x), larger(std::fabs(a.y), std::fabs(a.z))); }
inline Vec3 times_power_of_two(Vec3 a, int exponent) {
  return {std::scalbn(a.x, exponent), std::scalbn(a.y, exponent), std::scalbn(a.z, exponent)};
}
inline bool is_finite(Vec3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

/// Squares of lengths far from both ends of the range of numbers: nothing that counts in such a sum over- or
/// underflows. Not for NaN.
constexpr bool is_safe_square(double square) { return square >= 0x1p-800 && square <= 0x1p800; }

/// For the others a power of two is taken out first, so that they neither overflow nor underflow while the
/// result itself is representable. Where both ways go, the bits are the same.
double scaled_length(Vec3 a);
Vec3 scaled_normalize(Vec3 a);

/// The Euclidean length, for any vector, however long or short.
inline double length(Vec3 a) {
  const double square = dot(a, a);
  return is_safe_square(square) ? std::sqrt(square) : scaled_length(a);
}

/// The unit vector along `a`, for any finite `a` that is not zero, however long or short.
inline Vec3 normalize(Vec3 a) {
  const double square = dot(a, a);
  return is_safe_square(square) ? a / std::sqrt(square) : scaled_normalize(a);
}

}  // namespace lancer
