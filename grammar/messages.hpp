#pragma once
// What each rule that must match says when it does not. A rule without a message does not compile.

#include "grammar/rules.hpp"

namespace lancer::grammar::rules {

template <class Rule>
struct message;  // no general case

#define LANCER_EXPECTS(ROLE, TEXT, ...)                                \
  template <>                                                          \
  struct message<__VA_ARGS__> {                                        \
    static constexpr Expectation value{TEXT, Expectation::Role::ROLE}; \
  };

LANCER_EXPECTS(value, "a value", value)
LANCER_EXPECTS(value, "a value", open_value)
LANCER_EXPECTS(value, "a value", body_value)
LANCER_EXPECTS(value, "a value", values)
LANCER_EXPECTS(value, "another value after the `,`", next_value)
LANCER_EXPECTS(value, "a value", with_comparisons<true, expression>)
LANCER_EXPECTS(value, "a value after the sign", deeper<unary>)
LANCER_EXPECTS(value, "an exponent", exponent)
LANCER_EXPECTS(value, "an exponent", deeper<exponent>)
LANCER_EXPECTS(value, "a value after the operator", factor)
LANCER_EXPECTS(value, "a value after the operator", term)
LANCER_EXPECTS(value, "the end of the range", bound)
LANCER_EXPECTS(value, "a value to compare with", compared)
LANCER_EXPECTS(value, "a value after `not`", deeper<inversion>)
LANCER_EXPECTS(value, "a value after `and`", conjunct)
LANCER_EXPECTS(value, "a value after `or`", disjunct)
LANCER_EXPECTS(value, "a value", alternative)
LANCER_EXPECTS(value, "a condition", condition)
LANCER_EXPECTS(value, "a list, range or group to go through", sequence)
LANCER_EXPECTS(statement, "a statement", statement)

LANCER_EXPECTS(name, "a name for the variable", let_name)
LANCER_EXPECTS(name, "a name for the function", function_name)
LANCER_EXPECTS(loop_name, "a name for the loop's variable", for_name)
LANCER_EXPECTS(other, "a member's name after the `.`", member_name)

LANCER_EXPECTS(other, "`=` and a value", let_equals)
LANCER_EXPECTS(other, "`:` and the other value of the choice", colon)
LANCER_EXPECTS(other, "`(` and the parameters", parameters)
LANCER_EXPECTS(other, "`=` and a value, or `{`", named_body)
LANCER_EXPECTS(other, "`->` and a value, or `{`", function_body)
LANCER_EXPECTS(other, "`in`", k_in)
LANCER_EXPECTS(other, "`{`", branch_scope)
LANCER_EXPECTS(other, "`{`", loop_scope)
LANCER_EXPECTS(other, "`{`", group_braces)
LANCER_EXPECTS(other, "`{`", plain_braces)
LANCER_EXPECTS(other, "`{`", modify_braces)
LANCER_EXPECTS(other, "`{`", settings_braces)
LANCER_EXPECTS(other, "a path in quotes", path)
LANCER_EXPECTS(other, "an object's name in quotes", pattern_name)

LANCER_EXPECTS(closer, "`,` and the next component", comma)
LANCER_EXPECTS(vector_end, "`>`", close_angle)
LANCER_EXPECTS(closer, "`)`", close_paren)
LANCER_EXPECTS(parameter, "a parameter's name or `)`", end_of_parameters)
LANCER_EXPECTS(closer, "`]`", close_bracket)
LANCER_EXPECTS(closer, "`}`", close_brace)
LANCER_EXPECTS(closer, "`,`, an attribute or `}`", end_of_block)
LANCER_EXPECTS(closer, "`,` or `)`", comma_or_paren)
LANCER_EXPECTS(closer, "`,` or `]`", comma_or_bracket)
LANCER_EXPECTS(closer, "`}`", close_interpolation)
LANCER_EXPECTS(closer, "`\"`", string_end)

#undef LANCER_EXPECTS

}  // namespace lancer::grammar::rules
