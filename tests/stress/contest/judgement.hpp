#pragma once
// What came of many questions that have one right answer each, asked of the tracer alone.

#include <cstdint>
#include <fmt/format.h>
#include <string>

#include "stress/stress.hpp"
#include "stress/truth/ulp.hpp"

namespace lancer::stress::flat {

class Judgement {
 public:
  /// Returns `right`. `told` makes the text that says how to ask again.
  template <class Told>
  bool check(bool right, const char* set, Told told) {
    ++measure_.rays;
    if (!right) note_of(measure_.wrong, set, told);
    return right;
  }
  /// A ray that leaves a surface: does it meet what it must not?
  template <class Told>
  void check_start(bool met, const char* set, Told told) {
    ++measure_.rays;
    if (met) note_of(measure_.self_hits, set, told);
  }
  /// In ulp.
  void add_distance(double error) { distances_.add(error); }

  Outcome outcome() const;

 private:
  template <class Told>
  void note_of(std::uint64_t& count, const char* set, Told told) {
    ++count;
    if (!note_.empty()) return;
    measure_.set = set;
    note_ = fmt::format("{}: {}", set, told());
  }

  Measure measure_ = measure_in_use("in use");
  Errors distances_;
  std::string note_;
};

}  // namespace lancer::stress::flat
