// Colours, and patterns of them.

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "base/math.hpp"
#include "base/number.hpp"
#include "lang/blackbody.hpp"
#include "lang/builtins_arguments.hpp"
#include "lang/builtins_groups.hpp"

namespace lancer::lang {
namespace {

Value rgb_of(const Arguments& a) {
  if (a.size() == 2) {
    throw ScriptError(Code::argument_count, a.context().span, "`rgb` takes 1 or 3 arguments; this call has 2",
                      "a colour is `rgb(r, g, b)`, a grey `rgb(grey)`");
  }
  if (a.size() == 1 && a[0].is(Type::vector)) {
    a.wrong_type(0, "a number", "a vector of 3 numbers is a colour already: <1, 0, 0> is rgb(1, 0, 0)");
  }
  return a.size() == 1 ? grey(a.number(0)) : Color{a.number(0), a.number(1), a.number(2)};
}

/// A number in [0, 1].
double share(const Arguments& a, std::size_t i, std::string_view what, std::string help = {}) {
  const double v = a.number(i);
  if (v >= 0 && v <= 1) return v;
  a.refuse(Code::out_of_range, i, fmt::format("{} lies between 0 and 1; this one is {}", what, to_text(v)),
           std::move(help));
}

Value srgb_of(const Arguments& a) {
  const auto decoded = [&](std::size_t i) {
    const bool bytes = a[i].is(Type::number) && a[i].number() > 1 && a[i].number() <= 255;
    return math::srgb_to_linear(
        share(a, i, "a component of `srgb`", bytes ? "bytes are written as #ff8800" : ""));
  };
  return Color{decoded(0), decoded(1), decoded(2)};
}

/// A. R. Smith, "Color gamut transform pairs" (1978), in one formula for the three channels.
Value hsv_of(const Arguments& a) {
  const double hue = modulo(a.number(0), 360) / 60;
  const double saturation = share(a, 1, "a saturation");
  const double value = share(a, 2, "a value of `hsv`");
  const auto channel = [&](double shift) {
    const double k = modulo(shift + hue, 6);
    const double level = value - value * saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
    return math::srgb_to_linear(level);
  };
  return Color{channel(5), channel(3), channel(1)};
}

Value kelvin_of(const Arguments& a) { return blackbody(a.positive(0, "a temperature")); }

Value luminance_of(const Arguments& a) {
  const Color c = a.color(0);
  return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

Value pattern_value(const scene::Pattern& pattern) {
  Ref<PatternData> data(new PatternData);
  data->pattern = pattern;
  return Value(std::move(data));
}

Value checker_of(const Arguments& a) {
  scene::Pattern p;
  p.kind = scene::Pattern::Kind::checker;
  p.a = a.color(0);
  p.b = a.color(1);
  if (a.size() == 3) p.size = a.positive(2, "the size of a checker's cells");
  return pattern_value(p);
}

Value stripes_of(const Arguments& a) {
  scene::Pattern p;
  p.kind = scene::Pattern::Kind::stripes;
  p.a = a.color(0);
  p.b = a.color(1);
  p.axis = a.direction(2, "the axis of stripes");
  if (a.size() == 4) p.size = a.positive(3, "the width of stripes");
  return pattern_value(p);
}

Value gradient_of(const Arguments& a) {
  scene::Pattern p;
  p.kind = scene::Pattern::Kind::gradient;
  p.a = a.color(0);
  p.b = a.color(1);
  p.from = a.vec3(2);
  p.to = a.vec3(3);
  if (p.from == p.to) {
    a.refuse(
        Code::degenerate, 3,
        fmt::format("the two points of a gradient differ; both are {}", display(a[3], a.meter(), a.span(3))));
  }
  return pattern_value(p);
}

constexpr std::array k_table{
    BuiltinInfo{"rgb", "rgb(r, g, b)", "a colour in linear light; `rgb(grey)` for a grey", 1, 3, rgb_of},
    BuiltinInfo{"srgb", "srgb(r, g, b)", "a colour of 0..1 as screens count it, decoded to linear light", 3,
                3, srgb_of},
    BuiltinInfo{"hsv", "hsv(degrees, s, v)", "a colour by hue, saturation and value, decoded to linear light",
                3, 3, hsv_of},
    BuiltinInfo{"kelvin", "kelvin(t)", "the colour of a glowing body, its largest component 1", 1, 1,
                kelvin_of},
    BuiltinInfo{"luminance", "luminance(c)", "0.2126 r + 0.7152 g + 0.0722 b", 1, 1, luminance_of},
    BuiltinInfo{"checker", "checker(a, b, size = 1)", "a pattern of cubes in two colours", 2, 3, checker_of},
    BuiltinInfo{"stripes", "stripes(a, b, axis, width = 1)", "a pattern of layers in two colours", 3, 4,
                stripes_of},
    BuiltinInfo{"gradient", "gradient(a, b, from, to)", "a pattern from one colour to another", 4, 4,
                gradient_of},
};

}  // namespace

std::span<const BuiltinInfo> color_builtins() { return k_table; }

}  // namespace lancer::lang
