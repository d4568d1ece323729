// Blocks: values for the builders of objects.

#include <utility>

#include "lang/evaluator.hpp"

namespace lancer::lang {

std::vector<Value> Evaluator::evaluate_each(std::span<ast::Expr* const> expressions) {
  std::vector<Value> out;
  out.reserve(expressions.size());
  for (const ast::Expr* e : expressions) out.push_back(evaluate(*e));
  return out;
}

AttributeValues Evaluator::evaluate_attribute(const ast::Attribute& attribute) {
  return {&attribute, evaluate_each(attribute.values)};
}

Value Evaluator::evaluate_block(const ast::Block& block) {
  BlockValues values{&block, block.name != nullptr ? text_of(*block.name) : std::string(), {}, {}};
  if (block.block_kind == ast::Kind::group) return evaluate_group(block, std::move(values));
  values.positional = evaluate_each(block.positional);
  values.attributes.reserve(block.attributes.size());
  for (const ast::Attribute& a : block.attributes) values.attributes.push_back(evaluate_attribute(a));
  if (block.block_kind == ast::Kind::material) return Value(build_material(values));
  return Value(build_object(values, meter_, out_.diagnostics));
}

Value Evaluator::evaluate_group(const ast::Block& block, BlockValues values) {
  Collection added;
  Collection* const outer = std::exchange(collection_, &added);
  BlockValues* const outer_group = std::exchange(group_, &values);
  open_scope(block.boxes, block.statements);
  const Flow flow = execute_all(block.statements);
  close_scope(block.boxes);
  collection_ = outer;
  group_ = outer_group;
  if (flow != Flow::next) throw Jump{flow};
  for (const ast::Attribute& a : block.attributes) values.attributes.push_back(evaluate_attribute(a));
  return Value(build_group(values, std::move(added.objects)));
}

}  // namespace lancer::lang
