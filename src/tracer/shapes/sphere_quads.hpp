#pragma once
// A short list of spheres, four of them side by side, for scenes that need no tree. One quick look leaves out
// those that a ray surely misses, by the test of sphere.hpp and with its very bits.

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "tracer/processor.hpp"
#include "tracer/shapes/sphere.hpp"

namespace lancer::tracer {

struct alignas(32) SphereQuad {
  std::array<double, 4> x{}, y{}, z{}, radius{};  // of the centres
};

#define LANCER_SPHERE_QUADS(TARGET)                        \
  namespace TARGET {                                       \
  unsigned may_meet(const SphereQuad& quad, const Probe&); \
  }
LANCER_SPHERE_QUADS(baseline)
#if defined(LANCER_HAS_AVX2)
LANCER_SPHERE_QUADS(avx2)
#endif
#undef LANCER_SPHERE_QUADS

/// A bit for each of the four that the test does not leave out at once.
inline unsigned may_meet(const SphereQuad& quad, const Probe& probe) {
#if defined(LANCER_HAS_AVX2)
  if (k_use_avx2) return avx2::may_meet(quad, probe);
#endif
  return baseline::may_meet(quad, probe);
}

/// Spheres by number.
class SphereQuads {
 public:
  void add(const SpherePrimitive& sphere, std::uint32_t number) {
    const std::size_t lane = numbers_.size() % 4;
    if (lane == 0) quads_.emplace_back();
    SphereQuad& quad = quads_.back();
    quad.x[lane] = sphere.center.x;
    quad.y[lane] = sphere.center.y;
    quad.z[lane] = sphere.center.z;
    quad.radius[lane] = sphere.radius;
    numbers_.push_back(number);
  }

  const std::vector<std::uint32_t>& numbers() const { return numbers_; }

  /// Calls visit(number) for all that the ray may meet, until it returns true (then so does this).
  template <class Visit>
  bool each(const Probe& probe, const Visit& visit) const {
    for (std::size_t i = 0; i < quads_.size(); ++i) {
      const unsigned used = numbers_.size() - 4 * i >= 4 ? 0xF : (1U << (numbers_.size() - 4 * i)) - 1;
      for (unsigned left = may_meet(quads_[i], probe) & used; left != 0; left &= left - 1) {
        if (visit(numbers_[4 * i + static_cast<std::size_t>(std::countr_zero(left))])) return true;
      }
    }
    return false;
  }

 private:
  std::vector<SphereQuad> quads_;
  std::vector<std::uint32_t> numbers_;
};

}  // namespace lancer::tracer
