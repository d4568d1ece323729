// The operators on values.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "base/math.hpp"
#include "lang/builtins.hpp"
#include "lang/builtins_arguments.hpp"

namespace lancer::lang {
namespace {

using ast::BinaryOp;

double apply(BinaryOp op, double a, double b) {
  switch (op) {
    case BinaryOp::add: return a + b;
    case BinaryOp::subtract: return a - b;
    case BinaryOp::multiply: return a * b;
    case BinaryOp::divide: return a / b;
    case BinaryOp::modulo: return modulo(a, b);
  }
  return 0;
}

bool is_arithmetic(const Value& v) { return v.is(Type::number) || v.is(Type::vector); }

/// Component i, or the number that spreads over all.
double spread(const Value& v, int i) { return v.is(Type::number) ? v.number() : v.component(i); }

std::string short_text(const Value& v) {
  // Numbers and vectors only: their text is short, and no meter is wanted.
  const Limits none{0, 0, 0};
  Meter meter(none, nullptr);
  return display(v, meter, {});
}

[[noreturn]] void refuse_not_finite(const std::string& operation, double result, Span span) {
  throw ScriptError(Code::not_finite, span,
                    fmt::format("every number stays finite; {} is {}", operation,
                                std::isnan(result) ? "not a number" : "infinite"));
}

[[noreturn]] void refuse_operands(std::string_view sign, const Value& a, const Value& b, Span span) {
  if (a.is(Type::vector) && b.is(Type::vector)) {
    throw ScriptError(Code::wrong_type, span,
                      fmt::format("`{}` wants vectors of the same length; these have {} and {} numbers", sign,
                                  a.dimension(), b.dimension()));
  }
  std::string help;
  if (sign == "+" && (a.is(Type::string) || b.is(Type::string))) {
    help = "values are put into strings as \"{a} and {b}\"";
  } else if (sign == "+" && a.is_list_like() && b.is_list_like()) {
    help = "lists are joined by `concat(a, b)`";
  }
  throw ScriptError(Code::wrong_type, span,
                    fmt::format("`{}` wants numbers or vectors; here it has {} and {}", sign, with_article(a),
                                with_article(b)),
                    std::move(help));
}

/// a and b joined component by component; a number spreads over a vector.
template <class Operation>
Value by_components(std::string_view sign, const Value& a, const Value& b, Span span, Operation operation) {
  const auto checked = [&](double result) {
    if (std::isfinite(result)) return result;
    refuse_not_finite(fmt::format("{} {} {}", short_text(a), sign, short_text(b)), result, span);
  };
  if (a.is(Type::number) && b.is(Type::number)) return checked(operation(a.number(), b.number()));
  if (!is_arithmetic(a) || !is_arithmetic(b)) refuse_operands(sign, a, b, span);
  const int dimension = a.is(Type::vector) ? a.dimension() : b.dimension();
  if (b.is(Type::vector) && b.dimension() != dimension) refuse_operands(sign, a, b, span);
  Vec3 result;
  for (int i = 0; i < dimension; ++i) result[i] = checked(operation(spread(a, i), spread(b, i)));
  return dimension == 2 ? Value(result.x, result.y) : Value(result);
}

}  // namespace

double modulo(double a, double b) {
  const double rest = std::fmod(a, b);
  if (rest == 0) return std::copysign(0.0, b);
  return (rest < 0) == (b < 0) ? rest : rest + b;
}

Value arithmetic(BinaryOp op, const Value& a, const Value& b, Span span) {
  return by_components(symbol(op), a, b, span, [op](double p, double q) { return apply(op, p, q); });
}

Value negate(const Value& a, Span span) {
  if (a.is(Type::number)) return -a.number();
  if (!a.is(Type::vector)) {
    throw ScriptError(Code::wrong_type, span,
                      fmt::format("`-` wants a number or a vector; this is {}", with_article(a)));
  }
  return a.dimension() == 2 ? Value(-a.component(0), -a.component(1)) : Value(-a.vec3());
}

Value power(const Value& base, const Value& exponent, Span span) {
  return by_components("^", base, exponent, span, [](double p, double q) { return math::pow(p, q); });
}

bool less(const Value& a, const Value& b, Meter& meter, Span span) {
  if (a.is(Type::number) && b.is(Type::number)) return a.number() < b.number();
  if (a.is(Type::string) && b.is(Type::string)) {
    meter.charge(std::min(a.text().size(), b.text().size()) / 64, span);
    return a.text() < b.text();  // bytes of UTF-8 stand in the order of the code points
  }
  throw ScriptError(
      Code::wrong_type, span,
      fmt::format("the order is that of two numbers or two strings; these are {} and {}", with_article(a),
                  with_article(b)),
      a.is(Type::vector) && b.is(Type::vector) ? "vectors are compared by `length(..)` or a component" : "");
}

Color to_color(const Value& value, Span span, std::string_view what) {
  if (value.is(Type::number)) return grey(value.number());
  if (value.is(Type::vector) && value.dimension() == 3) {
    return {value.component(0), value.component(1), value.component(2)};
  }
  throw ScriptError(
      Code::wrong_type, span,
      fmt::format("{} is three numbers, or one for a grey; this is {}", what, found_type(value)));
}

}  // namespace lancer::lang
