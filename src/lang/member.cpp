// Members of objects and materials: as written, or by default.

#include <algorithm>
#include <fmt/format.h>
#include <optional>

#include "lang/build_object.hpp"
#include "lang/keywords.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

using ast::Kind;

std::optional<Value> find_written(const std::vector<Written>& written, std::string_view id) {
  const auto found =
      std::find_if(written.begin(), written.end(), [&](const Written& w) { return w.id == id; });
  if (found == written.end()) return std::nullopt;
  return found->value;
}

Value to_value(const MaterialData::Coefficient& c) {
  if (c.pattern) return Value(c.pattern);
  if (c.color.r == c.color.g && c.color.g == c.color.b) return Value(c.color.r);
  return Value(c.color);
}

std::optional<Value> material_member(const MaterialData& m, std::string_view id) {
  if (id == "color") id = "diffuse";
  if (std::optional<Value> v = find_written(m.written, id)) return v;
  // A default `ambient` is the `diffuse` that was written.
  if (id == "ambient") return material_member(m, "diffuse");
  if (id == "diffuse") return to_value(m.diffuse);
  if (id == "specular") return to_value(m.specular);
  if (id == "reflection") return to_value(m.reflection);
  if (id == "transmission") return to_value(m.transmission);
  if (id == "shininess") return Value(m.shininess);
  if (id == "ior") return Value(m.ior);
  if (id == "fresnel") return Value(m.fresnel);
  return std::nullopt;
}

std::optional<Value> view_default(const scene::View& view, std::string_view id) {
  if (id == "size") return Value(std::vector<Value>{Value(double(view.columns)), Value(double(view.rows))});
  if (id == "up" && view.projection != scene::Projection::corners) return Value(view.up);
  if (id == "fov" && view.projection == scene::Projection::perspective) return Value(view.fov);
  return std::nullopt;
}

std::optional<Value> light_default(const scene::Light& light, std::string_view id) {
  if (id == "color") return Value(1.0);
  if (id == "angle" && light.kind == scene::LightKind::spot) return Value(light.angle);
  if (id == "softness" && light.kind == scene::LightKind::spot) return Value(light.softness);
  return std::nullopt;
}

std::optional<Value> object_member(const Object& object, std::string_view id) {
  if (id == "name") return Value(object.name);
  if (std::optional<Value> v = find_written(object.written, id)) return v;
  if (const auto* view = std::get_if<scene::View>(&object.record)) return view_default(*view, id);
  if (const auto* light = std::get_if<scene::Light>(&object.record)) return light_default(*light, id);
  if (id == "material") return Value(object.material ? object.material : make_ref<MaterialData>());
  if (id == "shadow") return Value(object.shadow.value_or(true));
  if (object.kind == Kind::mesh && (id == "smooth" || id == "solid")) return Value(false);
  return std::nullopt;
}

[[noreturn]] void refuse_member(Kind kind, std::string_view id, Span span) {
  const KindInfo& info = kind_info(kind);
  const AttributeInfo* attribute = find_attribute(kind, id);
  if (attribute != nullptr && attribute->is_transform) {
    throw ScriptError(Code::no_member, span, fmt::format("a {}'s transforms cannot be read", info.id));
  }
  if (attribute != nullptr) {
    throw ScriptError(Code::no_member, span,
                      fmt::format("this {} was given no `{}`, and there is no default", info.id, id));
  }
  std::vector<std::string_view> words;
  if (kind != Kind::material) words.push_back("name");
  for (const AttributeInfo& a : info.attributes) {
    if (!a.is_transform) words.push_back(a.id);
  }
  const std::string_view near = nearest(id, words);
  throw ScriptError(Code::no_member, span, fmt::format("a {} has no member `{}`", info.id, id),
                    near.empty() ? fmt::format("its members are `{}`", fmt::join(words, "`, `"))
                                 : fmt::format("did you mean `{}`?", near));
}

}  // namespace

Value member(const Value& value, std::string_view id, Span span) {
  if (value.is(Type::material)) {
    if (const auto v = material_member(value.material(), id)) return *v;
    refuse_member(Kind::material, id, span);
  }
  if (!value.is(Type::object)) {
    throw ScriptError(Code::no_member, span, fmt::format("{} has no member `{}`", with_article(value), id));
  }
  if (const auto v = object_member(value.object(), id)) return *v;
  refuse_member(value.object().kind, id, span);
}

}  // namespace lancer::lang
