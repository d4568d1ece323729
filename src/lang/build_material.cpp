// Materials: what light does at a surface.

#include <array>
#include <fmt/format.h>

#include "base/number.hpp"
#include "lang/build_parts.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

void check_pattern(const Argument& argument, const scene::Pattern& pattern) {
  for (const Color c : {pattern.a, pattern.b}) {
    if (!has_negative(c)) continue;
    throw ScriptError(
        Code::negative, argument.span,
        fmt::format("{} is not negative; this pattern has {} in it", subject(argument), to_text(c)));
  }
}

void set(std::vector<Written>& written, const Written& entry) {
  for (Written& w : written) {
    if (w.id == entry.id) {
      w.value = entry.value;
      return;
    }
  }
  written.push_back(entry);
}

MaterialData start_from(const Argument& from) {
  if (!from.value->is(Type::material)) refuse_material(from);
  return from.value->material();
}

}  // namespace

void refuse_material(const Argument& argument) {
  throw ScriptError(
      Code::wrong_type, argument.span,
      fmt::format("`{}` takes a material; this is {}", argument.id, found_text(*argument.value)),
      "a material is `material { diffuse .. }`, or a name that stands for one");
}

MaterialData::Coefficient read_coefficient(const Argument& argument) {
  const Value& v = *argument.value;
  if (v.is(Type::pattern)) {
    check_pattern(argument, v.pattern().pattern);
    return {{}, v.ref<PatternData>()};
  }
  if (v.is(Type::function)) {
    throw ScriptError(
        Code::not_yet, argument.span,
        fmt::format("{} cannot be a function yet: that comes with a later version", subject(argument)),
        "`checker`, `stripes` and `gradient` are there");
  }
  if (!v.is(Type::number) && !(v.is(Type::vector) && v.dimension() == 3)) {
    refuse_type(
        argument, "a colour or a pattern",
        "a colour is rgb(1, 0.5, 0), #ff8000, orange, or 0.8 for a grey; a pattern is checker(white, 0.2)");
  }
  const Color c = read_color(argument);
  if (has_negative(c)) refuse(Code::negative, argument, "is not negative", to_text(c));
  return {c, {}};
}

Ref<MaterialData> build_material(const BlockValues& values) {
  const BlockReader reader(values);
  MaterialData m;
  if (const auto from = reader.find("from")) m = start_from(from->one());
  for (const Written& w : reader.written()) set(m.written, w.id == "color" ? Written{"diffuse", w.value} : w);

  using Target = std::pair<std::string_view, MaterialData::Coefficient MaterialData::*>;
  static constexpr std::array k_coefficients{
      Target{"diffuse", &MaterialData::diffuse},       Target{"color", &MaterialData::diffuse},
      Target{"ambient", &MaterialData::ambient},       Target{"specular", &MaterialData::specular},
      Target{"reflection", &MaterialData::reflection}, Target{"transmission", &MaterialData::transmission}};
  for (const auto& [id, member] : k_coefficients) {
    if (const auto slot = reader.find(id)) m.*member = read_coefficient(slot->one());
  }
  m.ambient_written = m.ambient_written || reader.has("ambient");
  if (!m.ambient_written) m.ambient = m.diffuse;
  if (const auto slot = reader.find("shininess")) m.shininess = read_not_negative(slot->one());
  if (const auto slot = reader.find("ior")) m.ior = read_positive(slot->one());
  if (const auto slot = reader.find("fresnel")) m.fresnel = read_boolean(slot->one());
  return make_ref<MaterialData>(std::move(m));
}

}  // namespace lancer::lang
