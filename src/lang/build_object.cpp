#include "lang/build_object.hpp"

#include <fmt/format.h>
#include <limits>
#include <utility>

#include "lang/build_parts.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

using ast::Kind;

/// Name, transforms, material and shadow: what all kinds share.
Object build_common(const BlockReader& reader) {
  const BlockValues& values = reader.values();
  Object object;
  object.kind = reader.kind();
  object.name = values.name;
  object.source = values.block->span;
  object.transform = build_transform(values);
  if (const auto slot = reader.find("material")) {
    if (!slot->one().value->is(Type::material)) {
      refuse_material(slot->one());
    }
    object.material = slot->one().value->ref<MaterialData>();
  }
  if (const auto slot = reader.find("shadow")) object.shadow = read_boolean(slot->one());
  return object;
}

void take_members(Object& group, std::vector<Ref<Object>> members) {
  constexpr std::uint64_t k_most = std::numeric_limits<std::uint64_t>::max();
  for (const Ref<Object>& m : members)
    group.count = m->count > k_most - group.count ? k_most : group.count + m->count;
  group.members = std::move(members);
}

}  // namespace

Record build_record(const BlockReader& reader, Meter& meter, std::vector<Diagnostic>& warnings) {
  switch (reader.kind()) {
    case Kind::mesh: return build_mesh(reader, meter);
    case Kind::light:
    case Kind::sun:
    case Kind::spot: return build_light(reader);
    case Kind::view: return build_view(reader);
    default: return build_shape(reader, warnings);
  }
}

Ref<Object> build_object(const BlockValues& values, Meter& meter, std::vector<Diagnostic>& warnings) {
  const BlockReader reader(values);
  Object object = build_common(reader);
  object.written = reader.written();
  object.record = build_record(reader, meter, warnings);
  return make_ref<Object>(std::move(object));
}

Ref<Object> build_group(const BlockValues& values, std::vector<Ref<Object>> members) {
  Object group = build_common(BlockReader(values));
  take_members(group, std::move(members));
  return make_ref<Object>(std::move(group));
}

Ref<Object> build_call_group(Span call, std::vector<Ref<Object>> members) {
  Object group;
  group.source = call;
  take_members(group, std::move(members));
  return make_ref<Object>(std::move(group));
}

}  // namespace lancer::lang
