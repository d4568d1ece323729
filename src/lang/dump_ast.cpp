// The tree as text, one node a line, two spaces for each level.

#include <array>
#include <fmt/format.h>
#include <utility>

#include "base/number.hpp"
#include "lang/ast.hpp"
#include "lang/keywords.hpp"

namespace lancer::ast {
namespace {

class Dumper {
 public:
  std::string take() { return std::move(out_); }
  void statements(std::span<Stmt* const> all);

 private:
  /// Everything written during the life of a Level stands one step further in.
  struct Level {
    explicit Level(Dumper& d) : dumper(d) { ++dumper.depth_; }
    ~Level() { --dumper.depth_; }
    Dumper& dumper;
  };

  void line(std::string_view text) {
    out_.append(2 * depth_, ' ');
    out_ += text;
    out_ += '\n';
  }
  void statement(const Stmt& s);
  void expr(const Expr& e);
  void exprs(std::string_view head, std::span<Expr* const> all);
  void string(const String& s);
  void chain(const Chain& c);
  void block(const Block& b);
  void function(std::string_view head, const Function& f);
  void attribute(const Attribute& a);
  void branch(const Branch& b);
  void titled(std::string_view head, const Expr* e);
  void body(std::string_view head, std::span<Stmt* const> all);
  void changes(std::string_view head, const String& pattern, std::span<const Attribute> attributes);

  std::string out_;
  std::size_t depth_ = 0;
};

std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    switch (c) {
      case '\n': out += "\\n"; break;
      case '\t': out += "\\t"; break;
      case '"': out += "\\\""; break;
      case '\\': out += "\\\\"; break;
      case '{': out += "\\{"; break;
      default: out += c;
    }
  }
  return out + '"';
}

std::string_view symbol(CompareOp op) {
  switch (op) {
    case CompareOp::equal: return "==";
    case CompareOp::not_equal: return "!=";
    case CompareOp::less: return "<";
    case CompareOp::less_equal: return "<=";
    case CompareOp::greater: return ">";
    case CompareOp::greater_equal: return ">=";
  }
  return "";
}

std::string_view symbol(UnaryOp op) {
  switch (op) {
    case UnaryOp::minus: return "negate";
    case UnaryOp::plus: return "plus";
    case UnaryOp::logical_not: return "not";
  }
  return "";
}

void Dumper::statements(std::span<Stmt* const> all) {
  for (const Stmt* s : all) statement(*s);
}

void Dumper::body(std::string_view head, std::span<Stmt* const> all) {
  line(head);
  const Level level(*this);
  statements(all);
}

void Dumper::titled(std::string_view head, const Expr* e) {
  line(head);
  const Level level(*this);
  if (e != nullptr) expr(*e);
}

void Dumper::statement(const Stmt& s) {
  switch (s.kind) {
    case StmtKind::expression: return titled("add", as<ExprStmt>(s).value);
    case StmtKind::attribute: return attribute(as<AttributeStmt>(s).attribute);
    case StmtKind::let: return titled(fmt::format("let {}", as<Let>(s).id), as<Let>(s).value);
    case StmtKind::function:
      return function(fmt::format("fn {}", as<FunctionStmt>(s).function->id), *as<FunctionStmt>(s).function);
    case StmtKind::assign: return titled(fmt::format("assign {}", as<Assign>(s).id), as<Assign>(s).value);
    case StmtKind::branch: return branch(as<Branch>(s));
    case StmtKind::for_loop: {
      titled(fmt::format("for {}", as<ForLoop>(s).id), as<ForLoop>(s).sequence);
      const Level level(*this);
      return body("do", as<ForLoop>(s).body.statements);
    }
    case StmtKind::while_loop: {
      titled("while", as<WhileLoop>(s).condition);
      const Level level(*this);
      return body("do", as<WhileLoop>(s).body.statements);
    }
    case StmtKind::break_loop: return line("break");
    case StmtKind::continue_loop: return line("continue");
    case StmtKind::give_back: return titled("return", as<Return>(s).value);
    case StmtKind::include: return line(fmt::format("include {}", quoted(as<Include>(s).path)));
    case StmtKind::modify: return changes("modify", *as<Modify>(s).pattern, as<Modify>(s).attributes);
    case StmtKind::remove: return changes("remove", *as<Remove>(s).pattern, {});
    case StmtKind::settings: {
      line("settings");
      const Level level(*this);
      for (const Attribute& a : as<Settings>(s).attributes) attribute(a);
      return;
    }
  }
}

void Dumper::changes(std::string_view head, const String& pattern, std::span<const Attribute> attributes) {
  line(head);
  const Level level(*this);
  string(pattern);
  for (const Attribute& a : attributes) attribute(a);
}

void Dumper::branch(const Branch& b) {
  line("if");
  const Level level(*this);
  for (const BranchArm& arm : b.arms) {
    titled("when", arm.condition);
    body("then", arm.body.statements);
  }
  if (b.has_else) body("else", b.otherwise.statements);
}

void Dumper::attribute(const Attribute& a) { exprs(fmt::format("attribute {}", a.id), a.values); }

void Dumper::exprs(std::string_view head, std::span<Expr* const> all) {
  line(head);
  const Level level(*this);
  for (const Expr* e : all) expr(*e);
}

void Dumper::function(std::string_view head, const Function& f) {
  line(head);
  const Level level(*this);
  for (const Parameter& p : f.parameters) titled(fmt::format("parameter {}", p.id), p.fallback);
  if (f.expression != nullptr) return titled("value", f.expression);
  body("do", f.body);
}

void Dumper::string(const String& s) {
  if (s.parts.size() <= 1 && (s.parts.empty() || s.parts[0].value == nullptr)) {
    return line(fmt::format("string {}", quoted(s.parts.empty() ? std::string_view() : s.parts[0].text)));
  }
  line("string");
  const Level level(*this);
  for (const StringPart& part : s.parts) {
    if (!part.text.empty()) line(quoted(part.text));
    if (part.value != nullptr) expr(*part.value);
  }
}

void Dumper::chain(const Chain& c) {
  line("chain");
  const Level level(*this);
  expr(*c.first);
  for (const Link& link : c.links) titled(symbol(link.op), link.operand);
}

void Dumper::block(const Block& b) {
  line(lang::kind_info(b.block_kind).id);
  const Level level(*this);
  if (b.name != nullptr) titled("name", b.name);
  for (const Expr* e : b.positional) titled("value", e);
  for (const Attribute& a : b.attributes) attribute(a);
  statements(b.statements);
}

void Dumper::expr(const Expr& e) {
  const auto two = [this](std::string_view head, Expr* a, Expr* b) { exprs(head, std::array{a, b}); };
  switch (e.kind) {
    case ExprKind::number: return line(fmt::format("number {}", to_text(as<Number>(e).value)));
    case ExprKind::boolean: return line(as<Boolean>(e).value ? "true" : "false");
    case ExprKind::color: {
      const auto& c = as<ColorLiteral>(e);
      return line(fmt::format("color {} {} {}", to_text(c.r), to_text(c.g), to_text(c.b)));
    }
    case ExprKind::string: return string(as<String>(e));
    case ExprKind::name: return line(fmt::format("name {}", as<Name>(e).id));
    case ExprKind::vector: return exprs("vector", as<Vector>(e).components);
    case ExprKind::list: return exprs("list", as<List>(e).items);
    case ExprKind::range:
      return two(as<Range>(e).closed ? "range ..=" : "range ..", as<Range>(e).first, as<Range>(e).last);
    case ExprKind::unary: return titled(symbol(as<Unary>(e).op), as<Unary>(e).operand);
    case ExprKind::chain: return chain(as<Chain>(e));
    case ExprKind::logical: return exprs(as<Logical>(e).is_and ? "and" : "or", as<Logical>(e).operands);
    case ExprKind::compare:
      return two(fmt::format("compare {}", symbol(as<Compare>(e).op)), as<Compare>(e).left,
                 as<Compare>(e).right);
    case ExprKind::power: return two("power", as<Power>(e).base, as<Power>(e).exponent);
    case ExprKind::conditional:
      return exprs("choose", std::array{as<Conditional>(e).condition, as<Conditional>(e).then,
                                        as<Conditional>(e).otherwise});
    case ExprKind::call: {
      titled("call", as<Call>(e).callee);
      const Level level(*this);
      for (const Expr* argument : as<Call>(e).arguments) expr(*argument);
      return;
    }
    case ExprKind::index: return two("index", as<Index>(e).base, as<Index>(e).index);
    case ExprKind::member: return titled(fmt::format("member {}", as<Member>(e).id), as<Member>(e).base);
    case ExprKind::function: return function("function", *as<FunctionExpr>(e).function);
    case ExprKind::block: return block(as<Block>(e));
  }
}

}  // namespace

std::string dump(const Script& script) {
  Dumper dumper;
  dumper.statements(script.statements);
  return dumper.take();
}

}  // namespace lancer::ast
