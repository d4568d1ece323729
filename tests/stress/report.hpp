#pragma once
// What the rows found, for people and for programs.

#include <string>
#include <vector>

#include "stress/stress.hpp"

namespace lancer::stress {

/// A row that was run.
struct Report {
  std::string name, about;
  Outcome outcome;
  double seconds = 0;
  std::string failure;  // why it could not be run; empty: it was

  bool met() const { return failure.empty() && outcome.met(); }
};

/// A few lines: a title, the columns, a line a method (>: in use), and the limits met and missed.
std::string as_table(const Report& report, bool colored);
/// The last line.
std::string summary(const std::vector<Report>& reports, bool colored);
/// One object with everything. Infinite numbers are the text "inf", what was not measured is null.
std::string as_json(const std::vector<Report>& reports, const Settings& settings);

}  // namespace lancer::stress
