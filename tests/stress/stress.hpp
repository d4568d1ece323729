#pragma once
// What the stress program measures and how it judges: rows by name, each with what every method did on the
// same rays and the limits that the one in use must keep.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace lancer::stress {

struct Settings {
  bool full = false;       // --long: the full counts; else what fits into the everyday suite
  std::uint64_t seed = 1;  // of every random part; the same seed gives the same rays
};

/// What one method did on a row's rays. Errors are in ulp of the true value; NaN: not measured here.
struct Measure {
  std::string method;      // "naive", "double-double", ...
  bool in_use = false;     // what the tracer does
  std::string set;         // the one of the row's sets of rays that has the worst of these; empty: only one
  std::uint64_t rays = 0;  // that were judged; 0: only timed
  double distance_max, distance_999;  // of the reported distance: the largest, and that of 99.9% of the rays
  double point_max, normal_max;       // of the worst component
  std::uint64_t wrong = 0;            // hit for miss, miss for hit, or another surface than the true one
  std::uint64_t in_band = 0;    // of these, such that a change of the input within 4 ulp would make right
  std::uint64_t leaks = 0;      // went through an edge or corner that surfaces share
  std::uint64_t self_hits = 0;  // met the surface it left where it left it
  double nanoseconds;           // a test
  Measure();
};

/// Of what the tracer does, with nothing measured but these.
Measure measure_in_use(std::string method, std::uint64_t rays = 0, std::uint64_t wrong = 0,
                       std::uint64_t in_band = 0);

/// A goal: `value` is at most `limit`.
struct Limit {
  std::string what;
  double value = 0, limit = 0;
  bool met() const { return value <= limit; }  // NaN is not
};

struct Outcome {
  std::vector<Measure> measures;
  std::vector<Limit> limits;
  std::string note;  // one line, or none
  bool met() const;  // all of them
};

struct Row {
  std::string name;   // "sphere.grazing"
  std::string about;  // one line
  std::function<Outcome(const Settings&)> run;
};
using Rows = std::vector<Row>;

/// Is the name what the pattern means: * any characters, ? any one?
bool matches(std::string_view pattern, std::string_view name);

}  // namespace lancer::stress
