#pragma once
// From "this rule did not match here" to a message that teaches: what was expected, what was found, and,
// where the text smells of another language, what to write instead.

#include "grammar/builder.hpp"

namespace lancer::grammar {

/// What a rule that must match wants.
struct Expectation {
  enum class Role { other, value, statement, name, loop_name, parameter, vector_end, closer };
  const char* wanted;  // "a value", "`)`"
  Role role = Role::other;

  bool is_value() const { return role == Role::value || role == Role::statement; }
  bool is_name() const { return role == Role::name || role == Role::loop_name || role == Role::parameter; }
  bool is_closer() const {
    return role == Role::closer || role == Role::vector_end || role == Role::parameter;
  }
};

/// Of the token that begins at `at`, as far as a message shows it; empty at the end of the text.
Span token_span(const Builder& b, const char* at);

[[noreturn]] void fail(Builder& b, const char* at, Expectation expectation);
[[noreturn]] void fail_too_deep(Builder& b, const char* at);
[[noreturn]] void fail_unclosed_comment(Builder& b, const char* opener);

/// Where to go on after a mistake in what began at `start`.
const char* end_of_mistake(Builder& b, const SyntaxError& problem, const char* start);

/// Keeps the message; ends the parse where there are too many.
void tell(Builder& b, SyntaxError& problem);

}  // namespace lancer::grammar
