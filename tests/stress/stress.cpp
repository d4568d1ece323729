#include "stress/stress.hpp"

#include <limits>
#include <utility>

namespace lancer::stress {

namespace {
constexpr double k_unknown = std::numeric_limits<double>::quiet_NaN();
}

Measure::Measure()
    : distance_max(k_unknown),
      distance_999(k_unknown),
      point_max(k_unknown),
      normal_max(k_unknown),
      nanoseconds(k_unknown) {}

Measure measure_in_use(std::string method, std::uint64_t rays, std::uint64_t wrong, std::uint64_t in_band) {
  Measure measure;
  measure.method = std::move(method);
  measure.in_use = true;
  measure.rays = rays;
  measure.wrong = wrong;
  measure.in_band = in_band;
  return measure;
}

bool Outcome::met() const {
  for (const Limit& limit : limits) {
    if (!limit.met()) return false;
  }
  return true;
}

bool matches(std::string_view pattern, std::string_view name) {
  if (pattern.empty()) return name.empty();
  if (pattern.front() == '*') {
    return matches(pattern.substr(1), name) || (!name.empty() && matches(pattern, name.substr(1)));
  }
  return !name.empty() && (pattern.front() == '?' || pattern.front() == name.front()) &&
         matches(pattern.substr(1), name.substr(1));
}

}  // namespace lancer::stress
