#pragma once
// The built-in functions and constants: one table, by name and by slot.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lang/ast.hpp"
#include "lang/limits.hpp"
#include "lang/value.hpp"

namespace lancer::lang {

/// What a built-in function may ask of the evaluation that calls it.
struct CallContext {
  const ast::Call*
      call;   // for the places of the call and of its arguments; null when a built-in calls a built-in
  Span span;  // of the whole call
  Meter& meter;
  /// Calls any function value with the arguments; errors of a wrong count included.
  const std::function<Value(const Value& function, std::span<const Value> arguments, Span where)>& call_value;
  /// Writes a line that `print` makes (newline included).
  const std::function<void(std::string_view)>& print;
  bool pure = false;  // inside a pattern function or a comparison: print and assert are refused

  Span argument_span(std::size_t index) const;
};

class Arguments;

inline constexpr std::uint8_t k_any_count = 255;

struct BuiltinInfo {
  std::string_view id;
  std::string_view signature;  // "atan2(y, x)"
  std::string_view summary;    // for help
  std::uint8_t min_arguments;
  std::uint8_t max_arguments;  // k_any_count: any number
  Value (*function)(const Arguments& arguments);
};

std::span<const BuiltinInfo> all_builtins();
std::optional<std::uint32_t> find_builtin(std::string_view id);
/// Checks the count of arguments, then calls. Throws ScriptError.
Value call_builtin(std::uint32_t slot, std::span<const Value> arguments, const CallContext& context);

struct ConstantInfo {
  std::string_view id;
  Value value;
};
std::span<const ConstantInfo> all_constants();  // x y z pi tau and the CSS colours
std::optional<std::uint32_t> find_constant(std::string_view id);

// --- Operations that the evaluator shares with the functions
// --------------------------------------------------

/// a op b on numbers and vectors, component by component; a number spreads over a vector. `%` has the sign of
/// b. Throws ScriptError(wrong_type or not_finite) at `span`.
Value arithmetic(ast::BinaryOp op, const Value& a, const Value& b, Span span);
Value negate(const Value& a, Span span);
/// base ^ exponent on numbers and vectors, as arithmetic; exact where the result is.
Value power(const Value& base, const Value& exponent, Span span);
/// Any two values: different types are unequal; functions and patterns are equal if they are the same one.
bool equal(const Value& a, const Value& b, Meter& meter, Span span);
/// a < b of two numbers, or two strings by code points. Throws ScriptError(wrong_type).
bool less(const Value& a, const Value& b, Meter& meter, Span span);

/// As `print` and interpolation show it. Strings are quoted inside lists only.
std::string display(const Value& value, Meter& meter, Span span);

/// A colour from a vector of three or a number (grey). Throws ScriptError at `span`; `what` names it: "a
/// colour".
Color to_color(const Value& value, Span span, std::string_view what);

}  // namespace lancer::lang
