#pragma once
// Arguments for tests: the same ones on every machine.

#include <cmath>
#include <cstdint>

namespace lancer {

/// S. Vigna's splitmix64.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
  }
  /// In [lo, hi).
  double uniform(double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  /// Whole, in [lo, hi].
  int whole(int lo, int hi) {
    return lo + static_cast<int>(bits() % static_cast<std::uint64_t>(hi - lo + 1));
  }
  /// Of either sign, all sizes from 2^lo to 2^hi alike.
  double of_any_size(int lo, int hi) {
    const double significand = uniform(1, 2);  // first: the order of arguments is the compiler's choice
    const double size = std::ldexp(significand, whole(lo, hi - 1));
    return (bits() & 1) != 0 ? size : -size;
  }

 private:
  std::uint64_t state_;
};

}  // namespace lancer
