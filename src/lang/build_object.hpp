#pragma once
// From the values of a block to a checked object: forms, defaults, refusals. What leaves here needs no more
// checks.

#include <span>
#include <vector>

#include "base/diagnostic.hpp"
#include "lang/ast.hpp"
#include "lang/limits.hpp"
#include "lang/object.hpp"

namespace lancer::lang {

/// The evaluated attributes of a block, in the order written; `values` are parallel to the expressions, which
/// say where each came from.
struct AttributeValues {
  const ast::Attribute* attribute;
  std::vector<Value> values;
};

struct BlockValues {
  const ast::Block* block;
  std::string name;
  std::vector<Value> positional;
  std::vector<AttributeValues> attributes;
};

/// A shape, light or view. Throws ScriptError at the value at fault; adds warnings (a cube's face that is no
/// square).
Ref<Object> build_object(const BlockValues& values, Meter& meter, std::vector<Diagnostic>& warnings);

/// A group of `members` with the block's attributes, which hold for all of them.
Ref<Object> build_group(const BlockValues& values, std::vector<Ref<Object>> members);

/// The group that a call makes of what its body added.
Ref<Object> build_call_group(Span call, std::vector<Ref<Object>> members);

Ref<MaterialData> build_material(const BlockValues& values);

/// Sets what the block gives; the attributes set before, of which a second setting is a warning, are in
/// `seen`.
void apply_settings(const std::vector<AttributeValues>& attributes, scene::Settings& settings,
                    std::vector<std::string_view>& seen, std::vector<Diagnostic>& warnings);

/// Member `id` of an object or material: as written, or by default, before transforms; `name` of an object.
/// Throws ScriptError(no_member) at `span`.
Value member(const Value& value, std::string_view id, Span span);

/// Places everything that was added in a Scene, groups dissolved. Throws ScriptError(not_finite or singular)
/// at the object whose transform, with those of its groups, goes out of bounds, or Interrupted.
scene::Scene build_scene(const std::vector<Ref<Object>>& objects, const scene::Settings& settings,
                         Meter& meter);

}  // namespace lancer::lang
