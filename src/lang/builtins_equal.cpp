// When two values are equal.

#include <algorithm>
#include <type_traits>

#include "base/deep_stack.hpp"
#include "lang/builtins.hpp"
#include "lang/object.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

constexpr std::size_t k_stack_to_spare = 256 * 1024;

bool same(const scene::Sphere& a, const scene::Sphere& b) {
  return a.center == b.center && a.radius == b.radius;
}
bool same(const scene::Plane& a, const scene::Plane& b) {
  return a.point == b.point && a.normal == b.normal && a.offset == b.offset;
}
bool same(const BoxRecord& a, const BoxRecord& b) {
  return a.lo == b.lo && a.hi == b.hi && a.frame == b.frame;
}
bool same(const FacetRecord& a, const FacetRecord& b) {
  return a.a == b.a && a.b == b.b && a.c == b.c && a.normals == b.normals;
}
bool same(const std::shared_ptr<const scene::Mesh>& a, const std::shared_ptr<const scene::Mesh>& b) {
  return a == b ||
         (a->points == b->points && a->faces == b->faces && a->normals == b->normals && a->solid == b->solid);
}
bool same(const scene::Light& a, const scene::Light& b) {
  return a.kind == b.kind && a.at == b.at && a.direction == b.direction && a.color == b.color &&
         a.falloff == b.falloff && a.angle == b.angle && a.softness == b.softness;
}
bool same(const scene::View& a, const scene::View& b) {
  return a.projection == b.projection && a.eye == b.eye && a.look == b.look && a.up == b.up &&
         a.fov == b.fov && a.width == b.width && a.corners == b.corners && a.columns == b.columns &&
         a.rows == b.rows;
}
bool same(std::monostate, std::monostate) { return true; }

std::uint64_t elements(const Record& record) {
  const auto* mesh = std::get_if<std::shared_ptr<const scene::Mesh>>(&record);
  return mesh == nullptr ? 1 : (*mesh)->points.size() + (*mesh)->faces.size();
}

/// Compares by content, shared parts at a glance.
class Comparison {
 public:
  Comparison(Meter& meter, Span span) : meter_(meter), span_(span) {}

  bool equal(const Value& a, const Value& b) {
    if (a.type() != b.type()) return false;
    switch (a.type()) {
      case Type::nothing: return true;
      case Type::number: return a.number() == b.number();
      case Type::boolean: return a.boolean() == b.boolean();
      case Type::string: return equal_text(a.text(), b.text());
      case Type::vector: return a.dimension() == b.dimension() && a.vec3() == b.vec3();
      case Type::list: return equal_lists(a.items(), b.items());
      case Type::range: return equal_ranges(a.range(), b.range());
      case Type::function: return equal_functions(a.function(), b.function());
      case Type::pattern: return &a.pattern() == &b.pattern();
      case Type::material: return equal_materials(a.material(), b.material());
      case Type::object: return equal_objects(a.object(), b.object());
    }
    return false;
  }

 private:
  void charge(std::uint64_t steps) { meter_.charge(steps, span_); }

  void check_depth() const {
    if (stack_left() < k_stack_to_spare) {
      throw ScriptError(Code::too_deep, span_, "these values are nested too deep to be compared");
    }
  }

  bool equal_text(const std::string& a, const std::string& b) {
    if (&a == &b || a.size() != b.size()) return &a == &b;
    charge(a.size() / 64);
    return a == b;
  }

  bool equal_lists(const std::vector<Value>& a, const std::vector<Value>& b) {
    if (&a == &b || a.size() != b.size()) return &a == &b;
    check_depth();
    for (std::size_t i = 0; i < a.size(); ++i) {
      charge(1);
      if (!equal(a[i], b[i])) return false;
    }
    return true;
  }

  /// By their elements: 0..3 and 0..=2 are the same numbers.
  static bool equal_ranges(const RangeData& a, const RangeData& b) {
    return a.size() == b.size() && (a.size() == 0 || a.first == b.first);
  }

  static bool equal_functions(const FunctionData& a, const FunctionData& b) {
    return &a == &b || (a.code == nullptr && b.code == nullptr && a.builtin == b.builtin);
  }

  static bool equal_materials(const MaterialData& a, const MaterialData& b) {
    const auto same_look = [](const MaterialData::Coefficient& p, const MaterialData::Coefficient& q) {
      return p.color == q.color && p.pattern == q.pattern;
    };
    return &a == &b || (same_look(a.ambient, b.ambient) && same_look(a.diffuse, b.diffuse) &&
                        same_look(a.specular, b.specular) && same_look(a.reflection, b.reflection) &&
                        same_look(a.transmission, b.transmission) && a.shininess == b.shininess &&
                        a.ior == b.ior && a.fresnel == b.fresnel);
  }

  static bool equal_records(const Record& a, const Record& b) {
    if (a.index() != b.index()) return false;
    return std::visit([&](const auto& left) { return same(left, std::get<std::decay_t<decltype(left)>>(b)); },
                      a);
  }

  bool equal_objects(const Object& a, const Object& b) {
    if (&a == &b) return true;
    const bool dressed = static_cast<bool>(a.material) == static_cast<bool>(b.material) &&
                         (!a.material || equal_materials(*a.material, *b.material));
    charge(elements(a.record));
    if (a.kind != b.kind || a.name != b.name || a.shadow != b.shadow || a.transform != b.transform ||
        !dressed || a.members.size() != b.members.size() || !equal_records(a.record, b.record)) {
      return false;
    }
    check_depth();
    return std::equal(a.members.begin(), a.members.end(), b.members.begin(),
                      [&](const Ref<Object>& left, const Ref<Object>& right) {
                        charge(1);
                        return equal_objects(*left, *right);
                      });
  }

  Meter& meter_;
  Span span_;
};

}  // namespace

bool equal(const Value& a, const Value& b, Meter& meter, Span span) {
  return Comparison(meter, span).equal(a, b);
}

}  // namespace lancer::lang
