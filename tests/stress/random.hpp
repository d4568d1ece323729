#pragma once
// Random numbers by fixed hashes: those of a ray follow from the seed, the name of its set and its number
// alone, so any of them can be made again, on any machine and in any order. Compilers evaluate arguments and
// operands in orders of their own: use one random number an expression, or put them into braces.

#include <cmath>
#include <cstdint>
#include <string_view>

#include "base/vec.hpp"

namespace lancer::stress {

/// The finalizer of splitmix64 (Steele, Lea, Flood 2014).
constexpr std::uint64_t mix(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

/// A number for a name (FNV-1a).
constexpr std::uint64_t hash_of(std::string_view name) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  return hash;
}

class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t set, std::uint64_t ray)
      : state_(mix(mix(mix(seed + k_step) ^ set) + ray * k_step)) {}
  Random(std::uint64_t seed, std::string_view set, std::uint64_t ray) : Random(seed, hash_of(set), ray) {}

  std::uint64_t bits() { return mix(state_ += k_step); }
  /// In [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// In [low, high), each binade as likely as the next; both > 0.
  double over_scales(double low, double high) {
    for (;;) {
      const int first = std::ilogb(low), last = std::ilogb(high);
      const double significand = 1 + unit();
      const double value = std::scalbn(significand, first + below(last - first + 1));
      if (value >= low && value < high) return value;
    }
  }
  /// The same, of either sign.
  double signed_over_scales(double low, double high) {
    const double side = sign();
    return side * over_scales(low, high);
  }
  /// 0 .. count - 1.
  int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }
  double sign() { return (bits() & 1) != 0 ? 1 : -1; }
  Vec3 in_cube(double half) {
    const double x = between(-half, half), y = between(-half, half), z = between(-half, half);
    return {x, y, z};
  }
  Vec3 in_ball() {
    for (;;) {
      const Vec3 v = in_cube(1);
      if (dot(v, v) <= 1) return v;
    }
  }
  /// Of unit length, within rounding; all directions are as likely.
  Vec3 direction() {
    for (;;) {
      const Vec3 v = in_ball();
      if (dot(v, v) > 0.01) return normalize(v);
    }
  }
  /// Of unit length, at right angles to `axis`, both within rounding.
  Vec3 across(Vec3 axis) {
    for (;;) {
      const Vec3 v = cross(axis, direction());
      if (dot(v, v) > 0.01 * dot(axis, axis)) return normalize(v);
    }
  }

 private:
  static constexpr std::uint64_t k_step = 0x9E3779B97F4A7C15ULL;
  std::uint64_t state_;
};

}  // namespace lancer::stress
