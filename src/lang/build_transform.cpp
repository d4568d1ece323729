// translate, scale and rotate.

#include <fmt/format.h>

#include "base/number.hpp"
#include "lang/build_parts.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

[[noreturn]] void refuse_value(const Slot& slot, std::size_t i, std::string_view wanted) {
  throw ScriptError(Code::wrong_type, slot[i].span,
                    fmt::format("`{}` takes {}; this is {}", slot.id, wanted, found_text(*slot[i].value)));
}

Vec3 read_vector(const Slot& slot, std::size_t i, std::string_view wanted) {
  const Value& v = *slot[i].value;
  if (!v.is(Type::vector) || v.dimension() != 3) refuse_value(slot, i, wanted);
  return v.vec3();
}

Affine read_scale(const Slot& slot) {
  const Value& v = *slot[0].value;
  const Vec3 factors = v.is(Type::number) ? Vec3{v.number(), v.number(), v.number()}
                                          : read_vector(slot, 0, "a number or a vector <x, y, z>");
  if (factors.x == 0 || factors.y == 0 || factors.z == 0) {
    throw ScriptError(Code::singular, slot.span(), "a scale by 0 cannot be undone",
                      "an axis that is to stay as it is has the factor 1");
  }
  return scaling(factors);
}

Affine read_rotation(const Slot& slot) {
  if (slot.size() == 1) {
    return rotation(read_vector(slot, 0, "angles <x, y, z>, or an axis and an angle"));
  }
  const Vec3 axis = read_vector(slot, 0, "an axis <x, y, z> and an angle");
  if (!slot[1].value->is(Type::number)) refuse_value(slot, 1, "an axis <x, y, z> and an angle");
  if (axis == Vec3{}) {
    throw ScriptError(Code::degenerate, slot[0].span, "an axis is not zero",
                      "write the direction to turn about, such as <0, 1, 0> or y");
  }
  return rotation(axis, slot[1].value->number());
}

Affine read_transform(const Slot& slot) {
  if (slot.id == "translate") return translation(read_vector(slot, 0, "a vector <x, y, z>"));
  return slot.id == "scale" ? read_scale(slot) : read_rotation(slot);
}

}  // namespace

Affine build_transform(const BlockValues& values, const Affine& first) {
  Affine out = first;
  for (const AttributeValues& a : values.attributes) {
    const std::string_view id = a.attribute->id;
    if (id != "translate" && id != "scale" && id != "rotate") continue;
    const Slot slot{values.block->block_kind, id, a.values, a.attribute->values};
    out = then(out, read_transform(slot));
    if (!is_finite(out)) {
      throw ScriptError(Code::not_finite, slot.span(),
                        fmt::format("with this `{}` the transforms leave the range of numbers", id));
    }
    if (!inverse(out)) {
      throw ScriptError(Code::singular, slot.span(), "these transforms cannot be undone",
                        "they shrink what they are applied to beyond what numbers can tell apart");
    }
  }
  return out;
}

}  // namespace lancer::lang
