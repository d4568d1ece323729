#pragma once
// The state of one parse: finished nodes wait on stacks until the rule that contains them takes them.
// Everything that a rule contains begins at or behind its own start, so no counts are kept. Knows nothing of
// PEGTL.

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostic.hpp"
#include "grammar/lexemes.hpp"
#include "lang/ast.hpp"

namespace lancer::grammar {

/// Thrown where a statement cannot be understood; the statement around it recovers.
struct SyntaxError {
  Diagnostic diagnostic;
  bool resume_here = false;  // a missing closer was reported: what was found begins the next statement
  bool last = false;         // nothing sensible can follow: the parse ends
};

class Builder {
 public:
  Builder(std::string_view text, std::uint32_t file, ast::Arena& arena)
      : text_(text), file_(file), arena_(arena) {}

  // --- Places ---
  std::string_view text() const { return text_; }
  std::uint32_t offset(const char* at) const { return static_cast<std::uint32_t>(at - text_.data()); }
  Span span(const char* begin) const { return {file_, offset(begin), last_end}; }
  Span span(std::uint32_t begin, std::uint32_t end) const { return {file_, begin, end}; }
  /// Where the last token ended; white space behind it does not count.
  std::uint32_t last_end = 0;
  /// Where the token before that ended.
  std::uint32_t previous_end = 0;

  /// The word that the last token was; empty where it was none.
  std::string_view last_word() const;

  // --- Context that rules ask about ---
  bool comparisons = true;  // a bare comparison is an expression here
  int depth = 0;            // of blocks and expressions
  int loops = 0;            // around this statement, within its function
  bool in_function = false;
  int blocks = 0;                // braces around this statement
  std::vector<ast::Kind> kinds;  // of the object blocks around this place
  ast::Kind pending_kind = ast::Kind::sphere;
  bool any_kind = false;                // inside the block of `modify`
  std::vector<std::uint32_t> brackets;  // offsets of the open ones
  int assumed_closers = 0;  // closers reported missing: as many stray ones are no mistake of their own

  // --- Messages ---
  std::vector<Diagnostic> diagnostics;
  std::vector<Span> skipped;  // passed over after mistakes
  bool incomplete = false;    // the text ended too early
  void report(Diagnostic diagnostic) { diagnostics.push_back(std::move(diagnostic)); }

  // --- Stacks ---
  struct Word {
    Span span;
    std::string_view id;
  };
  struct Piece {  // of a string
    std::uint32_t begin;
    std::string text;
    ast::Expr* value;
  };
  template <class Op>
  struct Placed {
    std::uint32_t begin;
    Op op;
    std::uint32_t operand_end;  // of what stands before the operator
  };
  std::vector<ast::Expr*> exprs;
  std::vector<ast::Stmt*> stmts;
  std::vector<ast::Attribute> attributes;
  std::vector<ast::Parameter> parameters;
  std::vector<std::pair<std::uint32_t, ast::Scope>> scopes;
  std::vector<Word> words;
  std::vector<ast::String*> names;
  std::vector<Piece> pieces;
  std::vector<Placed<ast::BinaryOp>> operators;
  std::vector<Placed<ast::CompareOp>> comparers;
  std::vector<Placed<ast::UnaryOp>> signs;

  struct Mark {
    std::size_t exprs, stmts, attributes, parameters, scopes, words, names, pieces, operators, comparers,
        signs;
  };
  Mark mark() const;
  void reset(const Mark& mark);

  // --- What rules call when they have matched: each takes what lies on the stacks from `begin` on, and
  // pushes what it makes. builder_tokens.cpp, builder_expressions.cpp, builder_blocks.cpp,
  // builder_statements.cpp ---
  void end_token(const char* at);
  void number(const char* begin, const char* end);
  void color(const char* begin, const char* end);
  void truth(const char* begin);
  void string_text(const char* begin, const char* end);
  void string_escape(const char* begin, const char* end);
  void interpolation(const char* begin);
  void string(const char* begin);
  void string_as_name(const char* begin);
  void word(const char* begin);

  void name(const char* begin);
  void vector(const char* begin);
  void list(const char* begin);
  void call(const char* begin);
  void index(const char* begin);
  void member();
  void power(const char* begin);
  void sign(const char* begin);
  void unary(const char* begin);
  void binary_sign(const char* begin);
  void chain(const char* begin);
  void open_range_end() { closed_range_ = false; }
  void closed_range_end() { closed_range_ = true; }
  void range(const char* begin);
  void compare_sign(const char* begin);
  void compare(const char* begin);
  void negation(const char* begin);
  void conjunction(const char* begin) { logical(begin, true); }
  void disjunction(const char* begin) { logical(begin, false); }
  void conditional(const char* begin);

  void parameter(const char* begin);
  void function(const char* begin);
  void attribute(const char* begin);
  void attribute_statement(const char* begin);
  void short_material(const char* begin);
  void block(const char* begin);

  void scope(const char* begin);
  void let(const char* begin);
  void function_statement(const char* begin);
  void assign(const char* begin);
  void branch(const char* begin);
  void for_loop(const char* begin);
  void while_loop(const char* begin);
  void break_loop(const char* begin);
  void continue_loop(const char* begin);
  void give_back(const char* begin);
  void include(const char* begin);
  void modify(const char* begin);
  void remove(const char* begin);
  void settings(const char* begin);
  void expression_statement();
  void stray_brace(const char* begin);

 private:
  template <class T>
  void push(T node) {
    exprs.push_back(arena_.make(std::move(node)));
  }
  template <class T>
  void push_stmt(T node) {
    stmts.push_back(arena_.make(std::move(node)));
  }
  void logical(const char* begin, bool is_and);
  void report_misplaced(const char* begin, std::string message, std::string help);
  /// How many expressions on the stack belong to a rule that begins at `begin`.
  std::ptrdiff_t operands_since(const char* begin) const;
  Word take_word();
  std::span<ast::Expr*> take_exprs(std::uint32_t begin);
  ast::Expr* take_expr();
  std::span<ast::Stmt*> take_stmts(std::uint32_t begin);
  std::span<ast::Attribute> take_attributes(std::uint32_t begin);
  ast::Function* take_function(const char* begin, Word name);
  void check_postfix_depth(const ast::Expr* base);

  std::string_view text_;
  std::uint32_t file_;
  ast::Arena& arena_;
  bool closed_range_ = false;  // the range just read ends with its last number
};

}  // namespace lancer::grammar
