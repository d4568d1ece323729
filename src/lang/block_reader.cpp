#include "lang/block_reader.hpp"

#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include "base/number.hpp"
#include "lang/keywords.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

using ast::Kind;

/// Which attribute values without names fill.
struct Filling {
  std::string_view id;
  std::size_t first, count;
};

/// How `count` values without names are meant in a block of that kind.
std::span<const Filling> fillings(Kind kind, std::size_t count) {
  static constexpr Filling k_sphere[] = {{"center", 0, 1}, {"radius", 1, 1}};
  static constexpr Filling k_plane_level[] = {{"normal", 0, 1}, {k_plane_distance, 1, 1}};
  static constexpr Filling k_points[] = {{"points", 0, 3}};
  static constexpr Filling k_corners[] = {{"corners", 0, 2}};
  if (kind == Kind::sphere && count == 2) return k_sphere;
  if (kind == Kind::plane && count == 2) return k_plane_level;
  if (kind == Kind::box && count == 2) return k_corners;
  if (count == 3) return k_points;
  return {};
}

Value gathered(std::span<const Value> values) {
  if (values.size() == 1) return values[0];
  return Value(std::vector<Value>(values.begin(), values.end()));
}

bool is_written(const AttributeInfo& info) {
  return !info.is_transform && info.id != "material" && info.id != "shadow";
}

/// The attributes of these kinds stand for themselves: "an ior", "a specular colour".
bool stands_for_itself(const Argument& argument) {
  return argument.kind == Kind::material || argument.kind == Kind::settings || argument.id == "size" ||
         argument.id == "fov";
}

/// 65,536.
std::string grouped(int number) {
  std::string out = std::to_string(number);
  for (std::size_t i = out.size(); i > 3; i -= 3) out.insert(i - 3, ",");
  return out;
}

}  // namespace

std::optional<Slot> BlockReader::find(std::string_view id) const {
  for (auto a = values_.attributes.rbegin(); a != values_.attributes.rend(); ++a) {
    if (a->attribute->id == id) return Slot{kind_, id, a->values, a->attribute->values};
  }
  for (const Filling& f : fillings(kind_, values_.positional.size())) {
    if (f.id != id) continue;
    return Slot{kind_, id, std::span(values_.positional).subspan(f.first, f.count),
                std::span<ast::Expr* const>(values_.block->positional).subspan(f.first, f.count)};
  }
  return std::nullopt;
}

Slot BlockReader::need(std::string_view id) const {
  if (std::optional<Slot> slot = find(id)) return *slot;
  throw ScriptError(Code::missing_attribute, kind_span(),
                    fmt::format("a {} needs `{}`", kind_info(kind_).id, id));
}

std::vector<Written> BlockReader::written() const {
  std::vector<Written> out;
  for (const Filling& f : fillings(kind_, values_.positional.size())) {
    if (f.id == k_plane_distance) continue;
    out.push_back({f.id, gathered(std::span(values_.positional).subspan(f.first, f.count))});
  }
  for (const AttributeValues& a : values_.attributes) {
    const AttributeInfo* info = find_attribute(kind_, a.attribute->id);
    if (info != nullptr && is_written(*info)) out.push_back({info->id, gathered(a.values)});
  }
  return out;
}

std::string subject(const Argument& argument) {
  if (!stands_for_itself(argument)) {
    const bool is_one_of_many =
        argument.id == "points" || argument.id == "corners" || argument.id == "normals";
    return fmt::format("{}a {}'s {}", is_one_of_many ? "each of " : "", kind_info(argument.kind).id,
                       argument.id);
  }
  const std::string_view id = argument.id == "color" ? "diffuse" : argument.id;
  const bool is_adjective = id == "diffuse" || id == "ambient" || id == "specular";
  const bool has_vowel = std::string_view("aeiou").find(id[0]) != std::string_view::npos;
  return fmt::format("{} {}{}", has_vowel ? "an" : "a", id, is_adjective ? " colour" : "");
}

std::string found_text(const Value& value) {
  if (value.is(Type::nothing)) return "nothing";
  return value.is(Type::vector) && value.dimension() == 2 ? "a vector of 2" : with_article(value);
}

std::string to_text(Vec3 v) {
  return fmt::format("<{}, {}, {}>", lancer::to_text(v.x), lancer::to_text(v.y), lancer::to_text(v.z));
}

std::string to_text(Color c) {
  return c.r == c.g && c.g == c.b ? lancer::to_text(c.r) : to_text(Vec3{c.r, c.g, c.b});
}

bool has_negative(Color c) { return c.r < 0 || c.g < 0 || c.b < 0; }

void refuse(Code code, const Argument& argument, std::string_view rule, std::string_view found,
            std::string help) {
  throw ScriptError(code, argument.span, fmt::format("{} {}; this one is {}", subject(argument), rule, found),
                    std::move(help));
}

void refuse_type(const Argument& argument, std::string_view wanted, std::string help) {
  throw ScriptError(
      Code::wrong_type, argument.span,
      fmt::format("{} is {}; this is {}", subject(argument), wanted, found_text(*argument.value)),
      std::move(help));
}

double read_number(const Argument& argument) {
  if (!argument.value->is(Type::number)) refuse_type(argument, "a number");
  return argument.value->number();
}

double read_positive(const Argument& argument) {
  const double v = read_number(argument);
  if (!(v > 0)) {
    refuse(Code::not_positive, argument, "is positive", lancer::to_text(v),
           v < 0 ? fmt::format("did you mean {}?", lancer::to_text(-v)) : "write a number above 0");
  }
  return v;
}

double read_not_negative(const Argument& argument) {
  const double v = read_number(argument);
  if (v < 0) {
    refuse(Code::negative, argument, "is not negative", lancer::to_text(v),
           fmt::format("did you mean {}?", lancer::to_text(-v)));
  }
  return v;
}

int read_whole(const Argument& argument, int lowest, int highest) {
  const double v = read_number(argument);
  if (v != std::trunc(v) || v < lowest || v > highest) {
    refuse(Code::out_of_range, argument,
           fmt::format("is whole and from {} to {}", grouped(lowest), grouped(highest)), lancer::to_text(v),
           v == std::trunc(v) ? "" : "`round(..)` makes a number whole");
  }
  return static_cast<int>(v);
}

double read_opening(const Argument& argument) {
  const double v = read_number(argument);
  if (!(v > 0 && v < 180)) {
    refuse(Code::out_of_range, argument, "lies between 0 and 180 degrees", lancer::to_text(v));
  }
  return v;
}

bool read_boolean(const Argument& argument) {
  if (!argument.value->is(Type::boolean)) {
    throw ScriptError(Code::wrong_type, argument.span,
                      fmt::format("`{}` is a boolean; this is {}", argument.id, found_text(*argument.value)),
                      fmt::format("write `{} true` or `{} false`", argument.id, argument.id));
  }
  return argument.value->boolean();
}

Vec3 read_point(const Argument& argument) {
  const Value& v = *argument.value;
  if (!v.is(Type::vector) || v.dimension() != 3) {
    std::string help;
    if (v.is(Type::number)) {
      const std::string n = lancer::to_text(v.number());
      help = fmt::format("a number is no point; for three equal components write <{}, {}, {}>", n, n, n);
    }
    refuse_type(argument, "a point <x, y, z>", std::move(help));
  }
  return v.vec3();
}

Vec3 read_direction(const Argument& argument) {
  const Vec3 v = read_point(argument);
  if (v == Vec3{}) {
    throw ScriptError(Code::degenerate, argument.span, subject(argument) + " is not zero",
                      "write where it points, such as <0, 1, 0> or y");
  }
  return v;
}

Color read_color(const Argument& argument) {
  const Value& v = *argument.value;
  if (v.is(Type::number)) return grey(v.number());
  if (v.is(Type::vector) && v.dimension() == 3) return {v.component(0), v.component(1), v.component(2)};
  refuse_type(argument, "a colour", "a colour is rgb(1, 0.5, 0), #ff8000, orange, or 0.8 for a grey");
}

}  // namespace lancer::lang
