#pragma once
// Errors in ulp of the true value, and what is said of many of them: the largest, and that of 99.9%.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "stress/truth/number.hpp"

namespace lancer::stress {

/// The spacing of doubles at the size of `value`.
inline Real ulp_at(const Real& value) {
  constexpr int k_least = -1074;
  if (value == 0) return ldexp(Real(1), k_least);
  int exponent = 0;
  frexp(value, &exponent);  // |value| in [2^(exponent-1), 2^exponent)
  return ldexp(Real(1), std::max(exponent - 53, k_least));
}

/// |got - truth| in units of `unit`; NaN and infinity: infinite.
inline double error_in(const Real& unit, double got, const Real& truth) {
  if (!std::isfinite(got)) return std::numeric_limits<double>::infinity();
  return to_double(abs(Real(got) - truth) / unit);
}

/// Of a distance.
inline double ulps(double got, const Real& truth) { return error_in(ulp_at(truth), got, truth); }

/// Of the worst component of a point or a unit normal. A component that all but cancels, less than 2^-40 of
/// the largest, is judged by the largest.
inline double ulps(Vec3 got, const Real3& truth) {
  const Real size = std::max({Real(abs(truth.x)), Real(abs(truth.y)), Real(abs(truth.z))});
  const Real least = ldexp(size, -40);
  double worst = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Real unit = ulp_at(std::max(Real(abs(truth[axis])), least));
    worst = std::max(worst, error_in(unit, got[axis], truth[axis]));
  }
  return worst;
}

/// Errors of many rays.
class Errors {
 public:
  void add(double error) { list_.push_back(error); }
  std::size_t count() const { return list_.size(); }
  /// NaN where there is none.
  double largest() const { return at(1); }
  /// The least error that `share` of the rays keep within.
  double at(double share) const {
    if (list_.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto count = static_cast<double>(list_.size());
    const auto place = static_cast<std::size_t>(std::max(0.0, std::ceil(share * count) - 1));
    std::vector<double> sorted = list_;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(place), sorted.end());
    return sorted[place];
  }

 private:
  std::vector<double> list_;
};

}  // namespace lancer::stress
