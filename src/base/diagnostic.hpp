#pragma once
// What Lancer says about a script: a stable code, a place, a sentence, and what to write instead.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/source.hpp"

namespace lancer {

enum class Severity : std::uint8_t { error, warning, note };

/// The stable number of each kind of message. Numbers are never given to another meaning.
enum class Code : std::uint16_t {
  none = 0,
  syntax = 1,            // something else was expected here
  bad_text = 2,          // invalid UTF-8, a control character, a letter outside strings and comments
  bad_number = 3,        // a malformed number
  number_too_large = 4,  // a literal beyond the range of numbers
  unclosed_string = 5,   // a string without its closing quote
  bad_escape = 6,        // an unknown escape in a string
  bad_color = 7,         // a malformed colour literal
  unclosed_comment = 8,  // a comment without its end
  unclosed_bracket = 9,  // a bracket or brace without its partner
  too_deep = 10,         // blocks and expressions nested too deep
  misplaced = 11,        // a word that has no meaning at this place
  reserved_word = 12,    // a keyword or kind as a name
  not_positive = 13,     // a quantity that must be positive
  negative = 14,         // a coefficient that must not be negative
  out_of_range = 15,     // a quantity outside its range
  degenerate = 16,       // points on a line, a flat box, a zero vector
  singular = 17,         // a transform without an inverse
  bad_view = 18,         // a view that cannot look
  unknown_name = 20,
  unknown_attribute = 21,
  repeated_attribute = 22,
  missing_attribute = 23,
  mixed_forms = 24,  // parts of two forms, or a wrong number of values
  declared_twice = 25,
  cannot_assign = 26,
  chained_comparison = 27,
  wrong_type = 30,
  not_finite = 31,  // a result that is infinite or no number
  argument_count = 32,
  bad_index = 33,
  no_member = 34,
  failed_assert = 35,
  not_an_object = 36,  // a value as a statement that adds nothing
  no_value_yet = 37,   // a name used before its `let` ran
  bad_argument = 38,   // right type, but outside what the function takes
  include_missing = 40,
  include_cycle = 41,
  include_outside = 42,
  step_limit = 43,
  object_limit = 44,
  call_limit = 45,
  bad_mesh = 46,
  not_yet = 47,       // in the language, not in this version
  foreign_word = 48,  // a habit from another language
  unused = 101,       // warnings from here on
  dropped_objects = 102,
  settings_again = 103,
  not_square = 104,
  no_match = 105,
};

/// A second place that helps to understand the first.
struct Label {
  Span span;
  std::string text;
};

struct Diagnostic {
  Severity severity = Severity::error;
  Code code = Code::none;
  Span span;
  std::string message;    // one sentence, no full stop, lower case first
  std::string help = {};  // what to write instead; may be empty
  std::vector<Label> labels = {};
  std::vector<Label> trace = {};  // the calls that led here, innermost first
};

inline Diagnostic error(Code code, Span span, std::string message, std::string help = {}) {
  return {Severity::error, code, span, std::move(message), std::move(help)};
}
inline Diagnostic warning(Code code, Span span, std::string message, std::string help = {}) {
  return {Severity::warning, code, span, std::move(message), std::move(help)};
}

/// "E013", "W101"; empty for Code::none.
std::string code_name(Code code);

/// The message as people read it, several lines, the last ended. `color` adds ANSI colours.
///
///     lamp.scn:12:34: error[E013]: a sphere's radius is positive; this one is -1
///        |
///     12 |   sphere { center <0,1,0> radius -1 }
///        |                                  ^^
///        = help: ...
std::string to_text(const Diagnostic& diagnostic, const SourceMap& sources, bool color = false);

/// All of them, sorted by file and place; at most 20 errors, then a line that counts the rest.
std::string to_text(std::vector<Diagnostic> diagnostics, const SourceMap& sources, bool color = false);

bool has_errors(const std::vector<Diagnostic>& diagnostics);

/// The candidate nearest to `word` by edit distance, when near enough to be a likely slip; else empty.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates);

}  // namespace lancer
