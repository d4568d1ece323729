// Variables, functions and calls.

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "base/deep_stack.hpp"
#include "lang/evaluator.hpp"
#include "lang/wording.hpp"

namespace lancer::lang {
namespace {

using ast::as;
using Where = ast::Binding::Where;

/// What one call may need of the machine's stack: expressions nest 1,000 deep.
constexpr std::size_t k_stack_for_a_call = std::size_t{4} << 20;

/// Scopes with more captured variables than this wait for the end of the run.
constexpr std::size_t k_boxes_to_check = 16;

}  // namespace

Value Evaluator::load(const ast::Name& name) {
  const ast::Binding& b = name.binding;
  const Value* value = nullptr;
  switch (b.where) {
    case Where::local: value = b.boxed ? &frame_[b.slot].box().value : &frame_[b.slot]; break;
    case Where::captured: value = &closure_->captures[b.slot]->value; break;
    case Where::global: value = &globals_[b.slot]; break;
    case Where::constant: return all_constants()[b.slot].value;
    case Where::function: return builtin_value(b.slot);
    case Where::unresolved: break;
  }
  if (!value->is(Type::nothing)) return *value;
  Diagnostic d = error(Code::no_value_yet, name.span,
                       fmt::format("`{}` has no value yet: its `let` has not run", name.id));
  if (b.where == Where::global)
    d.labels.push_back({resolved_.globals[b.slot].span, "it gets its value here"});
  throw ScriptError(std::move(d));
}

void Evaluator::store(const ast::Binding& b, Value value) {
  switch (b.where) {
    case Where::local: (b.boxed ? frame_[b.slot].box().value : frame_[b.slot]) = std::move(value); break;
    case Where::captured: closure_->captures[b.slot]->value = std::move(value); break;
    case Where::global: globals_[b.slot] = std::move(value); break;
    case Where::constant:
    case Where::function:
    case Where::unresolved: break;  // refused by the resolver
  }
}

void Evaluator::open_scope(std::span<const std::uint32_t> boxes, std::span<ast::Stmt* const> statements) {
  for (const std::uint32_t slot : boxes) frame_[slot] = Value(boxes_.make());
  for (const ast::Stmt* s : statements) {
    if (s->kind != ast::StmtKind::function || !as<ast::FunctionStmt>(*s).used) continue;
    store(as<ast::FunctionStmt>(*s).binding, make_closure(*as<ast::FunctionStmt>(*s).function));
  }
}

/// Functions that only their own scope still knows, by themselves or by each other, hold their boxes in a
/// circle: such a circle is cut here, so that a loop which makes one in each round does not pile them up.
void Evaluator::close_scope(std::span<const std::uint32_t> boxes) {
  if (boxes.empty() || boxes.size() > k_boxes_to_check) return;
  std::vector<const Box*> own;
  std::vector<std::uint32_t> inner;  // references to each from functions that nothing outside of `own` holds
  for (const std::uint32_t slot : boxes) own.push_back(&frame_[slot].box());
  inner.assign(own.size(), 1);  // the slot's
  for (const Box* box : own) {
    if (!box->value.is(Type::function) || box->value.function().references != 1) continue;
    for (const Ref<Box>& captured : box->value.function().captures) {
      const auto found = std::find(own.begin(), own.end(), captured.get());
      if (found != own.end()) ++inner[static_cast<std::size_t>(found - own.begin())];
    }
  }
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i]->references != inner[i]) return;
  }
  for (const std::uint32_t slot : boxes) {
    frame_[slot].box().value = Value();
    frame_[slot] = Value();
  }
}

Value Evaluator::builtin_value(std::uint32_t slot) {
  Ref<FunctionData>& known = builtin_values_[slot];
  if (!known) {
    known = Ref<FunctionData>(new FunctionData);
    known->builtin = slot;
  }
  return Value(known);
}

Value Evaluator::make_closure(const ast::Function& function) {
  Ref<FunctionData> closure(new FunctionData);
  closure->code = &function;
  closure->captures.reserve(function.captures.size());
  for (const ast::Capture& c : function.captures) {
    closure->captures.push_back(c.from_captured ? closure_->captures[c.slot]
                                                : Ref<Box>(&frame_[c.slot].box()));
  }
  return Value(std::move(closure));
}

Value Evaluator::call(const ast::Call& c) {
  if (c.callee->kind == ast::ExprKind::name && as<ast::Name>(*c.callee).binding.where == Where::function) {
    return call_builtin_directly(as<ast::Name>(*c.callee).binding.slot, c);
  }
  const Value callee = evaluate(*c.callee);
  if (!callee.is(Type::function)) {
    throw ScriptError(Code::wrong_type, c.callee->span,
                      fmt::format("only functions can be called; this is {}", with_article(callee)));
  }
  const FunctionData& function = callee.function();
  if (function.code == nullptr) return call_builtin_directly(function.builtin, c);
  check_count(*function.code, c.arguments.size(), c.span);
  const FrameStack::Mark below = frames_.mark();
  Value* frame = frames_.push(function.code->frame_size);
  for (std::size_t i = 0; i < c.arguments.size(); ++i) frame[i] = evaluate(*c.arguments[i]);
  Value result = run_function(function, frame, c.arguments.size(), c.span);
  frames_.pop(below);
  return result;
}

Value Evaluator::call_builtin_directly(std::uint32_t slot, const ast::Call& c) {
  meter_.charge(1, c.span);
  const FrameStack::Mark below = frames_.mark();
  Value* arguments = frames_.push(c.arguments.size());
  for (std::size_t i = 0; i < c.arguments.size(); ++i) arguments[i] = evaluate(*c.arguments[i]);
  const CallContext context{&c, c.span, meter_, call_value_, print_};
  Value result = call_builtin(slot, {arguments, c.arguments.size()}, context);
  frames_.pop(below);
  return result;
}

Value Evaluator::call_with(const Value& callee, std::span<const Value> arguments, Span span) {
  if (!callee.is(Type::function)) {
    throw ScriptError(Code::wrong_type, span,
                      fmt::format("only functions can be called; this is {}", with_article(callee)));
  }
  const FunctionData& function = callee.function();
  if (function.code == nullptr) {
    meter_.charge(1, span);
    return call_builtin(function.builtin, arguments, CallContext{nullptr, span, meter_, call_value_, print_});
  }
  check_count(*function.code, arguments.size(), span);
  const FrameStack::Mark below = frames_.mark();
  Value* frame = frames_.push(function.code->frame_size);
  std::copy(arguments.begin(), arguments.end(), frame);
  Value result = run_function(function, frame, arguments.size(), span);
  frames_.pop(below);
  return result;
}

void Evaluator::check_count(const ast::Function& function, std::size_t given, Span span) const {
  const auto& parameters = function.parameters;
  std::size_t least = parameters.size();
  while (least > 0 && parameters[least - 1].fallback != nullptr) --least;
  if (given >= least && given <= parameters.size()) return;
  const std::string who =
      function.id.empty() ? std::string("this function") : fmt::format("`{}`", function.id);
  const std::string wanted = least == parameters.size()
                                 ? count_of(least, "argument")
                                 : fmt::format("{} to {} arguments", least, parameters.size());
  Diagnostic d =
      error(Code::argument_count, span, fmt::format("{} takes {}; this call has {}", who, wanted, given));
  d.labels.push_back({function.span, "declared here"});
  throw ScriptError(std::move(d));
}

Value Evaluator::run_function(const FunctionData& closure, Value* frame, std::size_t given, Span span) {
  meter_.charge(1, span);
  const std::uint32_t most = options_.limits.calls;
  if ((most != 0 && calls_.size() >= most) || stack_left() < k_stack_for_a_call) {
    throw ScriptError(Code::call_limit, span, fmt::format("calls nest more than {} deep", calls_.size()),
                      "a function that calls itself needs a case in which it does not");
  }
  calls_.push_back({span, closure.code});
  Collection added;
  Value* const outer_frame = std::exchange(frame_, frame);
  const FunctionData* const outer_closure = std::exchange(closure_, &closure);
  Collection* const outer_collection = std::exchange(collection_, &added);
  BlockValues* const outer_group = std::exchange(group_, nullptr);
  Value result = run_body(*closure.code, given);
  frame_ = outer_frame;
  closure_ = outer_closure;
  collection_ = outer_collection;
  group_ = outer_group;
  calls_.pop_back();
  if (returning_ != nullptr) return take_returned(added);
  if (added.objects.empty()) return result;
  return Value(build_call_group(span, std::move(added.objects)));
}

/// The value of an expression body; of a block body nothing, its objects are in the collection.
Value Evaluator::run_body(const ast::Function& function, std::size_t given) {
  const Mark start = mark();
  try {
    bind_parameters(function, given);
    if (function.expression != nullptr) return evaluate_open(*function.expression);
    open_scope(function.boxes, function.body);
    execute_all(function.body);
    close_scope(function.boxes);
  } catch (const Jump&) {
    restore(start);  // a `return` within a group
  }
  return {};
}

void Evaluator::bind_parameters(const ast::Function& function, std::size_t given) {
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const ast::Parameter& p = function.parameters[i];
    if (i < given && !p.binding.boxed) continue;
    Value value = i < given ? std::move(frame_[i]) : evaluate(*p.fallback);
    if (p.binding.boxed) frame_[i] = Value(boxes_.make());
    store(p.binding, std::move(value));
  }
}

Value Evaluator::take_returned(const Collection& dropped) {
  const ast::Return* statement = std::exchange(returning_, nullptr);
  if (!dropped.objects.empty() && warned_.insert(statement).second) {
    out_.diagnostics.push_back(warning(Code::dropped_objects, statement->span,
                                       "the objects that were added before this `return` are dropped",
                                       "`return` without a value yields what was added"));
  }
  return std::exchange(returned_, Value());
}

void Evaluator::restore(const Mark& mark) {
  frames_.pop(mark.frames);
  collection_ = mark.collection;
  group_ = mark.group;
}

}  // namespace lancer::lang
