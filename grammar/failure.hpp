#pragma once
// From "this rule did not match here" to a message that teaches: what was expected, what was found, and,
// where the text smells of another language, what to write instead.

#include "grammar/builder.hpp"

namespace lancer::grammar {

/// What a rule that must match wants.
struct Expectation {
  enum class Role { other, value, name, closer };
  const char* wanted;  // "a value", "`)`"
  Role role = Role::other;
};

[[noreturn]] void fail(Builder& b, const char* at, Expectation expectation);
[[noreturn]] void fail_too_deep(Builder& b, const char* at);
[[noreturn]] void fail_unclosed_comment(Builder& b, const char* opener);

/// Throws for `#declare` and its like; colours pass.
void fail_if_directive(Builder& b, const char* begin, const char* end);
/// Throws where a statement begins as only another language's does: `camera { .. }`, `n += 1`, `else` alone.
void fail_if_foreign_statement(Builder& b, const char* at, const char* end);

/// Throws for `rgb <1, 0, 0>` where a comparison could stand: POV-Ray's way to write a colour.
void fail_if_foreign_color(const Builder& b, const char* at, const char* end);

/// Where to go on after a mistake in what began at `start`.
const char* end_of_mistake(Builder& b, const SyntaxError& problem, const char* start);

/// Keeps the message, drops what the statement left on the stacks, and says where to go on.
const char* recover(Builder& b, SyntaxError& problem, const char* start, const Builder::Mark& mark);

}  // namespace lancer::grammar
