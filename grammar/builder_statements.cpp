// Statements.

#include "grammar/builder.hpp"
#include "grammar/take.hpp"

namespace lancer::grammar {

// ----------------------------------------------------------------------------------------------

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
  for (std::size_t i = 0; i < conditions.size(); ++i)
    arms.push_back({conditions[i], scopes[first + i].second});
  const bool has_else = bodies - first > conditions.size();
  const ast::Scope otherwise = has_else ? scopes.back().second : ast::Scope{};
  scopes.resize(first);
  push_stmt(
      ast::Branch{{ast::StmtKind::branch, s}, arena_.copy(arms.data(), arms.size()), has_else, otherwise});
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

void Builder::break_loop(const char* begin) {
  if (loops == 0) report_misplaced(begin, "`break` stands in a loop", "");
  push_stmt(ast::Stmt{ast::StmtKind::break_loop, span(begin)});
}

void Builder::continue_loop(const char* begin) {
  if (loops == 0) report_misplaced(begin, "`continue` stands in a loop", "");
  push_stmt(ast::Stmt{ast::StmtKind::continue_loop, span(begin)});
}

void Builder::give_back(const char* begin) {
  if (!in_function) report_misplaced(begin, "`return` stands in a function", "");
  const std::span<ast::Expr*> value = take_exprs(offset(begin));
  push_stmt(ast::Return{{ast::StmtKind::give_back, span(begin)}, value.empty() ? nullptr : value[0]});
}

void Builder::include(const char* begin) {
  if (blocks > 0) {
    report_misplaced(begin, "`include` stands at the top level of a file", "move it out of the braces");
  }
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
  if (blocks > 0) {
    report_misplaced(begin, "`settings` stands at the top level of a file", "move it out of the braces");
  }
  const Span s = span(begin);
  constexpr std::uint32_t k_word_length = 8;
  push_stmt(ast::Settings{
      {ast::StmtKind::settings, s}, span(s.begin, s.begin + k_word_length), take_attributes(s.begin)});
}

void Builder::expression_statement() {
  ast::Expr* value = take_expr();
  push_stmt(ast::ExprStmt{{ast::StmtKind::expression, value->span}, value});
}

void Builder::stray_brace(const char* begin) {
  if (assumed_closers > 0) {
    --assumed_closers;
  } else {
    report(error(Code::unclosed_bracket, span(begin), "this `}` closes nothing"));
  }
}

}  // namespace lancer::grammar
