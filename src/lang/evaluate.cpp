// Files and statements.

#include "lang/evaluate.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "lang/evaluator.hpp"

namespace lancer::lang {
namespace {

using ast::as;
using ast::StmtKind;

}  // namespace

Evaluator::Evaluator(const std::vector<ast::Script*>& scripts, const Resolved& resolved,
                     const EvaluateOptions& options)
    : scripts_(scripts),
      resolved_(resolved),
      options_(options),
      meter_(options.limits, options.interrupt),
      globals_(resolved.globals.size()),
      builtin_values_(all_builtins().size()),
      call_value_([this](const Value& function, std::span<const Value> arguments, Span where) {
        Value value = call_with(function, arguments, where);
        return value.is(Type::nothing) ? Value(build_call_group(where, {})) : value;
      }),
      print_(options.print ? options.print : [](std::string_view) {}) {}

Evaluated Evaluator::run() {
  try {
    run_all();
  } catch (ScriptError& e) {
    for (Label& label : trace()) e.diagnostic.trace.push_back(std::move(label));
    out_.diagnostics.push_back(std::move(e.diagnostic));
  }
  out_.objects = std::move(scene_.objects);
  out_.steps = meter_.used();
  return std::move(out_);
}

void Evaluator::run_all() {
  for (const ast::Script* script : scripts_) hoist_globals(*script);
  for (const ast::Script* script : resolved_.definitions) run_script(*script);
  run_script(*scripts_[0]);
}

void Evaluator::hoist_globals(const ast::Script& script) {
  for (const ast::Stmt* s : script.statements) {
    if (s->kind != StmtKind::function || !as<ast::FunctionStmt>(*s).used) continue;
    store(as<ast::FunctionStmt>(*s).binding, make_closure(*as<ast::FunctionStmt>(*s).function));
  }
}

void Evaluator::run_script(const ast::Script& script) {
  const FrameStack::Mark below = frames_.mark();
  Value* const outer = std::exchange(frame_, frames_.push(script.frame_size));
  execute_all(script.statements);
  frame_ = outer;
  frames_.pop(below);
}

Flow Evaluator::execute_all(std::span<ast::Stmt* const> statements) {
  for (const ast::Stmt* s : statements) {
    if (const Flow flow = execute(*s); flow != Flow::next) return flow;
  }
  return Flow::next;
}

Flow Evaluator::execute(const ast::Stmt& s) {
  meter_.charge(1, s.span);
  switch (s.kind) {
    case StmtKind::expression: execute_expression(as<ast::ExprStmt>(s)); break;
    case StmtKind::attribute: execute_attribute(as<ast::AttributeStmt>(s)); break;
    case StmtKind::let:
      if (as<ast::Let>(s).used) store(as<ast::Let>(s).binding, evaluate(*as<ast::Let>(s).value));
      break;
    case StmtKind::function: break;  // its closure was made when its block was entered
    case StmtKind::assign: store(as<ast::Assign>(s).binding, evaluate(*as<ast::Assign>(s).value)); break;
    case StmtKind::branch: return execute_branch(as<ast::Branch>(s));
    case StmtKind::for_loop: return execute_for(as<ast::ForLoop>(s));
    case StmtKind::while_loop: return execute_while(as<ast::WhileLoop>(s));
    case StmtKind::break_loop: return Flow::leave_loop;
    case StmtKind::continue_loop: return Flow::next_round;
    case StmtKind::give_back: return execute_return(as<ast::Return>(s));
    case StmtKind::include:
      if (as<ast::Include>(s).script != ast::k_no_script) run_script(*scripts_[as<ast::Include>(s).script]);
      break;
    case StmtKind::modify: execute_modify(as<ast::Modify>(s)); break;
    case StmtKind::remove: execute_remove(as<ast::Remove>(s)); break;
    case StmtKind::settings: execute_settings(as<ast::Settings>(s)); break;
  }
  return Flow::next;
}

void Evaluator::execute_expression(const ast::ExprStmt& s) {
  const Value value = evaluate_open(*s.value);
  if (!value.is(Type::nothing)) add_value(value, s.value->span);
}

void Evaluator::execute_attribute(const ast::AttributeStmt& s) {
  group_->attributes.push_back(evaluate_attribute(s.attribute));
}

Flow Evaluator::execute_branch(const ast::Branch& branch) {
  for (const ast::BranchArm& arm : branch.arms) {
    if (truth(*arm.condition, "a condition")) return execute_scope(arm.body);
  }
  return branch.has_else ? execute_scope(branch.otherwise) : Flow::next;
}

Flow Evaluator::execute_scope(const ast::Scope& scope) {
  open_scope(scope.boxes, scope.statements);
  const Flow flow = execute_all(scope.statements);
  close_scope(scope.boxes);
  return flow;
}

Flow Evaluator::execute_round(const ast::Scope& body, const ast::ForLoop* loop, const Value& value) {
  const Mark before = mark();
  try {
    open_scope(body.boxes, body.statements);
    if (loop != nullptr) store(loop->binding, value);
    const Flow flow = execute_all(body.statements);
    close_scope(body.boxes);
    return flow;
  } catch (const Jump& jump) {
    restore(before);
    return jump.flow;
  }
}

Flow Evaluator::execute_for(const ast::ForLoop& loop) {
  const Value sequence = evaluate(*loop.sequence);
  const bool is_group = sequence.is(Type::object) && sequence.object().kind == ast::Kind::group;
  if (!sequence.is_list_like() && !is_group) {
    throw ScriptError(
        Code::wrong_type, loop.sequence->span,
        fmt::format("`for` goes over a range, a list or a group; this is {}", with_article(sequence)),
        sequence.is(Type::number) ? "counting is `for i in 0..n`" : "");
  }
  const std::size_t length = is_group ? sequence.object().members.size() : sequence.length();
  for (std::size_t i = 0; i < length; ++i) {
    meter_.charge(1, loop.span);
    const Flow flow =
        execute_round(loop.body, &loop, is_group ? Value(sequence.object().members[i]) : sequence.item(i));
    if (flow == Flow::leave_loop) break;
    if (flow == Flow::give_back) return flow;
  }
  return Flow::next;
}

Flow Evaluator::execute_while(const ast::WhileLoop& loop) {
  while (truth(*loop.condition, "a condition")) {
    meter_.charge(1, loop.span);
    const Flow flow = execute_round(loop.body, nullptr, {});
    if (flow == Flow::leave_loop) break;
    if (flow == Flow::give_back) return flow;
  }
  return Flow::next;
}

Flow Evaluator::execute_return(const ast::Return& s) {
  if (s.value == nullptr) return Flow::give_back;
  returned_ = evaluate_open(*s.value);
  returning_ = &s;
  return Flow::give_back;
}

void Evaluator::execute_settings(const ast::Settings& settings) {
  std::vector<AttributeValues> values;
  for (const ast::Attribute& a : settings.attributes) values.push_back(evaluate_attribute(a));
  apply_settings(values, out_.settings, settings_seen_, out_.diagnostics);
}

namespace {

std::string statement_help(const Value& value) {
  switch (value.type()) {
    case Type::function: return "a function is called with `(..)` behind its name";
    case Type::material: return "a material stands in an object, `material m`, or in a `let`";
    case Type::boolean: return "to give a variable a value write one `=`";
    default: return "a value is kept with `let name = ..`, and shown with `print(..)`";
  }
}

}  // namespace

void Evaluator::add_value(const Value& value, Span span) {
  struct Level {
    Value list;
    std::size_t next;
  };
  if (value.is(Type::object)) return add_object(value.ref<Object>(), span);
  const auto refuse = [&](const Value& culprit, std::string_view what) {
    throw ScriptError(Code::not_an_object, span,
                      fmt::format("{} {}, which adds nothing", what, with_article(culprit)),
                      statement_help(culprit));
  };
  if (!value.is(Type::list)) refuse(value, "this statement's value is");
  std::vector<Level> levels{{value, 0}};
  while (!levels.empty()) {
    if (levels.back().next == levels.back().list.length()) {
      levels.pop_back();
      continue;
    }
    meter_.charge(1, span);
    const Value item = levels.back().list.item(levels.back().next++);
    if (item.is(Type::list)) {
      levels.push_back({item, 0});
    } else if (item.is(Type::object)) {
      add_object(item.ref<Object>(), span);
    } else {
      refuse(item, "this list holds");
    }
  }
}

void Evaluator::add_object(const Ref<Object>& object, Span span) {
  const std::uint64_t most = options_.limits.objects;
  collection_->count += object->count;
  if (most != 0 && collection_->count > most) {
    throw ScriptError(Code::object_limit, span, fmt::format("this makes more than {} objects", most),
                      "if so many are meant, raise the limit with `--max-objects N` (0: none)");
  }
  collection_->objects.push_back(object);
}

/// The calls in which the run is, innermost first.
std::vector<Label> Evaluator::trace() const {
  std::vector<Label> out;
  for (auto call = calls_.rbegin(); call != calls_.rend(); ++call) {
    const std::string_view id = call->function->id;
    out.push_back({call->call, id.empty() ? std::string("a function") : fmt::format("`{}`", id)});
  }
  return out;
}

Evaluated evaluate(const std::vector<ast::Script*>& scripts, const Resolved& resolved,
                   const EvaluateOptions& options) {
  return Evaluator(scripts, resolved, options).run();
}

}  // namespace lancer::lang
