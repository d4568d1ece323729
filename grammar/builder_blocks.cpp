// Functions, and the blocks of objects and materials.

#include "grammar/builder.hpp"
#include "grammar/take.hpp"
#include "lang/keywords.hpp"

namespace lancer::grammar {

// ------------------------------------------------------------------------------------

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

void Builder::attribute_statement(const char* begin) {
  const ast::Attribute attribute = attributes.back();
  attributes.pop_back();
  push_stmt(ast::AttributeStmt{{ast::StmtKind::attribute, span(begin)}, attribute});
}

void Builder::short_material(const char* begin) {
  block(begin);
  attribute(begin);
}

}  // namespace lancer::grammar
