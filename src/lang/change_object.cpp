#include "lang/change_object.hpp"

#include <algorithm>
#include <deque>
#include <fmt/format.h>
#include <utility>

#include "lang/build_parts.hpp"
#include "lang/check_blocks.hpp"
#include "lang/keywords.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

/// Whether an attribute is kept beside the object's record, and can be set without a look at the others.
bool is_common(std::string_view id) {
  return id == "material" || id == "shadow" || id == "translate" || id == "scale" || id == "rotate";
}

/// A block that says what an object was made of and what is changed, to be built like one that was written.
class Rewritten {
 public:
  Rewritten(const Object& object, const std::vector<AttributeValues>& changes, Span where)
      : place_{ast::ExprKind::name, where} {
    block_.kind = ast::ExprKind::block;
    block_.span = where;
    block_.kind_span = where;
    block_.block_kind = object.kind;
    for (const Written& w : object.written) keep(object, w, changes);
    if (const auto* plane = std::get_if<scene::Plane>(&object.record); plane != nullptr) {
      const bool has_distance =
          std::none_of(object.written.begin(), object.written.end(),
                       [](const Written& w) { return w.id == "point" || w.id == "points"; });
      if (has_distance) keep(object, {k_plane_distance, Value(plane->offset)}, changes);
    }
    for (const AttributeValues& c : changes) add(*c.attribute, c.values);
    block_.attributes = attributes_;
    for (std::size_t i = 0; i < attributes_.size(); ++i) values_.attributes[i].attribute = &attributes_[i];
    values_.block = &block_;
    values_.name = object.name;
  }
  Rewritten(const Rewritten&) = delete;
  Rewritten& operator=(const Rewritten&) = delete;

  const ast::Block& block() const { return block_; }
  const BlockValues& values() const { return values_; }
  /// A plane given by a distance is in a form that has no attributes of its own.
  bool has_distance() const {
    return std::any_of(attributes_.begin(), attributes_.end(),
                       [](const ast::Attribute& a) { return a.id == k_plane_distance; });
  }

 private:
  void keep(const Object& object, const Written& w, const std::vector<AttributeValues>& changes) {
    for (const AttributeValues& c : changes) {
      if (c.attribute->id == w.id || !go_together(object.kind, w.id, c.attribute->id)) return;
    }
    const AttributeInfo* info = find_attribute(object.kind, w.id);
    const bool is_many = info != nullptr && info->min_values > 1 && w.value.is(Type::list);
    std::vector<Value> values = is_many ? w.value.items() : std::vector<Value>{w.value};
    places_.emplace_back(values.size(), &place_);
    add({w.id, block_.kind_span, places_.back()}, std::move(values));
  }

  void add(const ast::Attribute& attribute, std::vector<Value> values) {
    attributes_.push_back(attribute);
    values_.attributes.push_back({nullptr, std::move(values)});
  }

  ast::Expr place_;  // of what is not written in the statement
  std::deque<std::vector<ast::Expr*>> places_;
  std::vector<ast::Attribute> attributes_;
  ast::Block block_{};
  BlockValues values_{};
};

void throw_first(std::vector<Diagnostic> diagnostics) {
  if (!diagnostics.empty()) throw ScriptError(std::move(diagnostics.front()));
}

/// Unknown attributes and numbers of values, which depend on the kind of the object.
void check_changes(const Object& object, const std::vector<AttributeValues>& changes) {
  std::vector<ast::Attribute> attributes;
  for (const AttributeValues& c : changes) attributes.push_back(*c.attribute);
  ast::Block block{};
  block.block_kind = object.kind;
  block.attributes = attributes;
  std::vector<Diagnostic> found;
  check_block(block, true, found);
  throw_first(std::move(found));
}

/// Material, shadow and transforms.
void set_common(Object& out, const Rewritten& rewritten) {
  const BlockReader reader(rewritten.values());
  if (const auto slot = reader.find("material")) {
    if (!slot->one().value->is(Type::material)) refuse_material(slot->one());
    out.material = slot->one().value->ref<MaterialData>();
  }
  if (const auto slot = reader.find("shadow")) out.shadow = read_boolean(slot->one());
  out.transform = build_transform(rewritten.values(), out.transform);
}

}  // namespace

Ref<Object> change_object(const Object& object, const std::vector<AttributeValues>& changes, Span where,
                          Meter& meter, std::vector<Diagnostic>& warnings) {
  check_changes(object, changes);
  const Rewritten rewritten(object, changes, where);
  Ref<Object> out(new Object(object));
  set_common(*out, rewritten);
  const bool is_placed_only = std::all_of(
      changes.begin(), changes.end(), [](const AttributeValues& c) { return is_common(c.attribute->id); });
  if (is_placed_only) return out;
  if (!rewritten.has_distance()) {
    std::vector<Diagnostic> found;
    check_form(rewritten.block(), found);
    throw_first(std::move(found));
  }
  const BlockReader reader(rewritten.values());
  out->written = reader.written();
  out->record = build_record(reader, meter, warnings);
  return out;
}

}  // namespace lancer::lang
