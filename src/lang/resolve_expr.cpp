// Expressions, functions and blocks.

#include <fmt/format.h>

#include "lang/builtins.hpp"
#include "lang/check_blocks.hpp"
#include "lang/keywords.hpp"
#include "lang/resolver.hpp"

namespace lancer::lang {
namespace {

using ast::as;
using ast::ExprKind;
using Where = ast::Binding::Where;

}  // namespace

void Resolver::resolve_all(std::span<ast::Expr*> expressions) {
  for (ast::Expr* e : expressions) resolve_expr(*e);
}

void Resolver::resolve_expr(ast::Expr& e) {
  switch (e.kind) {
    case ExprKind::number:
    case ExprKind::boolean:
    case ExprKind::color: return;
    case ExprKind::string: return resolve_string(&as<ast::String>(e));
    case ExprKind::name: return resolve_name(as<ast::Name>(e), nullptr);
    case ExprKind::vector: return resolve_all(as<ast::Vector>(e).components);
    case ExprKind::list: return resolve_all(as<ast::List>(e).items);
    case ExprKind::range:
      resolve_expr(*as<ast::Range>(e).first);
      return resolve_expr(*as<ast::Range>(e).last);
    case ExprKind::unary: return resolve_expr(*as<ast::Unary>(e).operand);
    case ExprKind::chain:
      resolve_expr(*as<ast::Chain>(e).first);
      for (const ast::Link& link : as<ast::Chain>(e).links) resolve_expr(*link.operand);
      return;
    case ExprKind::logical: return resolve_all(as<ast::Logical>(e).operands);
    case ExprKind::compare:
      resolve_expr(*as<ast::Compare>(e).left);
      return resolve_expr(*as<ast::Compare>(e).right);
    case ExprKind::power:
      resolve_expr(*as<ast::Power>(e).base);
      return resolve_expr(*as<ast::Power>(e).exponent);
    case ExprKind::conditional:
      resolve_expr(*as<ast::Conditional>(e).condition);
      resolve_expr(*as<ast::Conditional>(e).then);
      return resolve_expr(*as<ast::Conditional>(e).otherwise);
    case ExprKind::call:
      resolve_expr(*as<ast::Call>(e).callee);
      return resolve_all(as<ast::Call>(e).arguments);
    case ExprKind::index:
      resolve_expr(*as<ast::Index>(e).base);
      return resolve_expr(*as<ast::Index>(e).index);
    case ExprKind::member: return resolve_expr(*as<ast::Member>(e).base);
    case ExprKind::function: return resolve_function(*as<ast::FunctionExpr>(e).function);
    case ExprKind::block: return resolve_block(as<ast::Block>(e));
  }
}

void Resolver::resolve_string(const ast::String* string) {
  if (string == nullptr) return;
  for (const ast::StringPart& part : string->parts) {
    if (part.value != nullptr) resolve_expr(*part.value);
  }
}

void Resolver::resolve_name(ast::Name& name, const ast::Block* begun) {
  if (Variable* v = find(name.id)) {
    bind(*v, name.binding);
    uses_.mention(owner_, v->node);
  } else if (const auto function = find_builtin(name.id)) {
    name.binding = {Where::function, false, *function};
  } else if (const auto constant = find_constant(name.id)) {
    name.binding = {Where::constant, false, *constant};
  } else {
    unknown(name.id, name.span, begun);
  }
}

void Resolver::resolve_block(ast::Block& block) {
  resolve_string(block.name);
  const std::size_t reported = out_.diagnostics.size();
  if (!block.positional.empty() && block.positional[0]->kind == ExprKind::name) {
    resolve_name(as<ast::Name>(*block.positional[0]), &block);
    resolve_all(block.positional.subspan(1));
  } else {
    resolve_all(block.positional);
  }
  const bool doubtful = out_.diagnostics.size() != reported;
  for (const ast::Attribute& a : block.attributes) resolve_attribute(a, block.block_kind);
  if (block.block_kind == ast::Kind::group) {
    LexicalScope scope;
    std::vector<std::uint32_t> boxes;
    enter(scope);
    hoist(block.statements);
    resolve_statements(block.statements);
    leave(scope, boxes);
    block.boxes = keep(boxes);
  }
  if (!quiet_) check_block(block, doubtful, out_.diagnostics);
}

/// The values behind another language's word are part of one mistake with it.
void Resolver::resolve_attribute(const ast::Attribute& attribute, ast::Kind kind) {
  const bool was_quiet = quiet_;
  if (find_attribute(kind, attribute.id) == nullptr && !foreign_hint(attribute.id).empty()) quiet_ = true;
  resolve_all(attribute.values);
  quiet_ = was_quiet;
}

void Resolver::resolve_function(ast::Function& function) {
  Frame frame;
  frame.outer = frame_;
  frame_ = &frame;
  LexicalScope parameters, body;
  std::vector<std::uint32_t> boxes, parameter_boxes;
  enter(parameters);
  declare_parameters(function);
  if (function.expression != nullptr) {
    resolve_expr(*function.expression);
  } else {
    enter(body);
    hoist(function.body);
    resolve_statements(function.body);
    leave(body, boxes);
  }
  leave(parameters, parameter_boxes);
  frame_ = frame.outer;
  function.boxes = keep(boxes);
  function.captures = arena_->copy(frame.captures.data(), frame.captures.size());
  function.frame_size = frame.size;
}

void Resolver::declare_parameters(ast::Function& function) {
  bool needs_fallback = false;
  for (ast::Parameter& p : function.parameters) {
    if (p.fallback != nullptr) {
      resolve_expr(*p.fallback);
      needs_fallback = true;
    } else if (needs_fallback) {
      out_.diagnostics.push_back(
          error(Code::syntax, p.span,
                fmt::format("`{}` stands behind a parameter with a default and has none", p.id),
                fmt::format("give it one, `{} = ..`, or put it first", p.id)));
    }
    declare(new_variable(p.id, p.span), p.binding);
  }
}

}  // namespace lancer::lang
