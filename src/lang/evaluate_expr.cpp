// One function for each kind of expression.

#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "base/number.hpp"
#include "lang/evaluator.hpp"

namespace lancer::lang {
namespace {

using ast::as;
using ast::CompareOp;
using ast::ExprKind;

constexpr double k_whole_limit = 9007199254740992.0;  // 2^53

[[noreturn]] void wrong_type(Span span, std::string_view wanted, const Value& found, std::string help = {}) {
  throw ScriptError(Code::wrong_type, span, fmt::format("{}; this is {}", wanted, with_article(found)),
                    std::move(help));
}

}  // namespace

Value Evaluator::evaluate_open(const ast::Expr& e) {
  if (e.kind == ExprKind::call) return call(as<ast::Call>(e));
  if (e.kind != ExprKind::conditional) return evaluate(e);
  const auto& choice = as<ast::Conditional>(e);
  return evaluate_open(truth(*choice.condition, "a condition") ? *choice.then : *choice.otherwise);
}

Value Evaluator::evaluate(const ast::Expr& e) {
  switch (e.kind) {
    case ExprKind::number: return as<ast::Number>(e).value;
    case ExprKind::boolean: return as<ast::Boolean>(e).value;
    case ExprKind::color:
      return Color{as<ast::ColorLiteral>(e).r, as<ast::ColorLiteral>(e).g, as<ast::ColorLiteral>(e).b};
    case ExprKind::string: return evaluate_string(as<ast::String>(e));
    case ExprKind::name: return load(as<ast::Name>(e));
    case ExprKind::vector: return evaluate_vector(as<ast::Vector>(e));
    case ExprKind::list: return evaluate_list(as<ast::List>(e));
    case ExprKind::range: return evaluate_range(as<ast::Range>(e));
    case ExprKind::unary: return evaluate_unary(as<ast::Unary>(e));
    case ExprKind::chain: return evaluate_chain(as<ast::Chain>(e));
    case ExprKind::logical: return evaluate_logical(as<ast::Logical>(e));
    case ExprKind::compare: return evaluate_compare(as<ast::Compare>(e));
    case ExprKind::power: return evaluate_power(as<ast::Power>(e));
    case ExprKind::index: return evaluate_index(as<ast::Index>(e));
    case ExprKind::member: return evaluate_member(as<ast::Member>(e));
    case ExprKind::function: return make_closure(*as<ast::FunctionExpr>(e).function);
    case ExprKind::block: return evaluate_block(as<ast::Block>(e));
    case ExprKind::conditional:
    case ExprKind::call: return evaluate_closed(e);
  }
  return {};
}

/// A call that adds and returns nothing is an empty group where a value is wanted.
Value Evaluator::evaluate_closed(const ast::Expr& e) {
  Value value = evaluate_open(e);
  return value.is(Type::nothing) ? Value(build_call_group(e.span, {})) : value;
}

Value Evaluator::evaluate_vector(const ast::Vector& v) {
  std::array<double, 3> c{};
  for (std::size_t i = 0; i < v.components.size(); ++i) {
    const Value value = evaluate(*v.components[i]);
    if (!value.is(Type::number))
      wrong_type(v.components[i]->span, "the components of a vector are numbers", value);
    c[i] = value.number();
  }
  return v.components.size() == 2 ? Value(c[0], c[1]) : Value(Vec3{c[0], c[1], c[2]});
}

Value Evaluator::evaluate_list(const ast::List& list) {
  meter_.charge(list.items.size(), list.span);
  return Value(evaluate_each(list.items));
}

double Evaluator::range_bound(const ast::Expr& bound) {
  const Value value = evaluate(bound);
  if (!value.is(Type::number)) wrong_type(bound.span, "the bounds of a range are whole numbers", value);
  const double number = value.number();
  if (number != std::floor(number)) {
    throw ScriptError(Code::out_of_range, bound.span,
                      fmt::format("the bounds of a range are whole numbers; this one is {}", to_text(number)),
                      "`range(a, b, step)` makes a list of any numbers");
  }
  if (std::fabs(number) > k_whole_limit) {
    throw ScriptError(
        Code::out_of_range, bound.span,
        fmt::format("the bounds of a range lie within 2^53 of 0; this one is {}", to_text(number)));
  }
  return number + 0.0;  // -0 becomes 0
}

Value Evaluator::evaluate_range(const ast::Range& range) {
  const double first = range_bound(*range.first);
  return Value(RangeData{first, range_bound(*range.last), range.closed});
}

std::string Evaluator::text_of(const ast::String& string) {
  std::string out;
  for (const ast::StringPart& part : string.parts) {
    out += part.text;
    if (part.value == nullptr) continue;
    const Value value = evaluate(*part.value);
    if (value.is(Type::string)) {
      out += value.text();
    } else {
      out += display(value, meter_, part.value->span);
    }
  }
  meter_.charge(out.size() / 64, string.span);
  return out;
}

Value Evaluator::evaluate_string(const ast::String& string) { return Value(text_of(string)); }

Value Evaluator::evaluate_unary(const ast::Unary& u) {
  if (u.op == ast::UnaryOp::logical_not) return !truth(*u.operand, "what `not` turns round");
  const Value operand = evaluate(*u.operand);
  if (u.op == ast::UnaryOp::minus) return negate(operand, u.span);
  if (!operand.is(Type::number) && !operand.is(Type::vector))
    wrong_type(u.span, "`+` wants a number or a vector", operand);
  return operand;
}

Value Evaluator::evaluate_chain(const ast::Chain& chain) {
  Value value = evaluate(*chain.first);
  for (const ast::Link& link : chain.links) {
    const Value operand = evaluate(*link.operand);
    value =
        arithmetic(link.op, value, operand, Span{chain.span.file, chain.span.begin, link.operand->span.end});
  }
  return value;
}

Value Evaluator::evaluate_power(const ast::Power& p) {
  const Value base = evaluate(*p.base);
  return power(base, evaluate(*p.exponent), p.span);
}

bool Evaluator::truth(const ast::Expr& condition, std::string_view what) {
  const Value value = evaluate(condition);
  if (value.is(Type::boolean)) return value.boolean();
  wrong_type(condition.span, fmt::format("{} is true or false", what), value,
             value.is(Type::number) ? "numbers are compared, as in `n != 0`" : "");
}

Value Evaluator::evaluate_logical(const ast::Logical& logical) {
  const std::string_view what = logical.is_and ? "what `and` joins" : "what `or` joins";
  for (const ast::Expr* operand : logical.operands) {
    if (truth(*operand, what) != logical.is_and) return !logical.is_and;
  }
  return logical.is_and;
}

Value Evaluator::evaluate_compare(const ast::Compare& c) {
  const Value a = evaluate(*c.left);
  const Value b = evaluate(*c.right);
  switch (c.op) {
    case CompareOp::equal: return equal(a, b, meter_, c.span);
    case CompareOp::not_equal: return !equal(a, b, meter_, c.span);
    case CompareOp::less: return less(a, b, meter_, c.span);
    case CompareOp::greater_equal: return !less(a, b, meter_, c.span);
    case CompareOp::less_equal: return less(a, b, meter_, c.span) || equal(a, b, meter_, c.span);
    case CompareOp::greater: return !less(a, b, meter_, c.span) && !equal(a, b, meter_, c.span);
  }
  return {};
}

Value Evaluator::evaluate_index(const ast::Index& i) {
  const Value base = evaluate(*i.base);
  const Value index = evaluate(*i.index);
  const bool is_group = base.is(Type::object) && base.object().kind == ast::Kind::group;
  if (!base.is_list_like() && !base.is(Type::vector) && !is_group) {
    wrong_type(i.base->span, "an index goes with a list, a range, a vector or a group", base);
  }
  if (!index.is(Type::number)) wrong_type(i.index->span, "an index is a whole number", index);
  const std::size_t length = is_group                ? base.object().members.size()
                             : base.is(Type::vector) ? static_cast<std::size_t>(base.dimension())
                                                     : base.length();
  const double at = index.number();
  if (!(at >= 0 && at < static_cast<double>(length)) || at != std::floor(at)) bad_index(i, base, length, at);
  const auto place = static_cast<std::size_t>(at);
  if (is_group) return Value(base.object().members[place]);
  return base.is(Type::vector) ? Value(base.component(static_cast<int>(place))) : base.item(place);
}

void Evaluator::bad_index(const ast::Index& i, const Value& base, std::size_t length, double at) const {
  const std::string_view type = type_name(base);
  const std::string found = to_text(at);
  std::string message;
  if (at != std::floor(at)) {
    message = fmt::format("an index is a whole number; this one is {}", found);
  } else if (length == 0) {
    message = fmt::format("this {} is empty; there is no index {}", type, found);
  } else {
    message = fmt::format("the indices of this {} go from 0 to {}; this one is {}", type, length - 1, found);
  }
  throw ScriptError(Code::bad_index, i.index->span, std::move(message));
}

Value Evaluator::evaluate_member(const ast::Member& m) {
  const Value base = evaluate(*m.base);
  if (base.is(Type::object) || base.is(Type::material)) return member(base, m.id, m.id_span);
  if (base.is(Type::vector)) {
    constexpr std::string_view k_components = "xyzrgb";
    const std::size_t found = m.id.size() == 1 ? k_components.find(m.id[0]) : std::string_view::npos;
    const int place = static_cast<int>(found % 3);
    if (found != std::string_view::npos && place < base.dimension()) return base.component(place);
    throw ScriptError(Code::no_member, m.id_span,
                      fmt::format("a vector of {} numbers has no `{}`", base.dimension(), m.id),
                      base.dimension() == 2 ? "its members are `.x` and `.y`"
                                            : "its members are `.x`, `.y`, `.z` and `.r`, `.g`, `.b`");
  }
  const bool wants_length = m.id == "length" || m.id == "size" || m.id == "count";
  throw ScriptError(Code::no_member, m.id_span, fmt::format("{} has no members", with_article(base)),
                    wants_length ? "the number of elements is `len(..)`" : "");
}

}  // namespace lancer::lang
