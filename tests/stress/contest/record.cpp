#include "stress/contest/record.hpp"

#include <cmath>
#include <type_traits>
#include <utility>

namespace lancer::stress::flat {

bool is_wrong(const Truth& truth, const Reported& got) {
  return truth.hit != got.hit || (truth.hit && (truth.face != got.face || truth.entering != got.entering));
}

Record::Record(std::string method, bool in_use) {
  measure_.method = std::move(method);
  measure_.in_use = in_use;
}

bool Record::add(const std::string& set, const Truth& truth, const Reported& got) {
  ++measure_.rays;
  if (is_wrong(truth, got)) {
    ++measure_.wrong;
    ++wrong_[set];
    return false;
  }
  if (!truth.hit) return true;
  const double distance = ulps(got.t, truth.t), point = ulps(got.point, truth.point),
               normal = ulps(got.normal, truth.normal);
  distances_.add(distance);
  worst_[set] = std::max({worst_[set], distance, point, normal});
  point_ = std::max(point_, point);
  normal_ = std::max(normal_, normal);
  return distance <= 1 && point <= 1 && normal <= 1;
}

void Record::add_time(double nanoseconds, double tests) {
  nanoseconds_ += nanoseconds;
  tests_ += tests;
}

Measure Record::measure() const {
  Measure out = measure_;
  out.distance_max = distances_.largest();
  out.distance_999 = distances_.at(0.999);
  if (distances_.count() > 0) {
    out.point_max = point_;
    out.normal_max = normal_;
  }
  if (tests_ > 0) out.nanoseconds = nanoseconds_ / tests_;
  out.set = worst_set();
  return out;
}

/// That with the most wrong answers, else that with the largest error.
std::string Record::worst_set() const {
  const auto largest_of = [](const auto& sets) {
    std::string set;
    typename std::decay_t<decltype(sets)>::mapped_type largest = 0;
    for (const auto& [name, value] : sets) {
      if (!(value > largest)) continue;
      largest = value;
      set = name;
    }
    return set;
  };
  return measure_.wrong > 0 ? largest_of(wrong_) : largest_of(worst_);
}

void add_limits(Outcome& outcome, const Measure& own) {
  if (!std::isnan(own.distance_max)) {
    outcome.limits.push_back({"distance, ulp", own.distance_max, 1});
    outcome.limits.push_back({"point, ulp", own.point_max, 1});
    outcome.limits.push_back({"normal, ulp", own.normal_max, 1});
  }
  outcome.limits.push_back({"wrong hits and misses", static_cast<double>(own.wrong), 0});
}

}  // namespace lancer::stress::flat
