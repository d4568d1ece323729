#include "grammar/builder.hpp"

#include "lang/keywords.hpp"

namespace lancer::grammar {
namespace {

constexpr int k_max_postfix = 1000;

/// Moves the entries from the first that begins at or behind `begin` into the arena.
template <class T, class BeginOf>
std::span<T> take(ast::Arena& arena, std::vector<T>& stack, std::uint32_t begin, BeginOf begin_of) {
  auto first = stack.end();
  while (first != stack.begin() && begin_of(*(first - 1)) >= begin) --first;
  const auto count = static_cast<std::size_t>(stack.end() - first);
  const std::span<T> out = arena.copy(stack.data() + (first - stack.begin()), count);
  stack.erase(first, stack.end());
  return out;
}

}  // namespace

std::string_view word_at(const char* at, const char* end) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const char* stop = at;
  if (stop != end && is_letter(*stop)) {
    while (stop != end && (is_letter(*stop) || (*stop >= '0' && *stop <= '9'))) ++stop;
  }
  return {at, static_cast<std::size_t>(stop - at)};
}

Builder::Mark Builder::mark() const {
  return {exprs.size(), stmts.size(), attributes.size(), parameters.size(), scopes.size(), words.size(),
          names.size(), pieces.size(), operators.size(), comparers.size(), signs.size()};
}

void Builder::reset(const Mark& mark) {
  const auto cut = [](auto& stack, std::size_t size) { stack.erase(stack.begin() + static_cast<std::ptrdiff_t>(size), stack.end()); };
  cut(exprs, mark.exprs);
  cut(stmts, mark.stmts);
  cut(attributes, mark.attributes);
  cut(parameters, mark.parameters);
  cut(scopes, mark.scopes);
  cut(words, mark.words);
  cut(names, mark.names);
  cut(pieces, mark.pieces);
  cut(operators, mark.operators);
  cut(comparers, mark.comparers);
  cut(signs, mark.signs);
}

void Builder::report_misplaced(const char* begin, std::string message, std::string help) {
  const std::string_view word = word_at(begin, text_.data() + text_.size());
  const std::uint32_t at = offset(begin);
  report(error(Code::misplaced, span(at, at + static_cast<std::uint32_t>(word.size())), std::move(message), std::move(help)));
}

std::span<ast::Expr*> Builder::take_exprs(std::uint32_t begin) {
  return take(arena_, exprs, begin, [](const ast::Expr* e) { return e->span.begin; });
}

ast::Expr* Builder::take_expr() {
  ast::Expr* out = exprs.back();
  exprs.pop_back();
  return out;
}

std::span<ast::Stmt*> Builder::take_stmts(std::uint32_t begin) {
  return take(arena_, stmts, begin, [](const ast::Stmt* s) { return s->span.begin; });
}

std::span<ast::Attribute> Builder::take_attributes(std::uint32_t begin) {
  return take(arena_, attributes, begin, [](const ast::Attribute& a) { return a.span.begin; });
}

Builder::Word Builder::take_word() {
  const Word out = words.back();
  words.pop_back();
  return out;
}

// --- Expressions ---------------------------------------------------------------------------------------------

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

void Builder::range(const char* begin, bool closed) {
  ast::Expr* last = take_expr();
  ast::Expr* first = take_expr();
  push(ast::Range{{ast::ExprKind::range, span(begin)}, first, last, closed});
}

void Builder::unary(const char* begin) {
  ast::Expr* operand = take_expr();
  const ast::UnaryOp op = signs.back().op;
  signs.pop_back();
  push(ast::Unary{{ast::ExprKind::unary, span(begin)}, op, operand});
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
  ast::Expr* exponent = take_expr();
  ast::Expr* base = take_expr();
  push(ast::Power{{ast::ExprKind::power, span(begin)}, base, exponent});
}

void Builder::conditional(const char* begin) {
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
  throw SyntaxError{error(Code::too_deep, base->span, "calls, indices and members follow each other more than 1000 times")};
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

// --- Functions and blocks ------------------------------------------------------------------------------------

void Builder::parameter(const char* begin) {
  const std::span<ast::Expr*> fallback = take_exprs(offset(begin));
  const Word word = take_word();
  parameters.push_back({word.id, word.span, fallback.empty() ? nullptr : fallback[0], {}});
}

ast::Function* Builder::take_function(const char* begin, Word name) {
  const std::uint32_t start = offset(begin);
  ast::Function out{};
  out.id = name.id;
  out.span = name.span;
  out.parameters = take(arena_, parameters, start, [](const ast::Parameter& p) { return p.span.begin; });
  if (!scopes.empty() && scopes.back().first >= start) {
    out.body = scopes.back().second.statements;
    scopes.pop_back();
  } else {
    out.expression = take_expr();
  }
  return arena_.make(out);
}

void Builder::function(const char* begin) {
  const Word word{span(offset(begin), offset(begin) + 2), {}};
  ast::Function* made = take_function(begin, word);
  push(ast::FunctionExpr{{ast::ExprKind::function, span(begin)}, made});
}

void Builder::attribute(const char* begin) {
  const std::string_view id = word_at(begin, text_.data() + text_.size());
  const std::uint32_t start = offset(begin);
  attributes.push_back({id, span(start, start + static_cast<std::uint32_t>(id.size())), take_exprs(start)});
}

void Builder::block(const char* begin) {
  const std::string_view word = word_at(begin, text_.data() + text_.size());
  const Span s = span(begin);
  ast::Block out{};
  out.kind = ast::ExprKind::block;
  out.span = s;
  out.block_kind = lang::find_kind(word).value_or(ast::Kind::material);
  out.kind_span = span(s.begin, s.begin + static_cast<std::uint32_t>(word.size()));
  if (!names.empty() && names.back()->span.begin >= s.begin) {
    out.name = names.back();
    names.pop_back();
  }
  out.attributes = take_attributes(s.begin);
  out.statements = take_stmts(s.begin);
  out.positional = take_exprs(s.begin);
  push(out);
}

// --- Statements ----------------------------------------------------------------------------------------------

void Builder::scope(const char* begin) {
  const std::uint32_t start = offset(begin);
  scopes.push_back({start, ast::Scope{take_stmts(start), {}}});
}

void Builder::let(const char* begin) {
  ast::Expr* value = take_expr();
  const Word word = take_word();
  push_stmt(ast::Let{{ast::StmtKind::let, span(begin)}, word.id, word.span, value, {}, true});
}

void Builder::function_statement(const char* begin) {
  const Word word = take_word();
  ast::Function* made = take_function(begin, word);
  push_stmt(ast::FunctionStmt{{ast::StmtKind::function, span(begin)}, made, {}, true});
}

void Builder::assign(const char* begin) {
  ast::Expr* value = take_expr();
  const Word word = take_word();
  push_stmt(ast::Assign{{ast::StmtKind::assign, span(begin)}, word.id, word.span, value, {}});
}

void Builder::branch(const char* begin) {
  const Span s = span(begin);
  const std::span<ast::Expr*> conditions = take_exprs(s.begin);
  const std::size_t bodies = scopes.size();
  std::size_t first = bodies;
  while (first > 0 && scopes[first - 1].first >= s.begin) --first;
  std::vector<ast::BranchArm> arms;
  for (std::size_t i = 0; i < conditions.size(); ++i) arms.push_back({conditions[i], scopes[first + i].second});
  const bool has_else = bodies - first > conditions.size();
  const ast::Scope otherwise = has_else ? scopes.back().second : ast::Scope{};
  scopes.resize(first);
  push_stmt(ast::Branch{{ast::StmtKind::branch, s}, arena_.copy(arms.data(), arms.size()), has_else, otherwise});
}

void Builder::for_loop(const char* begin) {
  ast::Expr* sequence = take_expr();
  const Word word = take_word();
  const ast::Scope body = scopes.back().second;
  scopes.pop_back();
  push_stmt(ast::ForLoop{{ast::StmtKind::for_loop, span(begin)}, word.id, word.span, sequence, body, {}});
}

void Builder::while_loop(const char* begin) {
  ast::Expr* condition = take_expr();
  const ast::Scope body = scopes.back().second;
  scopes.pop_back();
  push_stmt(ast::WhileLoop{{ast::StmtKind::while_loop, span(begin)}, condition, body});
}

void Builder::give_back(const char* begin) {
  const std::span<ast::Expr*> value = take_exprs(offset(begin));
  push_stmt(ast::Return{{ast::StmtKind::give_back, span(begin)}, value.empty() ? nullptr : value[0]});
}

void Builder::include(const char* begin) {
  const ast::String& path = ast::as<ast::String>(*take_expr());
  const bool plain = path.parts.empty() || (path.parts.size() == 1 && path.parts[0].value == nullptr);
  if (!plain) {
    report(error(Code::syntax, path.span, "an included path is a plain string, without `{..}`"));
    return;
  }
  const std::string_view text = path.parts.empty() ? std::string_view{} : path.parts[0].text;
  push_stmt(ast::Include{{ast::StmtKind::include, span(begin)}, text, path.span, ast::k_no_script});
}

void Builder::modify(const char* begin) {
  const Span s = span(begin);
  const std::span<ast::Attribute> changes = take_attributes(s.begin);
  ast::String* pattern = names.back();
  names.pop_back();
  push_stmt(ast::Modify{{ast::StmtKind::modify, s}, pattern, changes});
}

void Builder::remove(const char* begin) {
  ast::String* pattern = names.back();
  names.pop_back();
  push_stmt(ast::Remove{{ast::StmtKind::remove, span(begin)}, pattern});
}

void Builder::settings(const char* begin) {
  const Span s = span(begin);
  constexpr std::uint32_t k_word_length = 8;
  push_stmt(ast::Settings{{ast::StmtKind::settings, s}, span(s.begin, s.begin + k_word_length), take_attributes(s.begin)});
}

void Builder::expression_statement() {
  ast::Expr* value = take_expr();
  push_stmt(ast::ExprStmt{{ast::StmtKind::expression, value->span}, value});
}

void Builder::attribute_statement(const char* begin) {
  const ast::Attribute attribute = attributes.back();
  attributes.pop_back();
  push_stmt(ast::AttributeStmt{{ast::StmtKind::attribute, span(begin)}, attribute});
}

}  // namespace lancer::grammar
