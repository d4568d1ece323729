// Functions that work component by component: on numbers, and on the numbers in vectors, over which single
// numbers spread.

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "base/math.hpp"
#include "base/number.hpp"
#include "lang/builtins_arguments.hpp"
#include "lang/builtins_groups.hpp"

namespace lancer::lang {
namespace {

double component(const Value& v, int i) { return v.is(Type::number) ? v.number() : v.component(i); }

[[noreturn]] void refuse_component(const Arguments& a, std::size_t i) {
  std::string help;
  if (a[i].is_list_like() && (a.id() == "min" || a.id() == "max")) {
    help = fmt::format("the elements of a list are compared by `fold(list, list[0], {})`", a.id());
  } else if (a[i].is_list_like()) {
    help = "the elements of a list are worked on by `map(list, f)`";
  }
  a.wrong_type(i, "a number or a vector", std::move(help));
}

/// The number of components of the result: 2 or 3, or 1 where all are numbers.
int common_dimension(const Arguments& a) {
  int dimension = 1;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].is(Type::number)) continue;
    if (!a[i].is(Type::vector)) refuse_component(a, i);
    const int found = a[i].dimension();
    if (dimension != 1 && found != dimension) {
      a.refuse(Code::wrong_type, i,
               fmt::format("the vectors of `{}` are of the same length; this one has {} numbers, another {}",
                           a.id(), found, dimension));
    }
    dimension = found;
  }
  return dimension;
}

/// f(i) for each component of the result.
template <class F>
Value each_component(const Arguments& a, F f) {
  switch (common_dimension(a)) {
    case 1: return f(0);
    case 2: return Value(f(0), f(1));
    default: return Vec3{f(0), f(1), f(2)};
  }
}

template <double (*F)(double)>
Value of_one(const Arguments& a) {
  return each_component(a, [&](int i) { return F(component(a[0], i)); });
}

template <double (*F)(double, double)>
Value of_two(const Arguments& a) {
  return each_component(a, [&](int i) { return F(component(a[0], i), component(a[1], i)); });
}

template <double (*F)(double, double, double)>
Value of_three(const Arguments& a) {
  return each_component(a,
                        [&](int i) { return F(component(a[0], i), component(a[1], i), component(a[2], i)); });
}

/// Of one or more, from the first on.
template <double (*F)(double, double)>
Value of_many(const Arguments& a) {
  return each_component(a, [&](int i) {
    double result = component(a[0], i);
    for (std::size_t k = 1; k < a.size(); ++k) result = F(result, component(a[k], i));
    return result;
  });
}

double magnitude(double v) { return std::fabs(v); }
double sign(double v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }
double floor_of(double v) { return std::floor(v); }
double ceil_of(double v) { return std::ceil(v); }
double round_of(double v) { return std::round(v); }
double trunc_of(double v) { return std::trunc(v); }
/// In [0, 1), also where v is just below a whole number.
double fract(double v) { return std::min(v - std::floor(v), 0x1.fffffffffffffp-1); }
double sqrt_of(double v) { return std::sqrt(v); }

double smaller(double a, double b) { return b < a ? b : a; }
double larger(double a, double b) { return a < b ? b : a; }
double clamp(double v, double lo, double hi) { return smaller(larger(v, lo), hi); }
/// Exactly a at t = 0 and b at t = 1.
double mix(double a, double b, double t) { return a * (1 - t) + b * t; }
double step(double edge, double v) { return v < edge ? 0 : 1; }

Value smoothstep(const Arguments& a) {
  return each_component(a, [&](int i) {
    const double e0 = component(a[0], i);
    const double e1 = component(a[1], i);
    if (e0 == e1) {
      a.refuse(Code::bad_argument, 1,
               fmt::format("the edges of `smoothstep` differ; both are {}", to_text(e0)),
               "a sharp edge is `step(edge, v)`");
    }
    const double t = clamp((component(a[2], i) - e0) / (e1 - e0), 0, 1);
    return t * t * (3 - 2 * t);
  });
}

constexpr std::array k_table{
    BuiltinInfo{"abs", "abs(v)", "the size without the sign", 1, 1, of_one<magnitude>},
    BuiltinInfo{"sign", "sign(v)", "-1, 0 or 1", 1, 1, of_one<sign>},
    BuiltinInfo{"floor", "floor(v)", "the whole number at or below", 1, 1, of_one<floor_of>},
    BuiltinInfo{"ceil", "ceil(v)", "the whole number at or above", 1, 1, of_one<ceil_of>},
    BuiltinInfo{"round", "round(v)", "the nearest whole number, halves away from 0", 1, 1, of_one<round_of>},
    BuiltinInfo{"trunc", "trunc(v)", "the whole number towards 0", 1, 1, of_one<trunc_of>},
    BuiltinInfo{"fract", "fract(v)", "v - floor(v)", 1, 1, of_one<fract>},
    BuiltinInfo{"sqrt", "sqrt(v)", "the square root", 1, 1, of_one<sqrt_of>},
    BuiltinInfo{"cbrt", "cbrt(v)", "the cube root", 1, 1, of_one<math::cbrt>},
    BuiltinInfo{"exp", "exp(v)", "e to the power v", 1, 1, of_one<math::exp>},
    BuiltinInfo{"log", "log(v)", "the natural logarithm", 1, 1, of_one<math::log>},
    BuiltinInfo{"log2", "log2(v)", "the logarithm to base 2", 1, 1, of_one<math::log2>},
    BuiltinInfo{"log10", "log10(v)", "the logarithm to base 10", 1, 1, of_one<math::log10>},
    BuiltinInfo{"sin", "sin(degrees)", "the sine", 1, 1, of_one<math::sin_deg>},
    BuiltinInfo{"cos", "cos(degrees)", "the cosine", 1, 1, of_one<math::cos_deg>},
    BuiltinInfo{"tan", "tan(degrees)", "the tangent", 1, 1, of_one<math::tan_deg>},
    BuiltinInfo{"asin", "asin(v)", "the angle of a sine, -90 to 90", 1, 1, of_one<math::asin_deg>},
    BuiltinInfo{"acos", "acos(v)", "the angle of a cosine, 0 to 180", 1, 1, of_one<math::acos_deg>},
    BuiltinInfo{"atan", "atan(v)", "the angle of a tangent, -90 to 90", 1, 1, of_one<math::atan_deg>},
    BuiltinInfo{"atan2", "atan2(y, x)", "the angle of the point (x, y), -180 to 180", 2, 2,
                of_two<math::atan2_deg>},
    BuiltinInfo{"radians", "radians(degrees)", "an angle in radians", 1, 1, of_one<math::radians>},
    BuiltinInfo{"degrees", "degrees(radians)", "an angle in degrees", 1, 1, of_one<math::degrees>},
    BuiltinInfo{"mod", "mod(a, b)", "the rest of a / b, of the sign of b", 2, 2, of_two<modulo>},
    BuiltinInfo{"min", "min(a, ...)", "the smallest", 1, k_any_count, of_many<smaller>},
    BuiltinInfo{"max", "max(a, ...)", "the largest", 1, k_any_count, of_many<larger>},
    BuiltinInfo{"clamp", "clamp(v, lo, hi)", "v, but no less than lo and no more than hi", 3, 3,
                of_three<clamp>},
    BuiltinInfo{"mix", "mix(a, b, t)", "a at t = 0, b at t = 1, in a straight line", 3, 3, of_three<mix>},
    BuiltinInfo{"step", "step(edge, v)", "0 where v < edge, else 1", 2, 2, of_two<step>},
    BuiltinInfo{"smoothstep", "smoothstep(e0, e1, v)", "0 up to e0, 1 from e1 on, smooth between", 3, 3,
                smoothstep},
};

}  // namespace

std::span<const BuiltinInfo> component_builtins() { return k_table; }

}  // namespace lancer::lang
