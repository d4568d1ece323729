#include "stress/contest/judgement.hpp"

namespace lancer::stress::flat {

Outcome Judgement::outcome() const {
  Outcome out;
  Measure measure = measure_;
  measure.distance_max = distances_.largest();
  measure.distance_999 = distances_.at(0.999);
  out.measures.push_back(measure);
  if (distances_.count() > 0) out.limits.push_back({"distance, ulp", measure.distance_max, 1});
  out.limits.push_back({"wrong", static_cast<double>(measure.wrong), 0});
  out.limits.push_back({"self-hits", static_cast<double>(measure.self_hits), 0});
  out.note = note_;
  return out;
}

}  // namespace lancer::stress::flat
