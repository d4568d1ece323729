#pragma once
// A script as it was written. Nodes live in the arena of their Script, are trivially destructible, and point
// at each other; the resolver fills in the fields marked "resolved". Chains that people write long (a + b + c
// ..., else if ...) are flat, so that depth in the tree is depth in the text.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/source.hpp"

namespace lancer::ast {

/// Memory that grows in blocks and is freed at once.
class Arena {
 public:
  Arena() = default;
  Arena(Arena&&) = default;
  Arena& operator=(Arena&&) = default;

  void* allocate(std::size_t bytes, std::size_t alignment);

  template <class T>
  T* make(T value) {
    static_assert(std::is_trivially_destructible_v<T>);
    return ::new (allocate(sizeof(T), alignof(T))) T(value);
  }
  template <class T>
  std::span<T> copy(const T* first, std::size_t count) {
    static_assert(std::is_trivially_destructible_v<T> && std::is_trivially_copyable_v<T>);
    if (count == 0) return {};
    T* out = static_cast<T*>(allocate(count * sizeof(T), alignof(T)));
    std::uninitialized_copy_n(first, count, out);
    return {out, count};
  }
  std::string_view text(std::string_view s);

 private:
  std::vector<std::unique_ptr<std::byte[]>> blocks_;
  std::byte* next_ = nullptr;
  std::byte* end_ = nullptr;
};

/// The kinds of block. The order is that of the keyword table.
enum class Kind : std::uint8_t {
  sphere,
  plane,
  cube,
  box,
  facet,
  mesh,
  group,
  light,
  sun,
  spot,
  view,
  material,
  settings
};

// --- Where names lead (resolved)
// -----------------------------------------------------------------------------

/// What the resolver found for a name. `slot` counts in the global table, in the frame of the running
/// function, among its captures, or in the tables of built-in functions and constants.
struct Binding {
  enum class Where : std::uint8_t { unresolved, global, local, captured, function, constant };
  Where where = Where::unresolved;
  bool boxed = false;  // a local that an inner function captures lives in a box
  std::uint32_t slot = 0;
};

// --- Expressions
// ---------------------------------------------------------------------------------------------

enum class ExprKind : std::uint8_t {
  number,
  boolean,
  color,
  string,
  name,
  vector,
  list,
  range,
  unary,
  chain,
  logical,
  compare,
  power,
  conditional,
  call,
  index,
  member,
  function,
  block,
};

struct Expr {
  ExprKind kind;
  Span span;
};

struct Number : Expr {
  double value;
};
struct Boolean : Expr {
  bool value;
};
/// `#f80`, decoded to linear light.
struct ColorLiteral : Expr {
  double r, g, b;
};

/// One piece of a string: literal text (escapes decoded), then, unless null, an interpolated expression.
struct StringPart {
  std::string_view text;
  Expr* value;
};
struct String : Expr {
  std::span<StringPart> parts;
};  // "" has no parts

struct Name : Expr {
  std::string_view id;
  Binding binding;  // resolved
};

struct Vector : Expr {
  std::span<Expr*> components;
};  // 2 or 3
struct List : Expr {
  std::span<Expr*> items;
};
struct Range : Expr {
  Expr* first;
  Expr* last;
  bool closed;
};

enum class UnaryOp : std::uint8_t { minus, plus, logical_not };
struct Unary : Expr {
  UnaryOp op;
  Expr* operand;
};

enum class BinaryOp : std::uint8_t { add, subtract, multiply, divide, modulo };
/// "+", "-", ...
std::string_view symbol(BinaryOp op);
struct Link {
  BinaryOp op;
  Expr* operand;
  std::uint32_t end;  // of the operand, parentheses around it included
};
/// first op operand op operand ..., of one precedence, applied from the left. The span of each operation is
/// from the start of the chain to the `end` of its link.
struct Chain : Expr {
  Expr* first;
  std::span<Link> links;
};

/// operand and operand and ..., or the same with `or`.
struct Logical : Expr {
  bool is_and;
  std::span<Expr*> operands;
};

enum class CompareOp : std::uint8_t { equal, not_equal, less, less_equal, greater, greater_equal };
struct Compare : Expr {
  CompareOp op;
  Expr* left;
  Expr* right;
};

struct Power : Expr {
  Expr* base;
  Expr* exponent;
};
struct Conditional : Expr {
  Expr* condition;
  Expr* then;
  Expr* otherwise;
};
struct Call : Expr {
  Expr* callee;
  std::span<Expr*> arguments;
};
struct Index : Expr {
  Expr* base;
  Expr* index;
};
struct Member : Expr {
  Expr* base;
  std::string_view id;
  Span id_span;
};

struct Stmt;

struct Parameter {
  std::string_view id;
  Span span;
  Expr* fallback;   // the default, or null
  Binding binding;  // resolved: local
};

/// Where a new closure finds a variable that it captures (resolved).
struct Capture {
  bool from_captured;  // else from the local boxes of the function around it
  std::uint32_t slot;
};

/// The common part of `fn name(...)`, `fn (...) -> e` and `fn (...) { }`.
struct Function {
  std::string_view id;  // empty for a function without a name
  Span span;            // of the name, or of the `fn` of a function without one
  std::span<Parameter> parameters;
  Expr* expression;             // the body: an expression, or null
  std::span<Stmt*> body;        // and then a block
  std::span<Capture> captures;  // resolved
  std::span<std::uint32_t>
      boxes;  // resolved: captured variables of the body's own scope (parameters say so themselves)
  std::uint32_t frame_size;  // resolved: local slots
};
struct FunctionExpr : Expr {
  Function* function;
};

/// `name value, value ...` in a block.
struct Attribute {
  std::string_view id;
  Span span;  // of the name
  std::span<Expr*> values;
};

/// `kind "name" { positional values, then attributes }`. A group has no positional values; its attributes
/// stand among its statements, as AttributeStmt.
struct Block : Expr {
  Kind block_kind;
  Span kind_span;  // of the kind; for the `{ }` after a material attribute, of that attribute's name
  String* name;    // or null
  std::span<Expr*> positional;
  std::span<Attribute> attributes;
  std::span<Stmt*> statements;     // of a group
  std::span<std::uint32_t> boxes;  // resolved, of a group: captured variables of its scope
};

// --- Statements
// ----------------------------------------------------------------------------------------------

enum class StmtKind : std::uint8_t {
  expression,
  attribute,
  let,
  function,
  assign,
  branch,
  for_loop,
  while_loop,
  break_loop,
  continue_loop,
  give_back,
  include,
  modify,
  remove,
  settings,
};

struct Stmt {
  StmtKind kind;
  Span span;
};

/// Statements in braces: a scope of their own.
struct Scope {
  std::span<Stmt*> statements;
  std::span<std::uint32_t> boxes;  // resolved: local slots that are captured, renewed on each entry
};

struct ExprStmt : Stmt {
  Expr* value;
};
/// An attribute among the statements of a group.
struct AttributeStmt : Stmt {
  Attribute attribute;
};
struct Let : Stmt {
  std::string_view id;
  Span id_span;
  Expr* value;
  Binding binding;  // resolved
  bool used;        // resolved: false means that it is not evaluated
};
struct FunctionStmt : Stmt {
  Function* function;
  Binding binding;  // resolved
  bool used;        // resolved
};
struct Assign : Stmt {
  std::string_view id;
  Span id_span;
  Expr* value;
  Binding binding;  // resolved
};
struct BranchArm {
  Expr* condition;
  Scope body;
};
struct Branch : Stmt {
  std::span<BranchArm> arms;
  bool has_else;
  Scope otherwise;
};
struct ForLoop : Stmt {
  std::string_view id;
  Span id_span;
  Expr* sequence;
  Scope body;       // its boxes include the loop variable's, where captured
  Binding binding;  // resolved: local
};
struct WhileLoop : Stmt {
  Expr* condition;
  Scope body;
};
struct Return : Stmt {
  Expr* value;
};  // value may be null
/// `include "path"`. The loader sets `script` to the position of the included script in its list, or to
/// k_no_script where the file was read before and nothing is left to do.
struct Include : Stmt {
  std::string_view path;
  Span path_span;
  std::uint32_t script;
};
inline constexpr std::uint32_t k_no_script = 0xFFFFFFFF;
/// `modify "glob" { attributes }`; the block's kind is not known before the objects are.
struct Modify : Stmt {
  String* pattern;
  std::span<Attribute> attributes;
};
struct Remove : Stmt {
  String* pattern;
};
struct Settings : Stmt {
  Span kind_span;
  std::span<Attribute> attributes;
};

/// One file, parsed.
struct Script {
  std::uint32_t file = 0;
  Arena arena;
  std::span<Stmt*> statements;
  std::uint32_t frame_size = 0;  // resolved: local slots of loops, branches and groups at top level
};

template <class T>
const T& as(const Expr& e) {
  return static_cast<const T&>(e);
}
template <class T>
T& as(Expr& e) {
  return static_cast<T&>(e);
}
template <class T>
const T& as(const Stmt& s) {
  return static_cast<const T&>(s);
}
template <class T>
T& as(Stmt& s) {
  return static_cast<T&>(s);
}

/// The tree in an indented form, one node a line, for `dump --ast` and for tests.
std::string dump(const Script& script);

}  // namespace lancer::ast
