// What the built-in functions and constants give.

#include "lang/builtins.hpp"

#include <algorithm>
#include <set>

#include "catch.hpp"
#include "lang/run_script.hpp"

namespace lancer::lang {
namespace {

/// What `print(<expressions>)` shows, without its newline.
std::string shown(const std::string& expressions) {
  std::string line = printed("print(" + expressions + ")");
  line.pop_back();
  return line;
}

/// The components of a vector, or one number.
std::vector<double> numbers(const std::string& expression) {
  std::vector<double> out;
  std::string text = shown(expression);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '<' || c == '>' || c == ','; }, ' ');
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == ' ') {
      ++at;
      continue;
    }
    std::size_t used = 0;
    out.push_back(std::stod(text.substr(at), &used));
    at += used;
  }
  return out;
}

void check_near(const std::string& expression, const std::vector<double>& expected) {
  const std::vector<double> found = numbers(expression);
  CAPTURE(expression);
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == Approx(expected[i]).margin(1e-12));
}

}  // namespace

TEST_CASE("builtins: rounding", "[builtins]") {
  CHECK(shown("abs(-2.5), abs(3), sign(-7), sign(0), sign(0.1)") == "2.5 3 -1 0 1");
  CHECK(shown("floor(2.7), floor(-2.1), ceil(2.1), ceil(-2.7)") == "2 -3 3 -2");
  CHECK(shown("round(2.5), round(-2.5), round(2.4), trunc(2.7), trunc(-2.7)") == "3 -3 2 2 -2");
  CHECK(shown("fract(2.75), fract(-0.25), fract(-1e-20) < 1") == "0.75 0.75 true");
}

TEST_CASE("builtins: roots, exponentials and logarithms", "[builtins]") {
  CHECK(shown("sqrt(2.25), cbrt(-27), exp(0), log(1), log2(1024), log10(1000)") == "1.5 -3 1 0 10 3");
  CHECK(shown("exp(1), log(10)") == "2.718281828459045 2.302585092994046");
}

TEST_CASE("builtins: angles are degrees", "[builtins]") {
  CHECK(shown("sin(30), cos(60), tan(45), sin(180), cos(90)") == "0.5 0.5 1 0 0");
  CHECK(shown("asin(0.5), acos(0), atan(1), atan2(1, -1), atan2(0, -1)") == "30 90 45 135 180");
  CHECK(shown("radians(180) == pi, degrees(pi), radians(360) == tau") == "true 180 true");
}

TEST_CASE("builtins: component by component", "[builtins]") {
  CHECK(shown("abs(<-1, 2, -3>), sqrt(<4, 9>), sin(<0, 30, 90>)") == "<1, 2, 3> <2, 3> <0, 0.5, 1>");
  CHECK(shown("mod(<7, -7, 5>, 3), mod(7, <4, -4>)") == "<1, 2, 2> <3, -1>");
  CHECK(shown("atan2(<0, 1>, <1, 0>)") == "<0, 90>");
  CHECK(shown("mix(<0, 1, 2>, <10, 11, 12>, 0.5)") == "<5, 6, 7>");
  CHECK(shown("clamp(<-1, 0.5, 2>, 0, 1)") == "<0, 0.5, 1>");
  CHECK(shown("max(<1, 5, 3>, 2, <0, 0, 9>)") == "<2, 5, 9>");
}

TEST_CASE("builtins: mod has the sign of its second argument", "[builtins]") {
  CHECK(shown("mod(7, 3), mod(-7, 3), mod(7, -3), mod(-7, -3)") == "1 2 -2 -1");
  CHECK(shown("mod(5.5, 2), mod(-0.5, 2), mod(6, 3), mod(-6, 3)") == "1.5 1.5 0 0");
  CHECK(shown("-7 % 3 == mod(-7, 3)") == "true");
}

TEST_CASE("builtins: smallest, largest and between", "[builtins]") {
  CHECK(shown("min(3), min(3, 1, 2), max(3, 1, 2), max(-1)") == "3 1 3 -1");
  CHECK(shown("min(<1, 2>), max(1, <0, 2>)") == "<1, 2> <1, 2>");
  CHECK(shown("clamp(5, 0, 3), clamp(-5, 0, 3), clamp(2, 0, 3)") == "3 0 2");
}

TEST_CASE("builtins: from one value to another", "[builtins]") {
  CHECK(shown("mix(2, 4, 0), mix(2, 4, 1), mix(2, 4, 0.25), mix(0.1, 0.3, 1)") == "2 4 2.5 0.3");
  CHECK(shown("step(2, 1), step(2, 2), step(2, 3)") == "0 1 1");
  // t = 0.25: 3/16 - 2/64 = 10/64
  CHECK(shown("smoothstep(0, 4, 1), smoothstep(0, 4, -1), smoothstep(0, 4, 9), smoothstep(0, 4, 2)") ==
        "0.15625 0 1 0.5");
  CHECK(shown("smoothstep(4, 0, 1)") == "0.84375");  // falling: 1 - 0.15625
}

TEST_CASE("builtins: vectors", "[builtins]") {
  CHECK(shown("dot(<1, 2, 3>, <4, -5, 6>), dot(<1, 2>, <3, 4>)") == "12 11");
  CHECK(shown("cross(x, y), cross(<1, 2, 3>, <4, 5, 6>)") == "<0, 0, 1> <-3, 6, -3>");
  CHECK(shown("length(<2, 3, 6>), length(<3, 4>), length(<0, 0, 0>)") == "7 5 0");
  CHECK(shown("normalize(<0, -5, 0>), normalize(<3, 4>)") == "<0, -1, 0> <0.6, 0.8>");
  CHECK(shown("distance(<1, 2, 3>, <3, 5, 9>), distance(<0, 3>, <4, 0>)") == "7 5");
  CHECK(shown("hypot(3, 4), hypot(2, 3, 6), hypot(3 * 2 ^ 700, 4 * 2 ^ 700) == 5 * 2 ^ 700") == "5 7 true");
}

TEST_CASE("builtins: mirrors and turns", "[builtins]") {
  CHECK(shown("reflect(<1, -1, 0>, y), reflect(<1, -1, 0>, <0, -7, 0>)") == "<1, 1, 0> <1, 1, 0>");
  CHECK(shown("reflect(<1, 0>, <1, 1>)") == "<0, -1>");  // at the line y = -x
  CHECK(shown("reflect(x, <1e-300, 1e-300, 0>)") == "<0, -1, 0>");
  CHECK(shown("rotate_about(x, z, 90), rotate_about(y, <5, 0, 0>, 90)") == "<0, 1, 0> <0, 0, 1>");
  check_near("rotate_about(x, <1, 1, 1>, 120)", {0, 1, 0});
}

TEST_CASE("builtins: colours in linear light", "[builtins]") {
  CHECK(shown("rgb(0.1, 0.2, 3), rgb(0.5), rgb(-1, 0, 0)") == "<0.1, 0.2, 3> <0.5, 0.5, 0.5> <-1, 0, 0>");
  CHECK(shown("luminance(rgb(1, 0, 0)), luminance(green.g * y), luminance(0.25)") ==
        "0.2126 " + shown("0.7152 * green.g") + " 0.25");
}

TEST_CASE("builtins: colours of screens are decoded", "[builtins]") {
  CHECK(shown("srgb(0, 1, 0)") == "<0, 1, 0>");
  CHECK(shown("srgb(51 / 255, 102 / 255, 153 / 255) == #336699, #369 == #336699") == "true true");
  // ((0.5 + 0.055) / 1.055)^2.4 = 0.214041140...
  check_near("srgb(0.5, 0, 0)", {0.21404114048223255, 0, 0});
}

TEST_CASE("builtins: hue, saturation and value", "[builtins]") {
  CHECK(shown("hsv(0, 1, 1) == red, hsv(60, 1, 1) == yellow, hsv(120, 1, 1) == lime") == "true true true");
  CHECK(shown("hsv(180, 1, 1) == cyan, hsv(240, 1, 1) == blue, hsv(300, 1, 1) == magenta") ==
        "true true true");
  CHECK(shown("hsv(-60, 1, 1) == magenta, hsv(720, 1, 1) == red, hsv(77, 0, 1) == white") ==
        "true true true");
  // hue 30 lies halfway from red to yellow: <1, 0.5, 0>, at saturation 0.5 <1, 0.75, 0.5>, at value 0.5 half
  // of that.
  CHECK(shown("hsv(30, 0.5, 0.5) == srgb(0.5, 0.375, 0.25)") == "true");
}

TEST_CASE("builtins: the colour of glowing bodies", "[builtins]") {
  // CIE 15: the chromaticity of Planck radiation at 2856 K (illuminant A) is x = 0.4476, y = 0.4074; with
  // XYZ = (x, y, 1 - x - y) the matrix of Rec. 709 gives <0.7520, 0.3373, 0.0952>, over the largest
  // <1, 0.449, 0.127>.
  const std::vector<double> a = numbers("kelvin(2856)");
  CHECK(a[0] == 1);
  CHECK(a[1] == Approx(0.449).margin(0.003));
  CHECK(a[2] == Approx(0.127).margin(0.003));
  // At 6504 K it is x = 0.3134, y = 0.3235: <0.3373, 0.3182, 0.3353>, over the largest <1, 0.943, 0.994>.
  const std::vector<double> day = numbers("kelvin(6504)");
  CHECK(day[0] == 1);
  CHECK(day[1] == Approx(0.943).margin(0.003));
  CHECK(day[2] == Approx(0.994).margin(0.003));
  const std::vector<double> sky = numbers("kelvin(20000)");
  CHECK(sky[2] == 1);
  CHECK(sky[0] < 0.5);
  CHECK(shown("kelvin(1000).b, kelvin(0.001) == kelvin(100), kelvin(1e300) == kelvin(1e13)") ==
        "0 true true");
}

TEST_CASE("builtins: chance is the same everywhere and always", "[builtins]") {
  // Worked out by another program from the definition: splitmix64's finish, twice for each number.
  CHECK(shown("rand(0), rand(1), rand(1, 2), rand(1, 2, 3), rand(0.1)") ==
        "0.8833108082136426 0.4015157824975293 0.04788704085562201 0.16678382771628164 0.17070653871231734");
  CHECK(shown("rand(-0) == rand(0), rand(0 * -1) == rand(0), rand(2, 1) == rand(1, 2)") == "true true false");
  CHECK(shown("rand(<1, 2, 3>) == rand(1, 2, 3), rand(<1, 2>) == rand(<2, 1>)") == "true false");
}

TEST_CASE("builtins: chance is even", "[builtins]") {
  // 10,000 values in 10 cells: 1000 each, standard deviation 30; also of neighbours, in 100 cells: 100
  // each, 10.
  CHECK(
      printed("let cells = map(0..10, fn (i) -> len(filter(0..10000, fn (k) -> floor(rand(k) * 10) == i)))\n"
              "print(min(cells[0], cells[1], cells[2], cells[3], cells[4]) > 880,"
              " max(cells[5], cells[6], cells[7], cells[8], cells[9]) < 1120,"
              " fold(cells, 0, fn (a, b) -> a + b))") == "true true 10000\n");
  CHECK(shown("abs(fold(0..10000, 0, fn (s, k) -> s + (rand(k) - 0.5) * (rand(k + 1) - 0.5))) < 34") ==
        "true");  // 4 sigma
}

TEST_CASE("builtins: lengths", "[builtins]") {
  CHECK(shown("len([]), len([1, [2, 3]]), len(3..7), len(3..=7), len(7..3)") == "0 2 4 5 0");
  CHECK(shown("len(\"\"), len(\"abc\"), len(\"\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80\"), len(<1, 2>)") ==
        "0 3 3 2");
  CHECK(printed("print(len(group { sphere { <0, 0, 0>, 1 } sphere { <0, 0, 0>, 2 } }))") == "2\n");
}

TEST_CASE("builtins: new lists of old ones", "[builtins]") {
  CHECK(printed("let a = [1]  let b = push(a, [2])  print(a, b, push(0..2, \"x\"))") ==
        "[1] [1, [2]] [0, 1, \"x\"]\n");
  CHECK(shown("concat([1]), concat([1], 2..4, [], [[5]])") == "[1] [1, 2, 3, [5]]");
  CHECK(shown("reverse([1, 2, 3]), reverse(0..3), reverse([])") == "[3, 2, 1] [2, 1, 0] []");
  CHECK(shown("zip([1, 2, 3], [\"a\", \"b\"]), zip(0..2, 5..9)") ==
        "[[1, \"a\"], [2, \"b\"]] [[0, 5], [1, 6]]");
}

TEST_CASE("builtins: functions over lists", "[builtins]") {
  CHECK(shown("map([1, 2, 3], fn (v) -> v * v), map(0..3, sqrt), map([], sin)") ==
        "[1, 4, 9] [0, 1, 1.4142135623730951] []");
  CHECK(shown("filter(0..=10, fn (v) -> v % 3 == 0), filter([], fn (v) -> true)") == "[0, 3, 6, 9] []");
  CHECK(shown("fold([1, 2, 3], 10, fn (a, v) -> a - v), fold([], 7, max), fold([3, 9, 4], 0, max)") ==
        "4 7 9");
  CHECK(shown("fold([\"a\", \"b\"], \"\", fn (a, v) -> \"{v}{a}\")") == "ba");
  CHECK(printed("fn ball(i) = sphere { <i, 0, 0>, 1 }  let all = map(0..3, ball)  print(len(all), "
                "type_of(all[0]))") == "3 sphere\n");
}

TEST_CASE("builtins: sorting", "[builtins]") {
  CHECK(shown("sort([3, 1, 2]), sort([]), sort([5]), sort(0..3)") == "[1, 2, 3] [] [5] [0, 1, 2]");
  CHECK(shown("sort([\"b\", \"a\", \"B\", \"\xC3\xA4\", \"ab\", \"\"])") ==
        "[\"\", \"B\", \"a\", \"ab\", \"b\", \"\xC3\xA4\"]");
  CHECK(shown("sort([3, 1, 2], fn (a, b) -> a > b)") == "[3, 2, 1]");
  // Equal keys stay in their order.
  CHECK(
      shown("sort([[1, \"a\"], [0, \"b\"], [1, \"c\"], [0, \"d\"], [1, \"e\"]], fn (p, q) -> p[0] < q[0])") ==
      "[[0, \"b\"], [0, \"d\"], [1, \"a\"], [1, \"c\"], [1, \"e\"]]");
  CHECK(printed("let s = sort(map(0..1000, rand))  print(len(filter(0..999, fn (i) -> s[i] > s[i + 1])))") ==
        "0\n");
}

TEST_CASE("builtins: sorting survives an order that contradicts itself", "[builtins]") {
  CHECK(shown("len(sort(0..1000, fn (a, b) -> true))") == "1000");
  CHECK(shown("len(sort(0..1000, fn (a, b) -> rand(a, b) < 0.5))") == "1000");
}

TEST_CASE("builtins: lists of numbers", "[builtins]") {
  CHECK(shown("range(4), range(0), range(-2), range(2.5)") == "[0, 1, 2, 3] [] [] [0, 1, 2]");
  CHECK(shown("range(2, 5), range(5, 2), range(0.5, 3)") == "[2, 3, 4] [] [0.5, 1.5, 2.5]");
  CHECK(shown("range(0, 1, 0.25), range(3, 0, -1), range(0, 10, -1)") == "[0, 0.25, 0.5, 0.75] [3, 2, 1] []");
  // The end is never among them, whichever way the step was rounded.
  CHECK(shown("len(range(0, 1, 0.1)), len(range(0, 1.1, 0.1)), len(range(0, 0.3, 0.1)), len(range(0, 0.6, "
              "0.2))") == "10 11 3 3");
}

TEST_CASE("builtins: values as text", "[builtins]") {
  CHECK(shown("str(1.5), str(true), str(\"a\"), str(<1, 2>), str(-0)") == "1.5 true a <1, 2> 0");
  CHECK(shown("[1, \"a\", [true, 0..3]], 0..=3, <0.1, -0, 1e21>") ==
        "[1, \"a\", [true, 0..3]] 0..=3 <0.1, 0, 1e+21>");
  CHECK(shown("[\"a \\\"b\\\" \\\\ \\n \\t \\{c}\"]") == "[\"a \\\"b\\\" \\\\ \\n \\t \\{c}\"]");
  CHECK(shown("sin, fn (v) -> v, checker(0, 1), material { }") == "function function pattern material");
  CHECK(printed("let s = sphere \"a {1}\" { <0, 0, 0>, 1 }  print(s, [s], box { <0, 0, 0>, <1, 1, 1> })") ==
        "sphere \"a 1\" [sphere \"a 1\"] box\n");
  CHECK(shown("\"{[1, 2]} and {\"in\"}ner\"") == "[1, 2] and inner");
}

TEST_CASE("builtins: strings apart and together", "[builtins]") {
  CHECK(shown("join([1, \"a\", <1, 2>], \"; \"), join([], \",\"), join(0..3, \"\")") == "1; a; <1, 2>  012");
  CHECK(shown("split(\"a,b,,c\", \",\"), split(\"\", \",\"), split(\"abc\", \"--\")") ==
        "[\"a\", \"b\", \"\", \"c\"] [\"\"] [\"abc\"]");
  CHECK(shown("split(\"a--b--\", \"--\"), split(\"a\xC3\xA9z\", \"\"), split(\"\", \"\")") ==
        "[\"a\", \"b\", \"\"] [\"a\", \"\xC3\xA9\", \"z\"] []");
  CHECK(shown("format(3.14159, 2), format(2, 0), format(-0.001, 1), format(<1, 2.5, 1 / 3>, 2)") ==
        "3.14 2 0.0 <1.00, 2.50, 0.33>");
}

TEST_CASE("builtins: print, assert and type_of", "[builtins]") {
  CHECK(printed("print()  print(1, \"two\", [3])  print(\"\")") == "\n1 two [3]\n\n");
  CHECK(printed("assert(true)  assert(1 < 2, \"never\")") == "");
  CHECK(
      shown(
          "type_of(1), type_of(true), type_of(\"\"), type_of(x), type_of([]), type_of(0..1), type_of(sin)") ==
      "number boolean string vector list range function");
  CHECK(shown("type_of(checker(0, 1)), type_of(material { }), type_of(sphere { <0, 0, 0>, 1 }), "
              "type_of(group { })") == "pattern material sphere group");
  CHECK(shown("type_of(view { eye <0, 0, 5> look -z }), type_of(light { at <0, 1, 0> })") == "view light");
}

TEST_CASE("builtins: patterns", "[builtins]") {
  const auto pattern = [](const std::string& expression) {
    const Ran ran = run("sphere { <0, 0, 0>, 1  material { diffuse " + expression + " } }");
    CAPTURE(ran.found);
    REQUIRE(ran.objects.size() == 1);
    return ran.objects[0]->material->diffuse.pattern->pattern;
  };
  using Kind = scene::Pattern::Kind;
  const scene::Pattern checker = pattern("checker(white, 0.25)");
  CHECK(checker.kind == Kind::checker);
  CHECK(checker.a == grey(1));
  CHECK(checker.b == grey(0.25));
  CHECK(checker.size == 1);
  CHECK(pattern("checker(0, 1, 0.5)").size == 0.5);
  const scene::Pattern stripes = pattern("stripes(<1, 0, 0>, 0, <0, 2, 0>)");
  CHECK(stripes.kind == Kind::stripes);
  CHECK(stripes.a == Color{1, 0, 0});
  CHECK(stripes.axis == Vec3{0, 2, 0});
  CHECK(stripes.size == 1);
  CHECK(pattern("stripes(0, 1, x, 3)").size == 3);
  const scene::Pattern gradient = pattern("gradient(0, 1, <1, 2, 3>, <4, 5, 6>)");
  CHECK(gradient.kind == Kind::gradient);
  CHECK(gradient.from == Vec3{1, 2, 3});
  CHECK(gradient.to == Vec3{4, 5, 6});
}

TEST_CASE("builtins: constants", "[builtins]") {
  CHECK(shown("x, y, z, pi, tau") == "<1, 0, 0> <0, 1, 0> <0, 0, 1> 3.141592653589793 6.283185307179586");
  CHECK(shown("red == #f00, rebeccapurple == #663399, white, black, lime") ==
        "true true <1, 1, 1> <0, 0, 0> <0, 1, 0>");
  CHECK(shown("gray == grey, darkslategray == darkslategrey, gray == #808080, aqua == cyan, fuchsia == "
              "magenta") == "true true true true true");
  CHECK(shown("steelblue == #4682b4, lightgoldenrodyellow == #fafad2, papayawhip == #ffefd5") ==
        "true true true");
  CHECK(all_constants().size() == 5 + 148);
}

TEST_CASE("builtins: the tables are in order", "[builtins]") {
  std::set<std::string_view> ids;
  std::uint32_t slot = 0;
  for (const BuiltinInfo& info : all_builtins()) {
    CAPTURE(info.id);
    CHECK(ids.insert(info.id).second);
    CHECK(info.signature.starts_with(std::string(info.id) + "("));
    CHECK_FALSE(info.summary.empty());
    CHECK(info.min_arguments <= info.max_arguments);
    CHECK(find_builtin(info.id) == slot++);
  }
  CHECK(ids.size() == 65);
  ids.clear();
  slot = 0;
  for (const ConstantInfo& info : all_constants()) {
    CAPTURE(info.id);
    CHECK(ids.insert(info.id).second);
    CHECK(find_constant(info.id) == slot++);
  }
  CHECK_FALSE(find_builtin("nope"));
  CHECK_FALSE(find_constant("Red"));
}

TEST_CASE("builtins: equality is by content", "[builtins]") {
  CHECK(shown("1 == <1, 1, 1>, 0..3 == [0, 1, 2], \"1\" == 1, true == 1") == "false false false false");
  CHECK(shown("[1, [2, \"a\"]] == [1, [2, \"a\"]], [1] == [1, 2], <1, 2> == <1, 2, 0>, 0 == -0") ==
        "true false false true");
  CHECK(shown("0..3 == 0..=2, 0..3 == 1..3, 5..0 == 3..1, 0..3 == 0..3") == "true false true true");
  CHECK(printed("let f = fn (v) -> v  let g = fn (v) -> v  let p = checker(0, 1)\n"
                "print(f == f, f == g, sin == sin, sin == cos, p == p, p == checker(0, 1))") ==
        "true false true false true false\n");
  CHECK(shown("material { } == material { diffuse 0.8 }, material { } == material { diffuse 0.7 }") ==
        "true false");
}

TEST_CASE("builtins: equality of objects is by content", "[builtins]") {
  const std::string s = "sphere { <0, 1, 0>, 2 }";
  CHECK(shown(s + " == sphere { center <0, 1, 0> radius 2 }") == "true");
  CHECK(shown(s + " == sphere { <0, 1, 0>, 3 }") == "false");
  CHECK(shown(s + " == sphere \"a\" { <0, 1, 0>, 2 }") == "false");
  CHECK(shown(s + " == sphere { <0, 1, 0>, 2 translate x }") == "false");
  CHECK(shown(s + " == sphere { <0, 1, 0>, 2 material { } }") == "false");
  CHECK(shown(s + " == sphere { <0, 1, 0>, 2 shadow false }") == "false");
  CHECK(shown("group { " + s + " } == group { " + s + " }, group { } == group { " + s + " }") ==
        "true false");
  CHECK(shown("light { at y } == light { at y color 1 }, light { at y } == light { at x }") == "true false");
  CHECK(shown("plane { y, 0 } == plane { y, 1 }, " + s + " == plane { y, 1 }") == "false false");
  CHECK(shown("view { eye z look -z } == view { eye z look -z }, view { eye z look -z } == view { eye z look "
              "-z fov 40 }") == "true false");
}

TEST_CASE("builtins: the order is that of numbers and of code points", "[builtins]") {
  CHECK(shown("1 < 2, 2 < 2, 2 <= 2, 3 > 2, -1 >= 0") == "true false true true false");
  CHECK(shown("\"a\" < \"b\", \"a\" < \"B\", \"a\" < \"ab\", \"\xF0\x9F\x98\x80\" > \"\xEF\xBF\xBD\"") ==
        "true false true true");
}

TEST_CASE("builtins: operators on vectors", "[builtins]") {
  CHECK(shown("<1, 2, 3> + 1, 2 * <1, 2>, <1, 2, 3> * <4, 5, 6>, 12 / <3, 4>, -<1, -2>, <7, -7> % 3") ==
        "<2, 3, 4> <2, 4> <4, 10, 18> <4, 3> <-1, 2> <1, 2>");
}

TEST_CASE("builtins: powers go component by component", "[builtins]") {
  CHECK(shown("<1, 2, 3> ^ 2, 2 ^ <1, 2>, <4, 9> ^ <0.5, 2>, 2 ^ -1") == "<1, 4, 9> <2, 4> <2, 81> 0.5");
}

TEST_CASE("builtins: steps are charged for what is produced", "[builtins]") {
  const auto steps = [](const std::string& text) { return run(text).steps; };
  const auto base = steps("let a = 0..1000 print(len(a))");
  const auto at_least = [&](const std::string& text, std::uint64_t least) {
    CAPTURE(text);
    CHECK(steps(text) >= base + least);
    CHECK(steps(text) <= base + 12 * least + 50);
  };
  at_least("let a = 0..1000 print(len(push(a, 1)))", 1000);
  at_least("let a = 0..1000 print(len(concat(a, a)))", 2000);
  at_least("let a = 0..1000 print(len(reverse(a)))", 1000);
  at_least("let a = 0..1000 print(len(map(a, sin)))", 2000);
  at_least("let a = 0..1000 print(len(zip(a, a)))", 1000);
  at_least("let a = 0..1000 print(len(range(1000)))", 1000);
  at_least("let a = 0..1000 print(len(sort(a)))", 1000);
  at_least("let a = 0..1000 print(len(join(a, \"\")))", 1000);
  at_least("let a = 0..1000 let b = range(1000) print(b == range(1000))", 3000);
  at_least("let a = 0..1000 print(str(range(1000)) == \"\")", 1000);
}

}  // namespace lancer::lang
