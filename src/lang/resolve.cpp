// Files and statements.

#include "lang/resolve.hpp"

#include <utility>

#include "lang/check_blocks.hpp"
#include "lang/resolver.hpp"

namespace lancer::lang {
namespace {

using ast::as;
using ast::StmtKind;

}  // namespace

Resolver::Resolver(const std::vector<ast::Script*>& scripts, const std::vector<Definition>& definitions)
    : scripts_(scripts), definitions_(definitions), collected_(scripts.size()), begun_(scripts.size()) {}

Resolved Resolver::run(bool keep_unused) {
  collect_functions(0);
  resolve_definitions();
  resolve_file(0, nullptr);
  keep_unused ? uses_.keep_all() : uses_.finish(out_.diagnostics);
  return std::move(out_);
}

/// Functions of included files are known before the `include` too: they get their slots first.
void Resolver::collect_functions(std::uint32_t script) {
  if (script >= scripts_.size() || collected_[script]) return;
  collected_[script] = true;
  for (ast::Stmt* s : scripts_[script]->statements) {
    if (s->kind == StmtKind::include) collect_functions(as<ast::Include>(*s).script);
    if (s->kind != StmtKind::function) continue;
    auto& statement = as<ast::FunctionStmt>(*s);
    Variable* v = new_global(statement.function->id, statement.function->span);
    v->node = uses_.add({v->id, v->span, &statement.used, UseGraph::k_root, script != 0});
    functions_[&statement] = v;
    later_[v->id].emplace_back(script, v);
  }
}

/// Their values see what is built in, and each other in order, unless they stand in for a `let` of the
/// script.
void Resolver::resolve_definitions() {
  std::unordered_map<std::string_view, ast::Let*> lets;
  for (ast::Stmt* s : scripts_[0]->statements) {
    if (s->kind == StmtKind::let) lets.try_emplace(as<ast::Let>(*s).id, &as<ast::Let>(*s));
  }
  begun_.assign(begun_.size(), true);  // no function of a script is known yet
  for (const Definition& definition : definitions_) {
    auto& let = as<ast::Let>(*definition.script->statements[0]);
    if (const auto found = lets.find(let.id); found != lets.end()) {
      replaced_[found->second] = &let;
      continue;
    }
    Frame frame;
    frame_ = &frame;
    arena_ = &definition.script->arena;
    FileScope file;
    file_ = &file;
    resolve_let(let);
    outside_[let.id] = file.own[let.id];
    definition.script->frame_size = frame.size;
    out_.definitions.push_back(definition.script);
  }
  begun_.assign(begun_.size(), false);
  frame_ = nullptr;
  file_ = nullptr;
}

void Resolver::resolve_file(std::uint32_t script, FileScope* includer) {
  begun_[script] = true;
  Frame frame;
  FileScope file;
  file.includer = includer;
  file.script = script;
  Frame* const outer_frame = std::exchange(frame_, &frame);
  ast::Arena* const outer_arena = std::exchange(arena_, &scripts_[script]->arena);
  file_ = &file;
  hoist(scripts_[script]->statements);
  resolve_statements(scripts_[script]->statements);
  scripts_[script]->frame_size = frame.size;
  file_ = includer;
  frame_ = outer_frame;
  arena_ = outer_arena;
  if (includer == nullptr) return;
  for (const auto& [id, variable] : file.included) includer->included[id] = variable;
  for (const auto& [id, variable] : file.own) includer->included[id] = variable;
}

void Resolver::resolve_include(const ast::Include& include) {
  if (include.script >= scripts_.size() || begun_[include.script]) return;
  file_->include_at = include.span.begin;
  resolve_file(include.script, file_);
}

void Resolver::resolve_statements(std::span<ast::Stmt*> statements) {
  for (ast::Stmt* s : statements) resolve_statement(*s);
}

void Resolver::resolve_statement(ast::Stmt& s) {
  switch (s.kind) {
    case StmtKind::expression: return resolve_expr(*as<ast::ExprStmt>(s).value);
    case StmtKind::attribute: return resolve_attribute(as<ast::AttributeStmt>(s).attribute, ast::Kind::group);
    case StmtKind::let: return resolve_let(as<ast::Let>(s));
    case StmtKind::function: return resolve_function_statement(as<ast::FunctionStmt>(s));
    case StmtKind::assign: return resolve_assign(as<ast::Assign>(s));
    case StmtKind::branch: return resolve_branch(as<ast::Branch>(s));
    case StmtKind::for_loop: return resolve_for(as<ast::ForLoop>(s));
    case StmtKind::while_loop:
      resolve_expr(*as<ast::WhileLoop>(s).condition);
      return resolve_body(as<ast::WhileLoop>(s).body);
    case StmtKind::break_loop:
    case StmtKind::continue_loop: return;
    case StmtKind::give_back:
      if (as<ast::Return>(s).value != nullptr) resolve_expr(*as<ast::Return>(s).value);
      return;
    case StmtKind::include: return resolve_include(as<ast::Include>(s));
    case StmtKind::modify:
      resolve_string(as<ast::Modify>(s).pattern);
      for (const ast::Attribute& a : as<ast::Modify>(s).attributes) resolve_all(a.values);
      return check_modify(as<ast::Modify>(s), out_.diagnostics);
    case StmtKind::remove: return resolve_string(as<ast::Remove>(s).pattern);
    case StmtKind::settings:
      for (const ast::Attribute& a : as<ast::Settings>(s).attributes)
        resolve_attribute(a, ast::Kind::settings);
      return check_settings(as<ast::Settings>(s), out_.diagnostics);
  }
}

void Resolver::resolve_let(ast::Let& let) {
  const UseGraph::Node outer = owner_;
  if (const auto found = replaced_.find(&let); found != replaced_.end()) {
    owner_ = uses_.add({let.id, let.id_span, nullptr, outer, true});  // what is not evaluated uses nothing
    resolve_expr(*let.value);
    owner_ = outer;
    let.value = found->second->value;
  }
  const UseGraph::Node node = new_node(let.id, let.id_span, &let.used);
  owner_ = node;
  resolve_expr(*let.value);
  owner_ = outer;
  Variable* v = scope_ != nullptr ? new_variable(let.id, let.id_span) : new_global(let.id, let.id_span);
  v->node = node;
  declare(v, let.binding);
}

void Resolver::resolve_function_statement(ast::FunctionStmt& statement) {
  const UseGraph::Node outer = std::exchange(owner_, functions_.at(&statement)->node);
  resolve_function(*statement.function);
  owner_ = outer;
}

void Resolver::resolve_assign(ast::Assign& assign) {
  resolve_expr(*assign.value);
  if (Variable* v = find(assign.id)) {
    bind(*v, assign.binding);
  } else {
    unknown_target(assign);
  }
}

void Resolver::resolve_branch(ast::Branch& branch) {
  for (ast::BranchArm& arm : branch.arms) {
    resolve_expr(*arm.condition);
    resolve_body(arm.body);
  }
  if (branch.has_else) resolve_body(branch.otherwise);
}

void Resolver::resolve_for(ast::ForLoop& loop) {
  resolve_expr(*loop.sequence);
  LexicalScope variable, body;
  std::vector<std::uint32_t> boxes;
  enter(variable);
  declare(new_variable(loop.id, loop.id_span), loop.binding);
  enter(body);
  hoist(loop.body.statements);
  resolve_statements(loop.body.statements);
  leave(body, boxes);
  leave(variable, boxes);
  loop.body.boxes = keep(boxes);
}

void Resolver::resolve_body(ast::Scope& body) {
  LexicalScope scope;
  std::vector<std::uint32_t> boxes;
  enter(scope);
  hoist(body.statements);
  resolve_statements(body.statements);
  leave(scope, boxes);
  body.boxes = keep(boxes);
}

Resolved resolve(const std::vector<ast::Script*>& scripts, const std::vector<Definition>& definitions,
                 bool keep_unused) {
  return Resolver(scripts, definitions).run(keep_unused);
}

}  // namespace lancer::lang
