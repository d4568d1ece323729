#pragma once
// Shapes, groups, lights and views as values of the language: what was written, checked, and ready to be
// placed in a Scene. Objects are immutable; groups share their members.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/transform.hpp"
#include "lang/ast.hpp"
#include "lang/value.hpp"

namespace lancer::lang {

/// A three-point cube: the unit cube in `frame`; else a plain box.
struct BoxRecord {
  Vec3 lo, hi;
  std::optional<Affine> frame;
};

struct FacetRecord {
  Vec3 a, b, c;
  std::optional<std::array<Vec3, 3>> normals;  // unit length
};

/// The checked data of an object, in its own space. Groups have none.
using Record = std::variant<std::monostate, scene::Sphere, scene::Plane, BoxRecord, FacetRecord,
                            std::shared_ptr<const scene::Mesh>, scene::Light, scene::View>;

struct Object : Shared {
  ast::Kind kind = ast::Kind::group;
  std::string name;              // empty when none was given
  Span source;                   // the whole block, or the call that made this group
  std::vector<Written> written;  // transforms, material and shadow aside
  Record record;
  Affine transform;            // of all the transforms, in the order written
  Ref<MaterialData> material;  // null where none was set
  std::optional<bool> shadow;
  std::vector<Ref<Object>> members;  // of a group
  std::uint64_t count = 1;  // objects in all: this one and, of a group, its members, shared ones each time
};

}  // namespace lancer::lang
