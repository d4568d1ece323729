#pragma once
// The walk that gives every name its place. Internal to resolve*.cpp.

#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "lang/resolve.hpp"
#include "lang/resolve_unused.hpp"

namespace lancer::lang {

/// The slots of a function, or of the statements at the top level of a file, while they are counted.
struct Frame {
  Frame* outer = nullptr;
  std::uint32_t next_slot = 0;
  std::uint32_t size = 0;
  std::vector<const struct Variable*> captured;  // parallel to `captures`
  std::vector<ast::Capture> captures;
};

struct Variable {
  std::string_view id;
  Span span;               // of the name in its declaration
  Frame* frame = nullptr;  // of a local; null for a global
  std::uint32_t slot = 0;
  UseGraph::Node node = UseGraph::k_none;
  bool captured = false;
  std::vector<ast::Binding*>
      bindings;  // of a local, in its own frame: told at the end of its scope if it is boxed
};

using Names = std::unordered_map<std::string_view, Variable*>;

/// Where a name was not found; its declaration may come later in the text.
struct Missing {
  std::string_view id;
  std::size_t diagnostic;
};

/// Braces, parameters, or the variable of a loop.
struct LexicalScope {
  LexicalScope* outer = nullptr;
  std::uint32_t first_slot = 0;  // of the frame, when the scope was entered
  std::uint32_t reserved = 0;    // the next of the slots that `hoist` set aside, and how many are left
  std::uint32_t reserved_left = 0;
  Names names;
  std::vector<Variable*> variables;
  std::vector<Missing> missing;
};

/// The top level of a file that is being resolved.
struct FileScope {
  FileScope* includer = nullptr;
  std::uint32_t script = 0;
  std::uint32_t include_at = 0;  // in this file, where the one that it is including is named
  Names own, included;
  std::vector<Missing> missing;
};

class Resolver {
 public:
  Resolver(const std::vector<ast::Script*>& scripts, const std::vector<Definition>& definitions);
  Resolved run(bool keep_unused);

 private:
  // resolve.cpp: files and statements
  void collect_functions(std::uint32_t script);
  void resolve_definitions();
  void resolve_file(std::uint32_t script, FileScope* includer);
  void resolve_include(const ast::Include& include);
  void resolve_statements(std::span<ast::Stmt*> statements);
  void resolve_statement(ast::Stmt& statement);
  void resolve_let(ast::Let& let);
  void resolve_function_statement(ast::FunctionStmt& statement);
  void resolve_assign(ast::Assign& assign);
  void resolve_branch(ast::Branch& branch);
  void resolve_for(ast::ForLoop& loop);
  void resolve_body(ast::Scope& body);

  // resolve_expr.cpp: expressions, functions and blocks
  void resolve_expr(ast::Expr& expr);
  void resolve_all(std::span<ast::Expr*> expressions);
  void resolve_string(const ast::String* string);
  void resolve_name(ast::Name& name, const ast::Block* begun);
  void resolve_block(ast::Block& block);
  void resolve_attribute(const ast::Attribute& attribute, ast::Kind kind);
  void resolve_function(ast::Function& function);
  void declare_parameters(ast::Function& function);

  // resolve_names.cpp: scopes
  void enter(LexicalScope& scope);
  /// Closes the innermost scope; appends the slots of captured variables to `boxes`.
  void leave(LexicalScope& scope, std::vector<std::uint32_t>& boxes);
  std::span<std::uint32_t> keep(const std::vector<std::uint32_t>& boxes);
  /// Declares the functions among the statements of a scope that begins here, and sets slots aside for all it
  /// will declare: its boxes are made when it is entered, so that no inner scope may use their slots before.
  void hoist(std::span<ast::Stmt*> statements);
  Variable* new_variable(std::string_view id, Span span);
  Variable* new_global(std::string_view id, Span span);
  UseGraph::Node new_node(std::string_view id, Span span, bool* used);
  /// Makes the variable known from here on, in the innermost scope; reports a second one of the name.
  void declare(Variable* variable, ast::Binding& binding);
  void declare_local(Variable* variable);
  std::uint32_t take_slots(std::uint32_t count);
  void declare_global(Variable* variable);
  void declared_twice(const Variable& one, const Variable& other);
  Variable* find(std::string_view id) const;
  Variable* find_later(std::string_view id) const;
  void bind(Variable& variable, ast::Binding& binding);
  std::uint32_t capture(Frame& frame, Variable& variable);
  void unknown_target(const ast::Assign& assign);
  void unknown(std::string_view id, Span span, const ast::Block* begun);
  std::string suggestion(std::string_view id, const ast::Block* begun) const;
  std::vector<std::string_view> known_names() const;
  void tell_missing(std::vector<Missing>& missing, const Variable& variable);

  const std::vector<ast::Script*>& scripts_;
  const std::vector<Definition>& definitions_;
  Resolved out_;
  UseGraph uses_;
  UseGraph::Node owner_ = UseGraph::k_root;
  std::deque<Variable> variables_;
  Names outside_;                                                  // definitions that replace nothing
  std::unordered_map<const ast::Let*, const ast::Let*> replaced_;  // by definitions
  std::unordered_map<const ast::FunctionStmt*, Variable*> functions_;
  std::unordered_map<std::string_view, std::vector<std::pair<std::uint32_t, Variable*>>> later_;  // by script
  std::vector<bool> collected_, begun_;
  bool quiet_ = false;  // within what is a mistake as a whole
  ast::Arena* arena_ = nullptr;
  Frame* frame_ = nullptr;
  LexicalScope* scope_ = nullptr;
  FileScope* file_ = nullptr;
};

}  // namespace lancer::lang
