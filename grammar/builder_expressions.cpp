// Expressions.

#include "grammar/builder.hpp"

namespace lancer::grammar {
namespace {

constexpr int k_max_postfix = 1000;

ast::BinaryOp binary_op(char sign) {
  switch (sign) {
    case '+': return ast::BinaryOp::add;
    case '-': return ast::BinaryOp::subtract;
    case '*': return ast::BinaryOp::multiply;
    case '/': return ast::BinaryOp::divide;
    default: return ast::BinaryOp::modulo;
  }
}

ast::CompareOp compare_op(char sign, bool or_equal) {
  switch (sign) {
    case '=': return ast::CompareOp::equal;
    case '!': return ast::CompareOp::not_equal;
    case '<': return or_equal ? ast::CompareOp::less_equal : ast::CompareOp::less;
    default: return or_equal ? ast::CompareOp::greater_equal : ast::CompareOp::greater;
  }
}

}  // namespace

// ---------------------------------------------------------------------------------------------

void Builder::name(const char* begin) {
  const Span s = span(begin);
  push(ast::Name{{ast::ExprKind::name, s}, text_.substr(s.begin, s.end - s.begin), {}});
}

void Builder::vector(const char* begin) {
  const Span s = span(begin);
  push(ast::Vector{{ast::ExprKind::vector, s}, take_exprs(s.begin)});
}

void Builder::list(const char* begin) {
  const Span s = span(begin);
  push(ast::List{{ast::ExprKind::list, s}, take_exprs(s.begin)});
}

void Builder::range(const char* begin) {
  const std::ptrdiff_t count = operands_since(begin);
  if (count < 2) return;
  if (count > 2) {
    report(error(Code::chained_comparison, span(begin), "ranges do not chain"));
    exprs.pop_back();
  }
  ast::Expr* last = take_expr();
  ast::Expr* first = take_expr();
  push(ast::Range{{ast::ExprKind::range, span(begin)}, first, last, closed_range_});
}

void Builder::unary(const char* begin) {
  ast::Expr* operand = take_expr();
  const ast::UnaryOp op = signs.back().op;
  signs.pop_back();
  push(ast::Unary{{ast::ExprKind::unary, span(begin)}, op, operand});
}

void Builder::sign(const char* begin) {
  signs.push_back({offset(begin), *begin == '-' ? ast::UnaryOp::minus : ast::UnaryOp::plus, 0});
}

void Builder::negation(const char* begin) {
  signs.push_back({offset(begin), ast::UnaryOp::logical_not, 0});
  unary(begin);
}

void Builder::binary_sign(const char* begin) {
  operators.push_back({offset(begin), binary_op(*begin), previous_end});
}

void Builder::compare_sign(const char* begin) {
  comparers.push_back({offset(begin), compare_op(begin[0], begin[1] == '='), previous_end});
}

void Builder::chain(const char* begin) {
  const std::uint32_t start = offset(begin);
  std::size_t first = operators.size();
  while (first > 0 && operators[first - 1].begin >= start) --first;
  const std::size_t count = operators.size() - first;
  if (count == 0) return;
  std::vector<ast::Link> links(count);
  for (std::size_t i = 0; i < count; ++i) {
    links[i].op = operators[first + i].op;
    links[i].operand = exprs[exprs.size() - count + i];
    links[i].end = i + 1 < count ? operators[first + i + 1].operand_end : last_end;
  }
  exprs.resize(exprs.size() - count);
  operators.resize(first);
  ast::Expr* head = take_expr();
  push(ast::Chain{{ast::ExprKind::chain, span(begin)}, head, arena_.copy(links.data(), links.size())});
}

void Builder::logical(const char* begin, bool is_and) {
  const Span s = span(begin);
  std::span<ast::Expr*> operands = take_exprs(s.begin);
  if (operands.size() == 1) {
    exprs.push_back(operands[0]);
  } else {
    push(ast::Logical{{ast::ExprKind::logical, s}, is_and, operands});
  }
}

void Builder::compare(const char* begin) {
  const Span s = span(begin);
  std::size_t first = comparers.size();
  while (first > 0 && comparers[first - 1].begin >= s.begin) --first;
  const std::size_t count = comparers.size() - first;
  if (count == 0) return;
  const ast::CompareOp op = comparers[first].op;
  comparers.resize(first);
  if (count > 1) {
    report(error(Code::chained_comparison, s, "comparisons do not chain",
                 "join two comparisons with `and`: `a < b and b < c`"));
    exprs.resize(exprs.size() - (count - 1));
  }
  ast::Expr* right = take_expr();
  ast::Expr* left = take_expr();
  push(ast::Compare{{ast::ExprKind::compare, s}, op, left, right});
}

void Builder::power(const char* begin) {
  if (operands_since(begin) < 2) return;
  ast::Expr* exponent = take_expr();
  ast::Expr* base = take_expr();
  push(ast::Power{{ast::ExprKind::power, span(begin)}, base, exponent});
}

void Builder::conditional(const char* begin) {
  if (operands_since(begin) < 3) return;
  ast::Expr* otherwise = take_expr();
  ast::Expr* then = take_expr();
  ast::Expr* condition = take_expr();
  push(ast::Conditional{{ast::ExprKind::conditional, span(begin)}, condition, then, otherwise});
}

void Builder::check_postfix_depth(const ast::Expr* base) {
  int length = 0;
  for (const ast::Expr* e = base; length <= k_max_postfix; ++length) {
    if (e->kind == ast::ExprKind::call) {
      e = ast::as<ast::Call>(*e).callee;
    } else if (e->kind == ast::ExprKind::index) {
      e = ast::as<ast::Index>(*e).base;
    } else if (e->kind == ast::ExprKind::member) {
      e = ast::as<ast::Member>(*e).base;
    } else {
      return;
    }
  }
  throw SyntaxError{
      error(Code::too_deep, base->span, "calls, indices and members follow each other more than 1000 times")};
}

void Builder::call(const char* begin) {
  const std::span<ast::Expr*> arguments = take_exprs(offset(begin));
  ast::Expr* callee = take_expr();
  check_postfix_depth(callee);
  push(ast::Call{{ast::ExprKind::call, span(callee->span.begin, last_end)}, callee, arguments});
}

void Builder::index(const char* begin) {
  const std::span<ast::Expr*> index = take_exprs(offset(begin));
  ast::Expr* base = take_expr();
  check_postfix_depth(base);
  push(ast::Index{{ast::ExprKind::index, span(base->span.begin, last_end)}, base, index[0]});
}

void Builder::member() {
  const Word word = take_word();
  ast::Expr* base = take_expr();
  check_postfix_depth(base);
  push(ast::Member{{ast::ExprKind::member, span(base->span.begin, last_end)}, base, word.id, word.span});
}

}  // namespace lancer::grammar
