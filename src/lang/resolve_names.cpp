// Scopes: what is declared where, and how a mention finds it.

#include <algorithm>
#include <fmt/format.h>

#include "lang/builtins.hpp"
#include "lang/keywords.hpp"
#include "lang/resolver.hpp"

namespace lancer::lang {
namespace {

using Where = ast::Binding::Where;

Variable* look_up(const Names& names, std::string_view id) {
  const auto found = names.find(id);
  return found == names.end() ? nullptr : found->second;
}

}  // namespace

void Resolver::enter(LexicalScope& scope) {
  scope.outer = scope_;
  scope.first_slot = frame_->next_slot;
  scope_ = &scope;
}

void Resolver::leave(LexicalScope& scope, std::vector<std::uint32_t>& boxes) {
  for (const Variable* v : scope.variables) {
    if (!v->captured) continue;
    boxes.push_back(v->slot);
    for (ast::Binding* binding : v->bindings) binding->boxed = true;
  }
  frame_->next_slot = scope.first_slot;
  scope_ = scope.outer;
  std::vector<Missing>& outer = scope_ != nullptr ? scope_->missing : file_->missing;
  outer.insert(outer.end(), scope.missing.begin(), scope.missing.end());
}

std::span<std::uint32_t> Resolver::keep(const std::vector<std::uint32_t>& boxes) {
  return arena_->copy(boxes.data(), boxes.size());
}

Variable* Resolver::new_variable(std::string_view id, Span span) {
  variables_.push_back({});
  Variable& v = variables_.back();
  v.id = id;
  v.span = span;
  return &v;
}

Variable* Resolver::new_global(std::string_view id, Span span) {
  Variable* v = new_variable(id, span);
  v->slot = static_cast<std::uint32_t>(out_.globals.size());
  out_.globals.push_back({id, span});
  return v;
}

UseGraph::Node Resolver::new_node(std::string_view id, Span span, bool* used) {
  const bool included = scope_ == nullptr && file_ != nullptr && file_->script != 0;
  return uses_.add({id, span, used, owner_, included});
}

std::uint32_t Resolver::take_slots(std::uint32_t count) {
  const std::uint32_t first = frame_->next_slot;
  frame_->next_slot += count;
  frame_->size = std::max(frame_->size, frame_->next_slot);
  return first;
}

void Resolver::hoist(std::span<ast::Stmt*> statements) {
  if (scope_ != nullptr) {
    const auto declares = [](const ast::Stmt* s) {
      return s->kind == ast::StmtKind::let || s->kind == ast::StmtKind::function;
    };
    const auto count = std::count_if(statements.begin(), statements.end(), declares);
    scope_->reserved_left = static_cast<std::uint32_t>(count);
    scope_->reserved = take_slots(scope_->reserved_left);
  }
  for (ast::Stmt* s : statements) {
    if (s->kind != ast::StmtKind::function) continue;
    auto& statement = ast::as<ast::FunctionStmt>(*s);
    const ast::Function& function = *statement.function;
    Variable*& v = functions_[&statement];
    if (v == nullptr) {
      v = new_variable(function.id, function.span);
      v->node = new_node(function.id, function.span, &statement.used);
    }
    declare(v, statement.binding);
  }
}

void Resolver::declare(Variable* variable, ast::Binding& binding) {
  if (scope_ != nullptr) {
    declare_local(variable);
  } else {
    declare_global(variable);
  }
  bind(*variable, binding);
  tell_missing(scope_ != nullptr ? scope_->missing : file_->missing, *variable);
}

void Resolver::declare_local(Variable* variable) {
  variable->frame = frame_;
  if (scope_->reserved_left > 0) {
    --scope_->reserved_left;
    variable->slot = scope_->reserved++;
  } else {
    variable->slot = take_slots(1);
  }
  scope_->variables.push_back(variable);
  const auto [entry, is_new] = scope_->names.try_emplace(variable->id, variable);
  if (is_new) return;
  declared_twice(*entry->second, *variable);
  entry->second = variable;
}

void Resolver::declare_global(Variable* variable) {
  if (const Variable* other = look_up(file_->own, variable->id)) declared_twice(*other, *variable);
  file_->own[variable->id] = variable;
  for (const FileScope* f = file_->includer; f != nullptr; f = f->includer) {
    const Variable* other = look_up(f->own, variable->id);
    if (other == nullptr || other->span.begin > f->include_at) continue;
    declared_twice(*other, *variable);
    return;
  }
}

void Resolver::declared_twice(const Variable& one, const Variable& other) {
  const bool in_order = one.span.file != other.span.file || one.span.begin <= other.span.begin;
  const Variable& first = in_order ? one : other;
  const Variable& second = in_order ? other : one;
  Diagnostic d =
      error(Code::declared_twice, second.span, fmt::format("`{}` is declared twice in one scope", second.id),
            fmt::format("a variable gets a new value by `{} = ..`, without `let`", second.id));
  d.labels.push_back({first.span, "first declared here"});
  // Which of the two is meant by a mention is part of the mistake: neither is called unused.
  uses_.mention(UseGraph::k_root, first.node);
  uses_.mention(UseGraph::k_root, second.node);
  out_.diagnostics.push_back(std::move(d));
}

Variable* Resolver::find(std::string_view id) const {
  for (const LexicalScope* s = scope_; s != nullptr; s = s->outer) {
    if (Variable* v = look_up(s->names, id)) return v;
  }
  for (const FileScope* f = file_; f != nullptr; f = f->includer) {
    if (Variable* v = look_up(f->own, id)) return v;
    if (Variable* v = look_up(f->included, id)) return v;
  }
  if (Variable* v = find_later(id)) return v;
  return look_up(outside_, id);
}

Variable* Resolver::find_later(std::string_view id) const {
  const auto found = later_.find(id);
  if (found == later_.end()) return nullptr;
  for (const auto& [script, variable] : found->second) {
    if (!begun_[script]) return variable;
  }
  return nullptr;
}

void Resolver::bind(Variable& variable, ast::Binding& binding) {
  if (variable.frame == nullptr) {
    binding = {Where::global, false, variable.slot};
  } else if (variable.frame == frame_) {
    binding = {Where::local, false, variable.slot};
    variable.bindings.push_back(&binding);
  } else {
    binding = {Where::captured, false, capture(*frame_, variable)};
  }
}

std::uint32_t Resolver::capture(Frame& frame, Variable& variable) {
  const auto known = std::find(frame.captured.begin(), frame.captured.end(), &variable);
  if (known != frame.captured.end()) return static_cast<std::uint32_t>(known - frame.captured.begin());
  variable.captured = true;
  const bool is_near = frame.outer == variable.frame;
  const std::uint32_t from = is_near ? variable.slot : capture(*frame.outer, variable);
  frame.captured.push_back(&variable);
  frame.captures.push_back({!is_near, from});
  return static_cast<std::uint32_t>(frame.captured.size() - 1);
}

void Resolver::unknown_target(const ast::Assign& assign) {
  if (find_builtin(assign.id) || find_constant(assign.id)) {
    out_.diagnostics.push_back(error(Code::cannot_assign, assign.id_span,
                                     fmt::format("`{}` is built in and cannot be assigned", assign.id),
                                     fmt::format("`let {} = ..` makes a variable of that name", assign.id)));
    return;
  }
  if (quiet_) return;
  unknown(assign.id, assign.id_span, nullptr);
  Diagnostic& problem = out_.diagnostics.back();
  problem.code = Code::cannot_assign;
  problem.message = fmt::format("there is no variable `{}` to assign to", assign.id);
  std::string& help = problem.help;
  if (help.empty()) help = fmt::format("a new variable is made by `let {} = ..`", assign.id);
}

void Resolver::unknown(std::string_view id, Span span, const ast::Block* begun) {
  if (quiet_) return;
  std::vector<Missing>& missing = scope_ != nullptr ? scope_->missing : file_->missing;
  missing.push_back({id, out_.diagnostics.size()});
  out_.diagnostics.push_back(
      error(Code::unknown_name, span, fmt::format("nothing is called `{}` here", id), suggestion(id, begun)));
}

std::string Resolver::suggestion(std::string_view id, const ast::Block* begun) const {
  if (begun != nullptr) {
    std::vector<std::string_view> attributes;
    for (const AttributeInfo& a : kind_info(begun->block_kind).attributes) attributes.push_back(a.id);
    if (const std::string_view near = nearest(id, attributes); !near.empty()) {
      return fmt::format("is the attribute `{}` meant?", near);
    }
  }
  if (const std::string_view near = nearest(id, known_names()); !near.empty()) {
    return fmt::format("did you mean `{}`?", near);
  }
  return id.size() == 1 ? std::string() : std::string(foreign_hint(id));
}

std::vector<std::string_view> Resolver::known_names() const {
  std::vector<std::string_view> out;
  const auto add = [&out](const Names& names) {
    for (const auto& [id, variable] : names) out.push_back(id);
  };
  for (const LexicalScope* s = scope_; s != nullptr; s = s->outer) add(s->names);
  for (const FileScope* f = file_; f != nullptr; f = f->includer) {
    add(f->own);
    add(f->included);
  }
  add(outside_);
  for (const BuiltinInfo& b : all_builtins()) out.push_back(b.id);
  for (const ConstantInfo& c : all_constants()) out.push_back(c.id);
  for (const KindInfo& k : all_kinds()) out.push_back(k.id);
  std::sort(out.begin(), out.end());  // the same suggestion every time
  return out;
}

void Resolver::tell_missing(std::vector<Missing>& missing, const Variable& variable) {
  for (const Missing& m : missing) {
    if (m.id != variable.id) continue;
    Diagnostic& d = out_.diagnostics[m.diagnostic];
    if (!d.labels.empty()) continue;
    d.labels.push_back({variable.span, "its `let` comes only here"});
    d.help =
        "a variable is known from the end of its `let` on; a function that calls itself is `fn name(..)`";
  }
}

}  // namespace lancer::lang
