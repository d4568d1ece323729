#pragma once
// What one method said about the rays of a row against the truth, and how long it took.

#include <algorithm>
#include <limits>
#include <map>
#include <string>

#include "stress/contest/clock.hpp"
#include "stress/stress.hpp"
#include "stress/truth/facet.hpp"
#include "stress/truth/ulp.hpp"

namespace lancer::stress::flat {

/// What a method reported.
struct Reported {
  bool hit = false;
  double t = 0;
  Vec3 point, normal;
  int face = 0;
  bool entering = false;
};

/// Is it another meeting than the true one, however accurate?
bool is_wrong(const Truth& truth, const Reported& got);

/// One method's record over all sets of a row.
class Record {
 public:
  Record(std::string method, bool in_use);

  /// Is it right, and within 1 ulp?
  bool add(const std::string& set, const Truth& truth, const Reported& got);
  void add_in_band() { ++measure_.in_band; }
  void add_time(double nanoseconds, double tests);

  std::uint64_t wrong() const { return measure_.wrong; }
  Measure measure() const;

 private:
  std::string worst_set() const;

  Measure measure_;
  Errors distances_;
  double point_ = 0, normal_ = 0, nanoseconds_ = 0, tests_ = 0;
  std::map<std::string, double> worst_;
  std::map<std::string, std::uint64_t> wrong_;
};

/// The least time of some runs of `work`, which makes `tests` tests.
template <class Work>
void time_into(Record& record, std::size_t tests, Work work) {
  constexpr int k_runs = 3;
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < k_runs; ++run) {
    const double start = now_in_nanoseconds();
    work();
    least = std::min(least, now_in_nanoseconds() - start);
  }
  record.add_time(least, static_cast<double>(tests));
}

/// What the tracer's own must keep on every row. Where nothing was to be hit there are no errors to judge.
void add_limits(Outcome& outcome, const Measure& own);

}  // namespace lancer::stress::flat
