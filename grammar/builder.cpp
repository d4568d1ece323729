#include "grammar/builder.hpp"

#include <algorithm>

#include "grammar/take.hpp"

namespace lancer::grammar {
Builder::Mark Builder::mark() const {
  return {exprs.size(), stmts.size(),  attributes.size(), parameters.size(), scopes.size(), words.size(),
          names.size(), pieces.size(), operators.size(),  comparers.size(),  signs.size()};
}

void Builder::reset(const Mark& mark) {
  const auto cut = [](auto& stack, std::size_t size) {
    stack.erase(stack.begin() + static_cast<std::ptrdiff_t>(size), stack.end());
  };
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
  report(error(Code::misplaced, span(at, at + static_cast<std::uint32_t>(word.size())), std::move(message),
               std::move(help)));
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

std::string_view Builder::last_word() const {
  std::uint32_t begin = last_end;
  while (begin > 0 && is_word_character(text_[begin - 1])) --begin;
  return word_at(text_.data() + begin, text_.data() + last_end);
}

std::ptrdiff_t Builder::operands_since(const char* begin) const {
  const auto outside = [start = offset(begin)](const ast::Expr* e) { return e->span.begin < start; };
  return std::find_if(exprs.rbegin(), exprs.rend(), outside) - exprs.rbegin();
}

}  // namespace lancer::grammar
