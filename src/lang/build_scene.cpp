// From objects to a Scene: groups dissolved, transforms and materials shared.

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "base/math.hpp"
#include "lang/build_object.hpp"
#include "lang/geometry_checks.hpp"
#include "lang/keywords.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

using scene::Index;

/// Mixes the content of what is stored once for all that are equal. 0 and -0 are equal, and hash alike.
class Hash {
 public:
  void add(std::uint64_t bits) {
    state_ = (state_ ^ bits) * 0x9E3779B97F4A7C15ULL;
    state_ ^= state_ >> 29;
  }
  void add(double v) { add(std::bit_cast<std::uint64_t>(v + 0.0)); }
  void add(Vec3 v) { add(v.x), add(v.y), add(v.z); }
  void add(Color c) { add(c.r), add(c.g), add(c.b); }
  void add(const scene::Texture& t) { add(t.color), add(std::uint64_t{t.pattern}); }
  std::size_t value() const { return static_cast<std::size_t>(state_); }

 private:
  std::uint64_t state_ = 0;
};

struct Hasher {
  std::size_t operator()(const Affine& a) const {
    Hash h;
    for (const Vec3 row : a.rows) h.add(row);
    h.add(a.translation);
    h.add(a.rest);
    return h.value();
  }
  std::size_t operator()(const scene::Pattern& p) const {
    Hash h;
    h.add(static_cast<std::uint64_t>(p.kind));
    h.add(p.a), h.add(p.b), h.add(p.size), h.add(p.axis), h.add(p.from), h.add(p.to);
    return h.value();
  }
  std::size_t operator()(const scene::Material& m) const {
    Hash h;
    h.add(m.ambient), h.add(m.diffuse), h.add(m.specular), h.add(m.reflection), h.add(m.transmission);
    h.add(m.shininess), h.add(m.ior), h.add(std::uint64_t{m.fresnel});
    return h.value();
  }
};

template <class T>
using Places = std::unordered_map<T, Index, Hasher>;

/// The place of `item` in `list`, added if it is new there.
template <class T>
Index place_of(const T& item, std::vector<T>& list, Places<T>& places) {
  const auto [found, is_new] = places.try_emplace(item, static_cast<Index>(list.size()));
  if (is_new) list.push_back(item);
  return found->second;
}

/// What the groups around an object hand down to it.
struct Inherited {
  Affine transform;
  const MaterialData* material = nullptr;
  bool shadow = true;
};

class SceneBuilder {
 public:
  explicit SceneBuilder(Meter& meter) : meter_(meter) {}

  scene::Scene run(const std::vector<Ref<Object>>& objects, const scene::Settings& settings) {
    scene_.settings = settings;
    place_all(objects);
    return std::move(scene_);
  }

 private:
  /// A group that is being dissolved: its members from `next` on are still to be placed.
  struct Open {
    const std::vector<Ref<Object>>* members;
    std::size_t next;
    Inherited inherited;
  };

  void place_all(const std::vector<Ref<Object>>& objects);
  void place(const Object& object, const Inherited& how);
  void place_shape(const Object& object, const Inherited& how);
  void add_record(const Object& object, scene::Shape& shape);
  void place_light(const Object& object, const Affine& map);
  void place_view(const Object& object, const Affine& map);

  /// The place of the map, with its inverse, among the transforms.
  Index transform(const Object& object, const Affine& map);
  Index material(const MaterialData* data);
  scene::Texture texture(const MaterialData::Coefficient& coefficient);
  Index name(const std::string& text);

  Meter& meter_;
  scene::Scene scene_;
  Places<Affine> transforms_{{Affine{}, 0}};
  Places<scene::Pattern> patterns_;
  Places<scene::Material> materials_;
  std::unordered_map<const MaterialData*, Index> known_materials_;
  std::unordered_map<const scene::Mesh*, Index> known_meshes_;
  std::unordered_map<std::string, Index> names_{{"", 0}};
};

Inherited within(const Object& object, const Inherited& outer) {
  return {then(object.transform, outer.transform), object.material ? object.material.get() : outer.material,
          object.shadow.value_or(outer.shadow)};
}

/// Groups may be nested as deep as calls: a list of open ones stands in for recursion.
void SceneBuilder::place_all(const std::vector<Ref<Object>>& objects) {
  std::vector<Open> open{{&objects, 0, {}}};
  while (!open.empty()) {
    Open& innermost = open.back();
    if (innermost.next == innermost.members->size()) {
      open.pop_back();
      continue;
    }
    const Object& object = *(*innermost.members)[innermost.next++];
    meter_.charge(1, object.source);
    const Inherited how = within(object, innermost.inherited);
    if (object.kind == ast::Kind::group) {
      open.push_back({&object.members, 0, how});
    } else {
      place(object, how);
    }
  }
}

[[noreturn]] void refuse_place(const Object& object, Code code, std::string_view what) {
  throw ScriptError(
      code, object.source,
      fmt::format("this {}'s transforms, with those of its groups, {}", kind_info(object.kind).id, what));
}

void check_finite(const Object& object, bool is_finite) {
  if (!is_finite) refuse_place(object, Code::not_finite, "leave the range of numbers");
}

Index SceneBuilder::transform(const Object& object, const Affine& map) {
  if (const auto known = transforms_.find(map); known != transforms_.end()) return known->second;
  check_finite(object, is_finite(map));
  const std::optional<Affine> back = inverse(map);
  if (!back) refuse_place(object, Code::singular, "have no inverse: nothing is left to see");
  scene_.transforms.push_back({map, *back});
  return transforms_[map] = static_cast<Index>(scene_.transforms.size() - 1);
}

scene::Texture SceneBuilder::texture(const MaterialData::Coefficient& coefficient) {
  if (!coefficient.pattern) return {coefficient.color};
  return {{}, place_of(coefficient.pattern->pattern, scene_.patterns, patterns_)};
}

/// `data` may be null: then it is the material of what was given none.
Index SceneBuilder::material(const MaterialData* data) {
  if (const auto known = known_materials_.find(data); known != known_materials_.end()) return known->second;
  const MaterialData standard;
  const MaterialData& m = data != nullptr ? *data : standard;
  const scene::Material placed{texture(m.ambient),
                               texture(m.diffuse),
                               texture(m.specular),
                               texture(m.reflection),
                               texture(m.transmission),
                               m.shininess,
                               m.ior,
                               m.fresnel};
  return known_materials_[data] = place_of(placed, scene_.materials, materials_);
}

Index SceneBuilder::name(const std::string& text) {
  const auto [found, is_new] = names_.try_emplace(text, static_cast<Index>(scene_.names.size()));
  if (is_new) scene_.names.push_back(text);
  return found->second;
}

void SceneBuilder::place(const Object& object, const Inherited& how) {
  if (std::holds_alternative<scene::Light>(object.record)) return place_light(object, how.transform);
  if (std::holds_alternative<scene::View>(object.record)) return place_view(object, how.transform);
  place_shape(object, how);
}

void SceneBuilder::place_shape(const Object& object, const Inherited& how) {
  scene::Shape shape;
  shape.shadow = how.shadow;
  shape.transform = transform(object, how.transform);
  shape.material = material(how.material);
  shape.name = name(object.name);
  shape.source = object.source;
  add_record(object, shape);
  scene_.shapes.push_back(shape);
}

/// Puts a record behind the others of its kind and tells the shape where.
template <class T>
void append(std::vector<T>& records, T record, scene::ShapeKind kind, scene::Shape& shape) {
  shape.kind = kind;
  shape.record = static_cast<Index>(records.size());
  records.push_back(std::move(record));
}

void SceneBuilder::add_record(const Object& object, scene::Shape& shape) {
  if (const auto* sphere = std::get_if<scene::Sphere>(&object.record)) {
    append(scene_.spheres, *sphere, scene::ShapeKind::sphere, shape);
  } else if (const auto* plane = std::get_if<scene::Plane>(&object.record)) {
    append(scene_.planes, *plane, scene::ShapeKind::plane, shape);
  } else if (const auto* box = std::get_if<BoxRecord>(&object.record)) {
    const Index frame = box->frame ? transform(object, *box->frame) : 0;
    append(scene_.boxes, {box->lo, box->hi, frame}, scene::ShapeKind::box, shape);
  } else if (const auto* facet = std::get_if<FacetRecord>(&object.record)) {
    scene::Facet placed{facet->a, facet->b, facet->c};
    if (facet->normals) {
      placed.normals = static_cast<Index>(scene_.facet_normals.size());
      scene_.facet_normals.push_back(*facet->normals);
    }
    append(scene_.facets, placed, scene::ShapeKind::facet, shape);
  } else if (const auto* mesh = std::get_if<std::shared_ptr<const scene::Mesh>>(&object.record)) {
    shape.kind = scene::ShapeKind::mesh;
    const auto [found, is_new] =
        known_meshes_.try_emplace(mesh->get(), static_cast<Index>(scene_.meshes.size()));
    if (is_new) scene_.meshes.push_back(**mesh);
    shape.record = found->second;
  }
}

/// The cube root of |det M|: by how much the map scales lengths on the whole.
double mean_scale(const Affine& map) {
  int exponent = 0;
  const Affine fraction{near_one(map.rows, exponent), {}};
  return std::scalbn(math::cbrt(std::fabs(determinant(fraction))), exponent);
}

/// Moves a point and what is below its last bits.
void move(const Affine& map, Vec3& at, Vec3& rest) {
  const Place moved = map.place({at, rest});
  at = moved.at;
  rest = moved.rest;
}

void SceneBuilder::place_light(const Object& object, const Affine& map) {
  scene::Light light = std::get<scene::Light>(object.record);
  if (transform(object, map) != 0) {
    move(map, light.at, light.at_rest);
    light.direction = map.vector(scaled_to_one(light.direction));
    check_finite(object, is_finite(light.at) && is_finite(light.direction));
    if (light.falloff > 0) {
      light.falloff *= mean_scale(map);
      check_finite(object, std::isfinite(light.falloff) && light.falloff > 0);
    }
  }
  light.name = name(object.name);
  light.source = object.source;
  scene_.lights.push_back(light);
}

void SceneBuilder::place_view(const Object& object, const Affine& map) {
  scene::View view = std::get<scene::View>(object.record);
  if (transform(object, map) != 0) {
    move(map, view.eye, view.eye_rest);
    view.look = map.vector(view.look);
    view.up = map.vector(view.up);
    for (std::size_t i = 0; i < 3; ++i) move(map, view.corners[i], view.corner_rests[i]);
    const auto& [a, b, c] = view.corners;
    check_finite(object, is_finite(view.eye) && is_finite(view.look) && is_finite(view.up) && is_finite(a) &&
                             is_finite(b) && is_finite(c));
    const bool is_flat = view.projection == scene::Projection::corners
                             ? are_on_a_line(a, b, c)
                             : are_parallel({view.look, {}}, {view.up, {}});
    if (is_flat) refuse_place(object, Code::singular, "leave the view nothing to see");
  }
  view.name = name(object.name);
  view.source = object.source;
  scene_.views.push_back(view);
}

}  // namespace

scene::Scene build_scene(const std::vector<Ref<Object>>& objects, const scene::Settings& settings,
                         Meter& meter) {
  return SceneBuilder(meter).run(objects, settings);
}

}  // namespace lancer::lang
