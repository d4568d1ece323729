// The settings of a scene.

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "base/number.hpp"
#include "lang/build_parts.hpp"
#include "lang/keywords.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

using ast::Kind;

Color read_light(const Argument& argument) {
  const Color c = read_color(argument);
  if (has_negative(c)) refuse(Code::negative, argument, "is not negative", to_text(c));
  return c;
}

/// The place of a string among the words that are allowed.
std::size_t read_word(const Argument& argument, const std::vector<std::string_view>& words) {
  const auto refuse_word = [&](std::string_view found, std::string help) {
    const std::string all = fmt::format("\"{}\"", fmt::join(words.begin(), words.end() - 1, "\", \""));
    throw ScriptError(argument.value->is(Type::string) ? Code::out_of_range : Code::wrong_type, argument.span,
                      fmt::format("`{}` is {} or \"{}\"; this is {}", argument.id, all, words.back(), found),
                      std::move(help));
  };
  if (!argument.value->is(Type::string)) refuse_word(found_text(*argument.value), {});
  const std::string& text = argument.value->text();
  const auto found = std::find(words.begin(), words.end(), text);
  if (found == words.end()) {
    const std::string_view near = nearest(text, words);
    refuse_word(fmt::format("\"{}\"", text),
                near.empty() ? std::string() : fmt::format("did you mean \"{}\"?", near));
  }
  return static_cast<std::size_t>(found - words.begin());
}

int read_depth(const Argument& argument) {
  const double v = read_number(argument);
  if (v < 0 || v != std::trunc(v)) {
    refuse(Code::out_of_range, argument, "is whole and not negative", lancer::to_text(v));
  }
  // No ray is followed that far.
  return static_cast<int>(std::min<double>(v, std::numeric_limits<int>::max()));
}

void apply(const Argument& argument, scene::Settings& settings) {
  if (argument.id == "background") settings.background = read_light(argument);
  if (argument.id == "ambient") settings.ambient = read_light(argument);
  if (argument.id == "depth") settings.depth = read_depth(argument);
  if (argument.id == "ior") settings.ior = read_positive(argument);
  if (argument.id == "exposure") settings.exposure = read_positive(argument);
  if (argument.id == "sum")
    settings.sum = std::array{scene::Sum::linear, scene::Sum::log}[read_word(argument, {"linear", "log"})];
  if (argument.id == "shadows") {
    constexpr std::array k_shadows{scene::Shadows::filtered, scene::Shadows::opaque, scene::Shadows::off};
    settings.shadows = k_shadows[read_word(argument, {"filtered", "opaque", "off"})];
  }
}

}  // namespace

void apply_settings(const std::vector<AttributeValues>& attributes, scene::Settings& settings,
                    std::vector<std::string_view>& seen, std::vector<Diagnostic>& warnings) {
  for (const AttributeValues& a : attributes) {
    const AttributeInfo* info = find_attribute(Kind::settings, a.attribute->id);
    if (info == nullptr) continue;
    if (std::find(seen.begin(), seen.end(), info->id) != seen.end()) {
      warnings.push_back(warning(Code::settings_again, a.attribute->span,
                                 fmt::format("`{}` was set before; this one counts", info->id)));
    } else {
      seen.push_back(info->id);
    }
    apply(Slot{Kind::settings, info->id, a.values, a.attribute->values}.one(), settings);
  }
}

}  // namespace lancer::lang
