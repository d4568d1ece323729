#pragma once
// The arguments of a built-in function, checked. Internal to builtins*.cpp.

#include <span>
#include <string>
#include <string_view>

#include "lang/builtins.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {

/// Every refusal is a ScriptError at the argument: what the function wants there, and what was found.
class Arguments {
 public:
  Arguments(std::string_view id, std::span<const Value> values, const CallContext& context)
      : id_(id), values_(values), context_(context) {}

  std::string_view id() const { return id_; }
  std::size_t size() const { return values_.size(); }
  const Value& operator[](std::size_t i) const { return values_[i]; }
  std::span<const Value> values() const { return values_; }
  Span span(std::size_t i) const { return context_.argument_span(i); }
  const CallContext& context() const { return context_; }
  Meter& meter() const { return context_.meter; }
  void charge(std::uint64_t steps) const { context_.meter.charge(steps, context_.span); }

  double number(std::size_t i) const;
  /// A number > 0: `what` is "a checker's size".
  double positive(std::size_t i, std::string_view what) const;
  const std::string& text(std::size_t i) const;
  const Value& vector(std::size_t i) const;
  Vec3 vec3(std::size_t i) const;
  /// Three numbers, not all 0: `what` is "an axis".
  Vec3 direction(std::size_t i, std::string_view what) const;
  Color color(std::size_t i) const;
  /// A list or range.
  const Value& list(std::size_t i) const;
  const Value& function(std::size_t i) const;
  /// Two vectors of the same number of components.
  void same_dimension(std::size_t i, std::size_t j) const;

  /// What the function at place `function` makes of `arguments`.
  Value call(std::size_t function, std::span<const Value> arguments) const {
    return context_.call_value(values_[function], arguments, span(function));
  }

  /// "`sqrt` wants `wanted` here; this is a string".
  [[noreturn]] void wrong_type(std::size_t i, std::string_view wanted, std::string help = {}) const;
  [[noreturn]] void refuse(Code code, std::size_t i, std::string message, std::string help = {}) const {
    throw ScriptError(code, span(i), std::move(message), std::move(help));
  }

 private:
  std::string_view id_;
  std::span<const Value> values_;
  const CallContext& context_;
};

/// a - b floor(a / b), exactly but for the last rounding: of the sign of b.
double modulo(double a, double b);

/// "a vector of 2 numbers", "a list": with_article, and the length of a vector where that is what is wrong.
std::string found_type(const Value& value);

}  // namespace lancer::lang
