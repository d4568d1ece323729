#include "tracer/tree/grid.hpp"

#include <algorithm>
#include <cmath>

namespace lancer::tracer {
namespace {

constexpr double k_largest = 0x1p1000;

/// What is rounded to a float of at most 1/2 is off by 2^-26 at most, and so is its difference from 2^-24.
constexpr float k_outward = 0x1p-24F;

constexpr double k_half_grid = 32760;

}  // namespace

Aabb tamed(const Aabb& box) {
  Aabb out;
  for (int axis = 0; axis < 3; ++axis) {
    // A comparison with what is no number is false.
    out.lo[axis] = box.lo[axis] > -k_largest ? std::min(box.lo[axis], k_largest) : -k_largest;
    out.hi[axis] = box.hi[axis] < k_largest ? std::max(box.hi[axis], -k_largest) : k_largest;
  }
  return out;
}

Frame frame_around(const Aabb& bounds) {
  const Vec3 center = bounds.center();
  const double half = std::max(max_abs(bounds.hi - center), max_abs(center - bounds.lo));
  int exponent = half > 0 ? std::ilogb(half) + 2 : -1000;
  // Where all is one point, as far as doubles can tell.
  if (max_abs(center) > 0) exponent = std::max(exponent, std::ilogb(max_abs(center)) - 52);
  exponent = std::clamp(exponent, -1000, 1010);
  return {center, std::ldexp(1.0, -exponent), 0};
}

FrameBox in_frame(const Frame& frame, const Aabb& box) {
  FrameBox out;
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = static_cast<int>(i);
    out.lo[i] = static_cast<float>((box.lo[axis] - frame.origin[axis]) * frame.inverse_scale) - k_outward;
    out.hi[i] = static_cast<float>((box.hi[axis] - frame.origin[axis]) * frame.inverse_scale) + k_outward;
  }
  return out;
}

Grid::Grid(const Aabb& bounds) : center_(bounds.center()) {
  const Vec3 half = bounds.hi * 0.5 - bounds.lo * 0.5;
  const double largest = max_abs(half);
  const double scale = largest > 0 ? std::min(k_half_grid / largest, 0x1p1000) : 0;
  per_cell_ = {scale, scale, scale};
}

std::array<std::int16_t, 6> Grid::sides(const Aabb& box) const {
  std::array<std::int16_t, 6> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = static_cast<int>(i);
    const auto side = [&](double at) {
      const double cell = (at - center_[axis]) * per_cell_[axis];
      return static_cast<std::int16_t>(std::clamp(cell, -k_half_grid, k_half_grid));
    };
    out[i] = side(box.lo[axis]);
    out[i + 3] = side(box.hi[axis]);
  }
  return out;
}

}  // namespace lancer::tracer
