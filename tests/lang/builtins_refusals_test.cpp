// What the built-in functions and operators refuse: place, code and message.

#include "catch.hpp"
#include "lang/builtins.hpp"
#include "lang/run_script.hpp"

namespace lancer::lang {
namespace {

/// The failure of `let v = <expression> print(v)`, columns counted from the expression.
std::string refusal(const std::string& expression) {
  const Ran ran = run("let v =\n" + expression + "\nprint(v)");
  CAPTURE(expression, ran.found);
  REQUIRE(ran.found.size() == 1);
  return ran.found[0].substr(std::string("main.scn:2:").size());
}

std::string help_of(const std::string& expression) { return run("print(" + expression + ")").only().help; }

std::size_t marked(const std::string& expression) {
  const Span span = run("print(" + expression + ")").only().span;
  return span.end - span.begin;
}

}  // namespace

TEST_CASE("builtin refusals: a wrong count of arguments", "[builtins]") {
  CHECK(refusal("sqrt()") == "1 E032 `sqrt` takes 1 argument; this call has 0");
  CHECK(refusal("atan2(1)") == "1 E032 `atan2` takes 2 arguments; this call has 1");
  CHECK(refusal("hypot(1, 2, 3, 4)") == "1 E032 `hypot` takes 2 or 3 arguments; this call has 4");
  CHECK(refusal("range(1, 2, 3, 4)") == "1 E032 `range` takes 1 to 3 arguments; this call has 4");
  CHECK(refusal("min()") == "1 E032 `min` takes 1 argument or more; this call has 0");
  CHECK(refusal("rgb(1, 2)") == "1 E032 `rgb` takes 1 or 3 arguments; this call has 2");
  CHECK(help_of("atan2(1)") == "it is called as `atan2(y, x)`");
  CHECK(marked("atan2(1)") == 8);
  CHECK(refusal("map([1], atan2)") == "10 E032 `atan2` takes 2 arguments; this call has 1");
}

TEST_CASE("builtin refusals: each function has its counts", "[builtins]") {
  const auto wrong = [](const BuiltinInfo& info, int count) {
    std::string call(info.id);
    call += '(';
    for (int i = 0; i < count; ++i) call += "1,";
    return refusal(call + ")").substr(0, 6);
  };
  for (const BuiltinInfo& info : all_builtins()) {
    CAPTURE(info.id);
    if (info.min_arguments > 0) CHECK(wrong(info, info.min_arguments - 1) == "1 E032");
    if (info.max_arguments != k_any_count) CHECK(wrong(info, info.max_arguments + 1) == "1 E032");
  }
}

TEST_CASE("builtin refusals: results stay finite", "[builtins]") {
  CHECK(refusal("sqrt(-1)") == "1 E031 every number stays finite; `sqrt(-1)` is not a number");
  CHECK(refusal("log(0)") == "1 E031 every number stays finite; `log(0)` is infinite");
  CHECK(refusal("log2(-2)") == "1 E031 every number stays finite; `log2(-2)` is not a number");
  CHECK(refusal("log10(0)") == "1 E031 every number stays finite; `log10(0)` is infinite");
  CHECK(refusal("exp(1000)") == "1 E031 every number stays finite; `exp(1000)` is infinite");
  CHECK(refusal("asin(2)") == "1 E031 every number stays finite; `asin(2)` is not a number");
  CHECK(refusal("acos(-1.5)") == "1 E031 every number stays finite; `acos(-1.5)` is not a number");
  CHECK(refusal("tan(90)") == "1 E031 every number stays finite; `tan(90)` is infinite");
  CHECK(refusal("mod(1, 0)") == "1 E031 every number stays finite; `mod(1, 0)` is not a number");
  CHECK(refusal("sqrt(<4, -1, 0>)") ==
        "1 E031 every number stays finite; `sqrt(<4, -1, 0>)` is not a number");
  CHECK(refusal("degrees(1e308)") == "1 E031 every number stays finite; `degrees(1e+308)` is infinite");
  CHECK(refusal("hypot(1.7e308, 1.7e308)") ==
        "1 E031 every number stays finite; `hypot(1.7e+308, 1.7e+308)` is infinite");
  CHECK(refusal("dot(<1e200, 0>, <1e200, 0>)") ==
        "1 E031 every number stays finite; `dot(<1e+200, 0>, <1e+200, 0>)` is infinite");
  CHECK(marked("sqrt(4 - 5)") == 11);
  CHECK(refusal("map([4, -4], sqrt)") == "14 E031 every number stays finite; `sqrt(-4)` is not a number");
}

TEST_CASE("builtin refusals: numbers and vectors alone have components", "[builtins]") {
  CHECK(refusal("sqrt(\"4\")") == "6 E030 `sqrt` wants a number or a vector here; this is a string");
  CHECK(refusal("sin(true)") == "5 E030 `sin` wants a number or a vector here; this is a boolean");
  CHECK(refusal("atan2(1, [2])") == "10 E030 `atan2` wants a number or a vector here; this is a list");
  CHECK(refusal("min([1, 2])") == "5 E030 `min` wants a number or a vector here; this is a list");
  CHECK(help_of("min([1, 2])") == "the elements of a list are compared by `fold(list, list[0], min)`");
  CHECK(help_of("abs(0..2)") == "the elements of a list are worked on by `map(list, f)`");
  CHECK(refusal("max(<1, 2>, <1, 2, 3>)") ==
        "13 E030 the vectors of `max` are of the same length; this one has 3 numbers, another 2");
  CHECK(refusal("clamp(1, 2, sphere { <0, 0, 0>, 1 })") ==
        "13 E030 `clamp` wants a number or a vector here; this is a sphere");
  CHECK(refusal("smoothstep(2, 2, 1)") == "15 E038 the edges of `smoothstep` differ; both are 2");
}

TEST_CASE("builtin refusals: vectors", "[builtins]") {
  CHECK(refusal("dot(1, <1, 2>)") == "5 E030 `dot` wants a vector here; this is a number");
  CHECK(refusal("dot(<1, 2>, <1, 2, 3>)") ==
        "13 E030 the vectors of `dot` are of the same length; this one has 3 numbers, the one before it 2");
  CHECK(refusal("cross(<1, 2>, z)") ==
        "7 E030 `cross` wants a vector of 3 numbers here; this is a vector of 2 numbers");
  CHECK(refusal("length([1])") == "8 E030 `length` wants a vector here; this is a list");
  CHECK(help_of("length([1])") == "the number of elements is `len(..)`");
  CHECK(refusal("length(3)") == "8 E030 `length` wants a vector here; this is a number");
  CHECK(refusal("normalize(<0, 0, 0>)") ==
        "11 E016 `normalize` wants a vector that is not zero; this one is <0, 0, 0>");
  CHECK(refusal("distance(x, 1)") == "13 E030 `distance` wants a vector here; this is a number");
  CHECK(refusal("hypot(x, 1)") == "7 E030 `hypot` wants a number here; this is a vector of 3 numbers");
  CHECK(refusal("reflect(x, <0, 0, 0>)") ==
        "12 E016 `reflect` wants a vector that is not zero; this one is <0, 0, 0>");
  CHECK(refusal("rotate_about(x, <0, 0, 0>, 5)") == "17 E016 an axis is not zero; this one is <0, 0, 0>");
  CHECK(refusal("rotate_about(x, y, z)") ==
        "20 E030 `rotate_about` wants a number here; this is a vector of 3 numbers");
}

TEST_CASE("builtin refusals: colours", "[builtins]") {
  CHECK(refusal("rgb(x, 1, 2)") == "5 E030 `rgb` wants a number here; this is a vector of 3 numbers");
  CHECK(refusal("rgb(<1, 0, 0>)") == "5 E030 `rgb` wants a number here; this is a vector of 3 numbers");
  CHECK(help_of("rgb(<1, 0, 0>)") == "a vector of 3 numbers is a colour already: <1, 0, 0> is rgb(1, 0, 0)");
  CHECK(refusal("srgb(255, 0, 0)") == "6 E015 a component of `srgb` lies between 0 and 1; this one is 255");
  CHECK(help_of("srgb(255, 0, 0)") == "bytes are written as #ff8800");
  CHECK(refusal("srgb(0, 0, -0.1)") ==
        "12 E015 a component of `srgb` lies between 0 and 1; this one is -0.1");
  CHECK(refusal("hsv(0, 2, 1)") == "8 E015 a saturation lies between 0 and 1; this one is 2");
  CHECK(refusal("hsv(0, 1, -1)") == "11 E015 a value of `hsv` lies between 0 and 1; this one is -1");
  CHECK(refusal("kelvin(0)") == "8 E013 a temperature is positive; this one is 0");
  CHECK(refusal("luminance(\"red\")") ==
        "11 E030 `luminance` wants a colour, three numbers or one for a grey, here; this is a string");
}

TEST_CASE("builtin refusals: patterns", "[builtins]") {
  CHECK(refusal("checker(0, 1, 0)") == "15 E013 the size of a checker's cells is positive; this one is 0");
  CHECK(refusal("checker(0, <1, 2>)") ==
        "12 E030 `checker` wants a colour, three numbers or one for a grey, here; this is a vector of 2 "
        "numbers");
  CHECK(refusal("stripes(0, 1, <0, 0, 0>)") ==
        "15 E016 the axis of stripes is not zero; this one is <0, 0, 0>");
  CHECK(refusal("stripes(0, 1, x, -2)") == "18 E013 the width of stripes is positive; this one is -2");
  CHECK(refusal("gradient(0, 1, x, x)") == "19 E016 the two points of a gradient differ; both are <1, 0, 0>");
  CHECK(refusal("gradient(0, 1, 0, 1)") ==
        "16 E030 `gradient` wants a vector of 3 numbers here; this is a number");
}

TEST_CASE("builtin refusals: lists", "[builtins]") {
  CHECK(refusal("len(5)") ==
        "5 E030 `len` wants a list, a range, a string, a vector or a group here; this is a number");
  CHECK(refusal("push(1, 2)") == "6 E030 `push` wants a list or a range here; this is a number");
  CHECK(refusal("concat([1], \"a\")") == "13 E030 `concat` wants a list or a range here; this is a string");
  CHECK(refusal("map([1], 2)") == "10 E030 `map` wants a function here; this is a number");
  CHECK(refusal("filter([1], fn (v) -> v)") ==
        "13 E030 the function of `filter` returns true or false; this one returned a number");
  CHECK(refusal("sort([1, 2], fn (a, b) -> a - b)") ==
        "14 E030 the function of `sort` returns true or false; this one returned a number");
  CHECK(refusal("sort([1, \"a\"])") ==
        "6 E030 the order is that of two numbers or two strings; these are a string and a number");
  CHECK(refusal("fold([1], 0, fn (a) -> a)") == "14 E032 this function takes 1 argument; this call has 2");
  CHECK(refusal("reverse(\"abc\")") == "9 E030 `reverse` wants a list or a range here; this is a string");
  CHECK(refusal("range(0, 1, 0)") == "13 E038 the step of `range` is not 0; this one is 0");
  CHECK(refusal("range(0, 1, 1e-300)").substr(0, 50) == "1 E038 a list has fewer than 2^32 elements; this o");
  CHECK(refusal("range(\"a\")") == "7 E030 `range` wants a number here; this is a string");
  CHECK(refusal("zip([1], 1)") == "10 E030 `zip` wants a list or a range here; this is a number");
}

TEST_CASE("builtin refusals: strings and others", "[builtins]") {
  CHECK(refusal("join(\"a\", \"b\")") == "6 E030 `join` wants a list or a range here; this is a string");
  CHECK(refusal("join([1], 2)") == "11 E030 `join` wants a string here; this is a number");
  CHECK(refusal("split(12, \"1\")") == "7 E030 `split` wants a string here; this is a number");
  CHECK(help_of("split(12, \"1\")") == "`str(v)` makes a string of any value");
  CHECK(refusal("format(\"a\", 2)") == "8 E030 `format` wants a number or a vector here; this is a string");
  CHECK(refusal("format(1, 2.5)") ==
        "11 E015 the digits behind the point are a whole number from 0 to 100; this one is 2.5");
  CHECK(refusal("format(1, 101)") ==
        "11 E015 the digits behind the point are a whole number from 0 to 100; this one is 101");
  CHECK(refusal("rand(\"seed\")") == "6 E030 `rand` wants a number or a vector here; this is a string");
  CHECK(refusal("noise(x)") == "1 E047 `noise` comes with a later version");
  CHECK(refusal("fbm(x, 2)") == "1 E047 `fbm` comes with a later version");
}

TEST_CASE("builtin refusals: assertions", "[builtins]") {
  CHECK(failure("assert(1 > 2)") == "1:8 E035 this was asserted to be true; it is false");
  CHECK(failure("assert(1 > 2, \"one is less\")") == "1:8 E035 failed assertion: one is less");
  CHECK(failure("assert(1)") == "1:8 E030 `assert` wants true or false here; this is a number");
  CHECK(failure("assert(false, 1)") == "1:15 E030 `assert` wants a string here; this is a number");
}

TEST_CASE("operators: what they refuse", "[builtins]") {
  CHECK(refusal("1 / 0") == "1 E031 every number stays finite; 1 / 0 is infinite");
  CHECK(refusal("0 / 0") == "1 E031 every number stays finite; 0 / 0 is not a number");
  CHECK(refusal("5 % 0") == "1 E031 every number stays finite; 5 % 0 is not a number");
  CHECK(refusal("1e308 * 10") == "1 E031 every number stays finite; 1e+308 * 10 is infinite");
  CHECK(refusal("1e308 + 1e308") == "1 E031 every number stays finite; 1e+308 + 1e+308 is infinite");
  CHECK(refusal("<1, 2> / <1, 0>") == "1 E031 every number stays finite; <1, 2> / <1, 0> is infinite");
  CHECK(refusal("10 ^ 400") == "1 E031 every number stays finite; 10 ^ 400 is infinite");
  CHECK(refusal("(-8) ^ 0.5") == "1 E031 every number stays finite; -8 ^ 0.5 is not a number");
  CHECK(refusal("\"a\" + 1") == "1 E030 `+` wants numbers or vectors; here it has a string and a number");
  CHECK(help_of("\"a\" + 1") == "values are put into strings as \"{a} and {b}\"");
  CHECK(help_of("[1] + [2]") == "lists are joined by `concat(a, b)`");
  CHECK(refusal("<1, 2> + <1, 2, 3>") ==
        "1 E030 `+` wants vectors of the same length; these have 2 and 3 numbers");
  CHECK(refusal("true * 2") == "1 E030 `*` wants numbers or vectors; here it has a boolean and a number");
  CHECK(refusal("\"a\" ^ 2") == "1 E030 `^` wants numbers or vectors; here it has a string and a number");
  CHECK(refusal("<1, 2> ^ x") == "1 E030 `^` wants vectors of the same length; these have 2 and 3 numbers");
  CHECK(refusal("-\"a\"") == "1 E030 `-` wants a number or a vector; this is a string");
  CHECK(refusal("x < y") ==
        "1 E030 the order is that of two numbers or two strings; these are a vector and a vector");
}

TEST_CASE("builtin refusals: what is nested too deep is an error", "[builtins]") {
  // On a stack of some megabytes: none has room for every list that 100 million steps can nest.
  const std::string nest =
      "let a = [] let b = [] let i = 0\nwhile i < 400000 { a = [a] b = [b] i = i + 1 }\n";
  CHECK(run_shallow(nest + "print(a)").only().message == "this list is nested too deep to be shown");
  CHECK(run_shallow(nest + "print(a == b)").only().message ==
        "these values are nested too deep to be compared");
}

TEST_CASE("builtin refusals: endless work ends at the step limit", "[builtins]") {
  Limits limits;
  limits.steps = 10000;
  for (const std::string call :
       {"len(concat(0..1000000))", "len(map(0..1000000, sin))", "len(zip(0..1000000, 0..1000000))",
        "len(sort(0..1000000))", "len(reverse(0..9007199254740992))", "len(range(1000000))",
        "len(join(0..1000000, \"\"))", "len(filter(0..1000000, fn (v) -> true))", "fold(0..1000000, 0, max)",
        "len(push(0..1000000, 1))"}) {
    const Ran ran = run("print(" + call + ")", limits);
    CAPTURE(call, ran.found);
    REQUIRE(ran.diagnostics.size() == 1);
    CHECK(ran.diagnostics[0].code == Code::step_limit);
  }
}

}  // namespace lancer::lang
