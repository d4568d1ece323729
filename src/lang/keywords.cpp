#include "lang/keywords.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace lancer::lang {
namespace {

using ast::Kind;

constexpr AttributeInfo k_translate{"translate", 1, 1, true};
constexpr AttributeInfo k_scale{"scale", 1, 1, true};
constexpr AttributeInfo k_rotate{"rotate", 1, 2, true};
constexpr AttributeInfo k_material{"material"};
constexpr AttributeInfo k_shadow{"shadow"};

constexpr std::array k_sphere{
    AttributeInfo{"center"}, AttributeInfo{"radius"}, k_translate, k_scale, k_rotate, k_material, k_shadow};
constexpr std::array k_plane{AttributeInfo{"point"},
                             AttributeInfo{"normal"},
                             AttributeInfo{"points", 3, 3},
                             k_translate,
                             k_scale,
                             k_rotate,
                             k_material,
                             k_shadow};
constexpr std::array k_cube{AttributeInfo{"center"},
                            AttributeInfo{"side"},
                            AttributeInfo{"points", 3, 3},
                            k_translate,
                            k_scale,
                            k_rotate,
                            k_material,
                            k_shadow};
constexpr std::array k_box{
    AttributeInfo{"corners", 2, 2}, k_translate, k_scale, k_rotate, k_material, k_shadow};
constexpr std::array k_facet{AttributeInfo{"points", 3, 3},
                             AttributeInfo{"normals", 3, 3},
                             k_translate,
                             k_scale,
                             k_rotate,
                             k_material,
                             k_shadow};
constexpr std::array k_mesh{AttributeInfo{"file"},
                            AttributeInfo{"points"},
                            AttributeInfo{"faces"},
                            AttributeInfo{"smooth"},
                            AttributeInfo{"solid"},
                            k_translate,
                            k_scale,
                            k_rotate,
                            k_material,
                            k_shadow};
constexpr std::array k_group{k_translate, k_scale, k_rotate, k_material, k_shadow};
constexpr std::array k_light{
    AttributeInfo{"at"}, AttributeInfo{"color"}, AttributeInfo{"falloff"}, k_translate, k_scale, k_rotate};
constexpr std::array k_sun{AttributeInfo{"direction"}, AttributeInfo{"color"}, k_translate, k_scale,
                           k_rotate};
constexpr std::array k_spot{AttributeInfo{"at"},
                            AttributeInfo{"look_at"},
                            AttributeInfo{"angle"},
                            AttributeInfo{"softness"},
                            AttributeInfo{"color"},
                            AttributeInfo{"falloff"},
                            k_translate,
                            k_scale,
                            k_rotate};
constexpr std::array k_view{AttributeInfo{"eye"},
                            AttributeInfo{"look"},
                            AttributeInfo{"look_at"},
                            AttributeInfo{"up"},
                            AttributeInfo{"fov"},
                            AttributeInfo{"width"},
                            AttributeInfo{"corners", 3, 3},
                            AttributeInfo{"size", 2, 2},
                            k_translate,
                            k_scale,
                            k_rotate};
constexpr std::array k_material_attributes{AttributeInfo{"from"},       AttributeInfo{"diffuse"},
                                           AttributeInfo{"color"},      AttributeInfo{"ambient"},
                                           AttributeInfo{"specular"},   AttributeInfo{"shininess"},
                                           AttributeInfo{"reflection"}, AttributeInfo{"transmission"},
                                           AttributeInfo{"ior"},        AttributeInfo{"fresnel"}};
constexpr std::array k_settings{AttributeInfo{"background"}, AttributeInfo{"ambient"}, AttributeInfo{"depth"},
                                AttributeInfo{"ior"},        AttributeInfo{"shadows"}, AttributeInfo{"sum"},
                                AttributeInfo{"exposure"}};

constexpr std::array k_kinds{KindInfo{Kind::sphere, "sphere", k_sphere, 2},
                             KindInfo{Kind::plane, "plane", k_plane, 3},
                             KindInfo{Kind::cube, "cube", k_cube, 3},
                             KindInfo{Kind::box, "box", k_box, 2},
                             KindInfo{Kind::facet, "facet", k_facet, 3},
                             KindInfo{Kind::mesh, "mesh", k_mesh, 0},
                             KindInfo{Kind::group, "group", k_group, 0},
                             KindInfo{Kind::light, "light", k_light, 0},
                             KindInfo{Kind::sun, "sun", k_sun, 0},
                             KindInfo{Kind::spot, "spot", k_spot, 0},
                             KindInfo{Kind::view, "view", k_view, 0},
                             KindInfo{Kind::material, "material", k_material_attributes, 0},
                             KindInfo{Kind::settings, "settings", k_settings, 0}};

constexpr std::array<std::string_view, 18> k_words{
    "let",      "fn",      "return", "if",     "else", "for",   "in",  "while", "break",
    "continue", "include", "modify", "remove", "true", "false", "and", "or",    "not"};

constexpr std::array<std::string_view, 11> k_statement_words{
    "let", "fn", "return", "if", "for", "while", "break", "continue", "include", "modify", "remove"};

using Hint = std::pair<std::string_view, std::string_view>;
constexpr std::array k_hints{
    Hint{"camera", "a camera is a `view`: view { eye <0, 1, 5>  look_at <0, 0, 0> }"},
    Hint{"location", "the eye of a view is `eye`"},
    Hint{"look_from", "the eye of a view is `eye`"},
    Hint{"position", "the place of a light is `at`, the eye of a view is `eye`"},
    Hint{"direction", "a view looks along `look` or at `look_at`"},
    Hint{"sky", "a view's upward direction is `up`"},
    Hint{"angle", "a view's opening is `fov`, in degrees"},
    Hint{"light_source", "a point light is `light { at <2, 4, 3>  color 0.9 }`"},
    Hint{"point_light", "a point light is `light { at <2, 4, 3>  color 0.9 }`"},
    Hint{"spotlight", "a spotlight is `spot { at .. look_at .. }`"},
    Hint{"parallel", "a light from far away is `sun { direction <0, -1, 0> }`"},
    Hint{"union", "objects are put together by `group { .. }`"},
    Hint{"merge", "objects are put together by `group { .. }`"},
    Hint{"difference", "there are no solid differences; objects are put together by `group { .. }`"},
    Hint{"intersection", "there are no solid intersections; objects are put together by `group { .. }`"},
    Hint{"object",
         "an object is a value: write its name as a statement, or `group { name  translate <1, 0, 0> }`"},
    Hint{"triangle", "a triangle is `facet { a, b, c }`"},
    Hint{"smooth_triangle", "a smooth triangle is `facet { a, b, c  normals na, nb, nc }`"},
    Hint{"polygon", "polygons are made of `facet { a, b, c }` or `mesh { points [..] faces [..] }`"},
    Hint{"mesh2", "a mesh is `mesh { points [..] faces [[0, 1, 2], ..] }`"},
    Hint{"texture", "an object's look is `material { diffuse .. }`"},
    Hint{"pigment", "a material's colour is `diffuse`, as in `material { diffuse rgb(1, 0, 0) }`"},
    Hint{"finish", "a material's `ambient`, `specular`, `reflection` stand in it directly"},
    Hint{"interior", "a material's index of refraction is `ior`"},
    Hint{"phong", "the highlight is `specular` and `shininess`"},
    Hint{"phong_size", "the sharpness of the highlight is `shininess`"},
    Hint{"roughness", "the sharpness of the highlight is `shininess`, about 1 / roughness"},
    Hint{"filter", "what passes through is `transmission`"},
    Hint{"transmit", "what passes through is `transmission`"},
    Hint{"global_settings", "settings stand in `settings { .. }`"},
    Hint{"background", "the background is `settings { background rgb(0, 0, 0.1) }`"},
    Hint{"declare", "a variable is `let name = value`"},
    Hint{"local", "a variable is `let name = value`"},
    Hint{"macro", "a macro is a function: `fn name(a, b) { .. }`"},
    Hint{"module", "a module is a function: `fn name(a, b) { .. }`"},
    Hint{"function", "a function is `fn name(a, b) = value` or `fn (a, b) -> value`"},
    Hint{"def", "a function is `fn name(a, b) = value` or `fn name(a, b) { .. }`"},
    Hint{"var", "a variable is `let name = value`"},
    Hint{"const", "a variable is `let name = value`"},
    Hint{"elif", "write `else if`"},
    Hint{"elseif", "write `else if`"},
    Hint{"ifdef", "there are no textual conditions; write `if`"},
    Hint{"ifndef", "there are no textual conditions; write `if`"},
    Hint{"switch", "write `if .. else if ..`"},
    Hint{"end", "a block ends with `}`"},
    Hint{"null", "there is no null; leave the value out"},
    Hint{"diffuse_color", "a material's colour is `diffuse`"},
    Hint{"colour", "the word is `color`"},
    Hint{"centre", "the word is `center`"},
    Hint{"r", "a sphere's size is `radius`"},
    Hint{"size", "a cube's size is `side`"},
    Hint{"shininess_exponent", "the sharpness of the highlight is `shininess`"},
    Hint{"True", "write `true`"},
    Hint{"False", "write `false`"},
    Hint{"vec3", "a vector is `<1, 2, 3>`"},
    Hint{"echo", "write `print(..)`"},
    Hint{"console", "write `print(..)`"},
    Hint{"printf", "write `print(..)`, with values in strings as \"{value}\""},
};

}  // namespace

const KindInfo& kind_info(Kind kind) { return k_kinds[static_cast<std::size_t>(kind)]; }
std::span<const KindInfo> all_kinds() { return k_kinds; }

std::optional<Kind> find_kind(std::string_view word) {
  const auto* found =
      std::find_if(k_kinds.begin(), k_kinds.end(), [&](const KindInfo& k) { return k.id == word; });
  if (found == k_kinds.end()) return std::nullopt;
  return found->kind;
}

const AttributeInfo* find_attribute(Kind kind, std::string_view word) {
  for (const AttributeInfo& a : kind_info(kind).attributes) {
    if (a.id == word) return &a;
  }
  return nullptr;
}

const AttributeInfo* find_attribute(std::string_view word) {
  for (const KindInfo& k : k_kinds) {
    if (const AttributeInfo* a = find_attribute(k.kind, word)) return a;
  }
  return nullptr;
}

bool is_reserved(std::string_view word) {
  return std::find(k_words.begin(), k_words.end(), word) != k_words.end() || find_kind(word).has_value();
}

std::span<const std::string_view> statement_words() { return k_statement_words; }

std::string_view foreign_hint(std::string_view word) {
  const auto* found =
      std::find_if(k_hints.begin(), k_hints.end(), [&](const Hint& h) { return h.first == word; });
  return found == k_hints.end() ? std::string_view{} : found->second;
}

}  // namespace lancer::lang
