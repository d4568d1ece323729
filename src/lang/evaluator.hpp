#pragma once
// One run of a script. Internal to evaluate*.cpp.

#include <functional>
#include <string>
#include <unordered_set>
#include <vector>

#include "lang/build_object.hpp"
#include "lang/builtins.hpp"
#include "lang/evaluate.hpp"
#include "lang/evaluate_frames.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {

/// What the statements of the scene, a function body or a group block have added so far.
struct Collection {
  std::vector<Ref<Object>> objects;
  std::uint64_t count = 0;  // members of groups included
};

/// Where to go on after a statement.
enum class Flow : std::uint8_t { next, leave_loop, next_round, give_back };

class Evaluator {
 public:
  Evaluator(const std::vector<ast::Script*>& scripts, const Resolved& resolved,
            const EvaluateOptions& options);
  Evaluated run();

 private:
  /// A `break`, `continue` or `return` within a group block: leaves the expression that the group stands in.
  struct Jump {
    Flow flow;
  };
  /// What a Jump has to restore.
  struct Mark {
    FrameStack::Mark frames;
    Collection* collection;
    BlockValues* group;
  };
  struct ActiveCall {
    Span call;
    const ast::Function* function;
  };

  // evaluate.cpp: files and statements
  void run_all();
  void hoist_globals(const ast::Script& script);
  void run_script(const ast::Script& script);
  Flow execute_all(std::span<ast::Stmt* const> statements);
  Flow execute(const ast::Stmt& statement);
  void execute_expression(const ast::ExprStmt& statement);
  void execute_attribute(const ast::AttributeStmt& statement);
  Flow execute_branch(const ast::Branch& branch);
  Flow execute_for(const ast::ForLoop& loop);
  Flow execute_while(const ast::WhileLoop& loop);
  Flow execute_return(const ast::Return& give_back);
  void execute_settings(const ast::Settings& settings);
  Flow execute_scope(const ast::Scope& scope);
  /// One round of a loop; `value` is that of its variable.
  Flow execute_round(const ast::Scope& body, const ast::ForLoop* loop, const Value& value);
  void add_value(const Value& value, Span span);
  void add_object(const Ref<Object>& object, Span span);
  std::vector<Label> trace() const;

  // evaluate_change.cpp: what was added is changed or taken away
  void execute_modify(const ast::Modify& modify);
  void execute_remove(const ast::Remove& remove);
  /// What becomes of an object whose name matches; null: it is gone.
  using Change = std::function<Ref<Object>(const Object&)>;
  void change_added(const ast::Stmt& statement, const ast::String& pattern, const Change& change);

  // evaluate_expr.cpp: one function for each kind of expression
  Value evaluate(const ast::Expr& expr);
  /// The same, but `nothing` for a call that adds and returns nothing.
  Value evaluate_open(const ast::Expr& expr);
  Value evaluate_closed(const ast::Expr& expr);
  Value evaluate_vector(const ast::Vector& vector);
  Value evaluate_list(const ast::List& list);
  Value evaluate_range(const ast::Range& range);
  Value evaluate_string(const ast::String& string);
  Value evaluate_unary(const ast::Unary& unary);
  Value evaluate_chain(const ast::Chain& chain);
  Value evaluate_power(const ast::Power& power);
  Value evaluate_logical(const ast::Logical& logical);
  Value evaluate_compare(const ast::Compare& compare);
  Value evaluate_index(const ast::Index& index);
  Value evaluate_member(const ast::Member& member);
  [[noreturn]] void bad_index(const ast::Index& index, const Value& base, std::size_t length,
                              double at) const;
  double range_bound(const ast::Expr& bound);
  bool truth(const ast::Expr& condition, std::string_view what);
  std::string text_of(const ast::String& string);

  // evaluate_block.cpp: blocks
  Value evaluate_block(const ast::Block& block);
  Value evaluate_group(const ast::Block& block, BlockValues values);
  AttributeValues evaluate_attribute(const ast::Attribute& attribute);
  std::vector<Value> evaluate_each(std::span<ast::Expr* const> expressions);

  // evaluate_call.cpp: variables, functions and calls
  Value load(const ast::Name& name);
  void store(const ast::Binding& binding, Value value);
  void open_scope(std::span<const std::uint32_t> boxes, std::span<ast::Stmt* const> statements);
  void close_scope(std::span<const std::uint32_t> boxes);
  Value builtin_value(std::uint32_t slot);
  Value make_closure(const ast::Function& function);
  Value call(const ast::Call& call);
  Value call_builtin_directly(std::uint32_t slot, const ast::Call& call);
  Value call_with(const Value& function, std::span<const Value> arguments, Span span);
  void check_count(const ast::Function& function, std::size_t given, Span span) const;
  Value run_function(const FunctionData& closure, Value* frame, std::size_t given, Span span);
  void bind_parameters(const ast::Function& function, std::size_t given);
  Value run_body(const ast::Function& function, std::size_t given);
  Value take_returned(const Collection& dropped);
  Mark mark() const { return {frames_.mark(), collection_, group_}; }
  void restore(const Mark& mark);

  const std::vector<ast::Script*>& scripts_;
  const Resolved& resolved_;
  const EvaluateOptions& options_;
  Meter meter_;
  Evaluated out_;
  BoxList boxes_;
  std::vector<Value> globals_;
  FrameStack frames_;
  Value* frame_ = nullptr;                 // slots of the running function
  const FunctionData* closure_ = nullptr;  // the running function; null at top level
  Collection scene_;
  Collection* collection_ = &scene_;        // what statements add to
  BlockValues* group_ = nullptr;            // the block of the innermost group
  std::vector<ActiveCall> calls_;           // outermost first; as they stood when an error was thrown
  const ast::Return* returning_ = nullptr;  // a `return` with a value, on the way out of its function
  Value returned_;
  std::vector<Ref<FunctionData>> builtin_values_;  // made when asked for
  std::vector<std::string_view> settings_seen_;
  std::unordered_set<const ast::Stmt*> warned_;
  std::function<Value(const Value&, std::span<const Value>, Span)> call_value_;
  std::function<void(std::string_view)> print_;
};

}  // namespace lancer::lang
