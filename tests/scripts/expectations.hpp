#pragma once
// What a script case says about itself, in comments:
//
//     sphere { <0, 0, 0>, -1 }   //~ error E013 at 21: a sphere's radius is positive; this one is -1
//     print(6 * 7)               //~ prints 42
//
// `//~^` speaks of the line above. `at` with a column may be left out. A case must give exactly what it says,
// messages in any order and prints in theirs; `//~ allow unused` lets warnings of that kind pass.

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"

namespace lancer::test {

struct Expected {
  std::uint32_t line = 0;
  std::uint32_t column = 0;  // 0: any
  std::string severity;
  std::string code;
  std::string message;
  bool found = false;
};

struct Expectations {
  std::vector<Expected> messages;
  std::string prints;
  bool allow_unused = false;
};

inline Expected parse_message(std::string_view text, std::uint32_t line) {
  Expected out;
  out.line = line;
  std::istringstream in{std::string(text)};
  in >> out.severity >> out.code;
  if (out.code.ends_with(':')) {
    out.code.pop_back();
  } else {
    std::string at, column;
    in >> at >> column;
    out.column = static_cast<std::uint32_t>(std::stoul(column));
  }
  std::getline(in >> std::ws, out.message);
  return out;
}

inline Expectations parse_expectations(std::string_view text) {
  Expectations out;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (std::uint32_t number = 1; std::getline(lines, line); ++number) {
    const std::size_t mark = line.find("//~");
    if (mark == std::string::npos) continue;
    std::string_view rest = std::string_view(line).substr(mark + 3);
    std::uint32_t target = number;
    for (; rest.starts_with('^'); rest.remove_prefix(1)) --target;
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    if (rest.starts_with("prints")) {
      out.prints += std::string(rest.substr(std::min<std::size_t>(7, rest.size()))) + "\n";
    } else if (rest == "allow unused") {
      out.allow_unused = true;
    } else {
      out.messages.push_back(parse_message(rest, target));
    }
  }
  return out;
}

/// What did not go as expected, a line each; empty where all is well.
inline std::string differences(Expectations expected, const std::vector<Diagnostic>& diagnostics,
                               const SourceMap& sources, const std::string& printed) {
  std::string out;
  for (const Diagnostic& d : diagnostics) {
    if (d.code == Code::unused && expected.allow_unused) continue;
    const Position place = sources[d.span.file].position(d.span.begin);
    const char* severity = d.severity == Severity::error ? "error" : "warning";
    const auto fits = [&](const Expected& e) {
      return !e.found && e.line == place.line && (e.column == 0 || e.column == place.column) &&
             e.severity == severity && e.code == code_name(d.code) && e.message == d.message;
    };
    const auto match = std::find_if(expected.messages.begin(), expected.messages.end(), fits);
    if (match != expected.messages.end()) {
      match->found = true;
    } else {
      out += "unexpected: line " + std::to_string(place.line) + ": " + severity + " " + code_name(d.code) +
             " at " + std::to_string(place.column) + ": " + d.message + "\n";
    }
  }
  for (const Expected& e : expected.messages) {
    if (!e.found)
      out += "missing: line " + std::to_string(e.line) + ": " + e.severity + " " + e.code + " at " +
             std::to_string(e.column) + ": " + e.message + "\n";
  }
  if (printed != expected.prints) out += "printed:\n" + printed + "instead of:\n" + expected.prints;
  return out;
}

}  // namespace lancer::test
