#include <atomic>

#include "base/deep_stack.hpp"
#include "catch.hpp"
#include "lang/run_script.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

using Found = std::vector<std::string>;

std::string names(const std::vector<Ref<Object>>& objects) {
  std::string out;
  for (const Ref<Object>& o : objects) {
    if (!out.empty()) out += ' ';
    out += o->name.empty() ? type_name(Value(o)) : o->name;
    if (o->kind != ast::Kind::group) continue;
    out += '(';
    out += names(o->members);
    out += ')';
  }
  return out;
}

/// The names of what a script adds, groups with their members in parentheses.
std::string added(const std::string& text) {
  const Ran ran = run(text);
  CAPTURE(text, ran.found);
  CHECK_FALSE(has_errors(ran.diagnostics));
  return names(ran.objects);
}

const std::string k_ball = "fn ball(n) = sphere \"{n}\" { <0, 0, 0>, 1 }\n";

}  // namespace

// --- Expressions
// ---------------------------------------------------------------------------------------------

TEST_CASE("evaluate: operators and their order", "[evaluate]") {
  CHECK(printed("print(1 + 2 * 3 - 4 / 2, 2 ^ 3 ^ 2, -2 ^ 2, 2 ^ -1, 7 % 3, -7 % 3)") ==
        "5 512 -4 0.5 1 2\n");
  CHECK(printed("print(1 < 2, 1 >= 2, 1 == 1, 1 != 1, 2 <= 2, 2 > 2)") ==
        "true false true false true false\n");
  CHECK(printed("print(true ? 1 : 2, false ? 1 : true ? 2 : 3, not true or true, true and not false)") ==
        "1 2 true true\n");
  CHECK(printed("let a = 5  print(\"{a} and {a + 1}{\"\"} \\{\", \"\")") == "5 and 6 { \n");
  CHECK(
      printed("print([1, \"a\"][1], <4, 5>[1], (3..7)[2], [[1, 2], [3]][0][1], <1, 2, 3>.z, <1, 2, 3>.g)") ==
      "a 5 5 2 3 2\n");
}

TEST_CASE("evaluate: and, or and the conditional evaluate only what they need", "[evaluate]") {
  CHECK(printed("print(false and 1 / 0 == 1, true or 1 / 0 == 1, true ? 1 : 1 / 0)") == "false true 1\n");
  CHECK(failure("print(true and 1 / 0 == 1)").substr(0, 9) == "1:16 E031");
}

TEST_CASE("evaluate: conditions are booleans", "[evaluate]") {
  CHECK(failure("if 1 { }") == "1:4 E030 a condition is true or false; this is a number");
  CHECK(failure("while \"a\" { }") == "1:7 E030 a condition is true or false; this is a string");
  CHECK(failure("print(1 ? 2 : 3)") == "1:7 E030 a condition is true or false; this is a number");
  CHECK(failure("print(true and 1)") == "1:16 E030 what `and` joins is true or false; this is a number");
  CHECK(failure("print(false or x)") == "1:16 E030 what `or` joins is true or false; this is a vector");
  CHECK(failure("print(not 1)") == "1:11 E030 what `not` turns round is true or false; this is a number");
}

TEST_CASE("evaluate: the span of a chain goes up to the operand at fault", "[evaluate]") {
  // print(1 + 2 / 0 - 3): the division alone; print(1 + 2 + true * ...): from the first operand on
  const Ran division = run("print(1 + 2 / 0 - 3)");
  CHECK(division.only().span == Span{0, 10, 15});
  const Ran sum = run("print(1 + 2 + true + 4)");
  CHECK(sum.only().span == Span{0, 6, 18});
}

TEST_CASE("evaluate: ranges have whole bounds within 2 to the 53", "[evaluate]") {
  CHECK(printed("for i in 0..3 { print(i) }  for i in 2..=3 { print(i) }  for i in 3..0 { print(i) }") ==
        "0\n1\n2\n2\n3\n");
  CHECK(printed("let r = 5..9007199254740992  print(len(r), r[3], 1..=0)") == "9007199254740987 8 1..=0\n");
  CHECK(failure("print(0..1.5)") == "1:10 E015 the bounds of a range are whole numbers; this one is 1.5");
  CHECK(failure("print(true..2)") == "1:7 E030 the bounds of a range are whole numbers; this is a boolean");
  CHECK(failure("print(0..9007199254740994)") ==
        "1:10 E015 the bounds of a range lie within 2^53 of 0; this one is 9007199254740994");
}

TEST_CASE("evaluate: indices are whole and in range", "[evaluate]") {
  CHECK(failure("print([1, 2][2])") == "1:14 E033 the indices of this list go from 0 to 1; this one is 2");
  CHECK(failure("print([1, 2][-1])") == "1:14 E033 the indices of this list go from 0 to 1; this one is -1");
  CHECK(failure("print((0..5)[0.5])") == "1:14 E033 an index is a whole number; this one is 0.5");
  CHECK(failure("print([][0])") == "1:10 E033 this list is empty; there is no index 0");
  CHECK(failure("print(x[3])") == "1:9 E033 the indices of this vector go from 0 to 2; this one is 3");
  CHECK(failure("print(x[true])") == "1:9 E030 an index is a whole number; this is a boolean");
  CHECK(failure("print(5[0])") ==
        "1:7 E030 an index goes with a list, a range, a vector or a group; this is a number");
}

TEST_CASE("evaluate: members", "[evaluate]") {
  CHECK(printed(k_ball + "print(ball(7).name, <1, 2>.y, red.r)") == "7 2 1\n");
  CHECK(failure("print(<1, 2>.z)") == "1:14 E034 a vector of 2 numbers has no `z`");
  CHECK(failure("print(x.w)") == "1:9 E034 a vector of 3 numbers has no `w`");
  CHECK(failure("print([1].length)") == "1:11 E034 a list has no members");
}

TEST_CASE("evaluate: vectors hold numbers", "[evaluate]") {
  CHECK(printed("print(<1, 2>, <1 + 1, -3, 4>)") == "<1, 2> <2, -3, 4>\n");
  CHECK(failure("print(<1, true>)") == "1:11 E030 the components of a vector are numbers; this is a boolean");
}

// --- Variables and functions
// -----------------------------------------------------------------------------------

TEST_CASE("evaluate: closures share the variables of their scope", "[evaluate]") {
  CHECK(printed("fn counter() { let n = 0  return fn () { n = n + 1  return n } }\n"
                "let a = counter()  let b = counter()\nprint(a(), a(), b(), a())") == "1 2 1 3\n");
  CHECK(
      printed("let f = []  for i in 0..3 { f = push(f, fn () -> i * 10) }  print(f[0](), f[1](), f[2]())") ==
      "0 10 20\n");
  CHECK(printed("let f = []  let i = 0  while i < 3 { let j = i  f = push(f, fn () -> j)  i = i + 1 }  "
                "print(f[0](), f[2]())") == "0 2\n");
  CHECK(printed("fn a(x) { fn b(y) { fn c(z) = x + y + z  return c }  return b }  print(a(1)(20)(300))") ==
        "321\n");
  CHECK(printed("fn f(p) { let g = fn () { p = p + 1 }  g()  g()  return p }  print(f(1))") == "3\n");
  CHECK(printed("let g = group { let a = 1  fn up() { a = a + 1 }  up()  sphere \"s{a}\" { <a, 0, 0>, 1 } }  "
                "print(g[0].name)") == "s2\n");
}

TEST_CASE("evaluate: inner scopes leave captured variables of later statements alone", "[evaluate]") {
  CHECK(printed("fn f() { if true { let t = 5  print(t) }  let b = 2  let g = fn () -> b  return g }  "
                "print(f()())") == "5\n2\n");
  CHECK(printed("let h = []  fn f() { h = group { let t = 1  let u = t  sphere { <u, 0, 0>, 1 } }  let n = "
                "len(h)  fn g() = n"
                "  return g }  print(f()())") == "1\n");
  CHECK(printed("fn f(a = [group { let t = 1  sphere { <t, 0, 0>, 1 } }], b = fn () -> a) = b  "
                "print(len(f()()))") == "1\n");
}

TEST_CASE("evaluate: functions of a block know each other", "[evaluate]") {
  CHECK(printed("print(even(10))\nfn even(n) = n == 0 ? true : odd(n - 1)\nfn odd(n) = n == 0 ? false : "
                "even(n - 1)") == "true\n");
  CHECK(printed("fn f(n) { return even(n)  fn even(n) = n == 0 ? true : odd(n - 1)  fn odd(n) = n == 0 ? "
                "false : even(n - 1) }"
                "  print(f(7))") == "false\n");
  CHECK(printed("for i in 0..3 { fn fac(n) = n < 2 ? 1 : n * fac(n - 1)  print(fac(i + 3)) }") ==
        "6\n24\n120\n");
}

TEST_CASE("evaluate: defaults are evaluated at each call and see earlier parameters", "[evaluate]") {
  CHECK(printed("let n = 1  fn f(a, b = a + n, c = b * 2) = [a, b, c]  print(f(1), f(1, 5), f(1, 5, 0))  n = "
                "10  print(f(1))") == "[1, 2, 4] [1, 5, 10] [1, 5, 0]\n[1, 11, 22]\n");
  CHECK(printed("fn f(a, g = fn () -> a) { a = a + 1  return g() }  print(f(1))") == "2\n");
}

TEST_CASE("evaluate: a wrong number of arguments", "[evaluate]") {
  const Ran ran = run("fn area(r) = r\nprint(area(1, 2))");
  CHECK(ran.only().message == "`area` takes 1 argument; this call has 2");
  CHECK(ran.only().span == Span{0, 21, 31});
  CHECK(failure("fn f(a, b = 1) = a + b  print(f())") ==
        "1:31 E032 `f` takes 1 to 2 arguments; this call has 0");
  CHECK(failure("let f = fn () -> 1  print(f(2))") ==
        "1:27 E032 this function takes 0 arguments; this call has 1");
  CHECK(failure("let a = 1  a(2)") == "1:12 E030 only functions can be called; this is a number");
}

TEST_CASE("evaluate: a variable without a value", "[evaluate]") {
  const Ran ran = run("f()\nlet a = 1\nfn f() { print(a) }");
  CHECK(ran.only().code == Code::no_value_yet);
  CHECK(ran.only().span == Span{0, 29, 30});
  REQUIRE(ran.only().labels.size() == 1);
  CHECK(ran.only().labels[0].span == Span{0, 8, 9});
  REQUIRE(ran.only().trace.size() == 1);
  CHECK(failure("fn g() { f()  let a = 1  fn f() { print(a) } }  g()").substr(0, 9) == "1:41 E037");
}

TEST_CASE("evaluate: functions are equal if they are the same one", "[evaluate]") {
  CHECK(printed("fn f() = 1  let g = f  print(f == g, sin == sin, f == fn () -> 1)") == "true true false\n");
}

TEST_CASE("evaluate: what nothing uses is not evaluated", "[evaluate]") {
  CHECK(printed("let a = print(1)  print(2)") == "2\n");
  CHECK(printed("let a = 1 / 0  a = 3  print(2)") == "2\n");
}

TEST_CASE("evaluate: definitions from outside", "[evaluate]") {
  const auto output = [](const Files& files, const Defines& defines) {
    return run_files(files, defines).printed;
  };
  CHECK(output({{"main.scn", "let n = 1 / 0  print(n + 1)"}}, {{"n", "3"}}) == "4\n");
  CHECK(output({{"main.scn", "include \"a\"  print(n + 1)"}, {"a", "print(n)"}}, {{"n", "3"}}) == "3\n4\n");
  CHECK(output({{"main.scn", "print(m)"}}, {{"n", "3"}, {"m", "[n, n + 1]"}}) == "[3, 4]\n");
  CHECK(output({{"main.scn", "let k = 2  let n = 1  print(n)"}}, {{"n", "k * 10"}}) == "20\n");
}

TEST_CASE("evaluate: included files run where they are named", "[evaluate]") {
  const auto output = [](const Files& files) { return run_files(files).printed; };
  CHECK(output({{"main.scn", "print(1)  include \"a\"  include \"a\"  print(n)"},
                {"a", "let n = 3  print(2)"}}) == "1\n2\n3\n");
  CHECK(output({{"main.scn", "include \"a\"  let n = 5  print(n, get())"},
                {"a", "let n = 3  fn get() = n"}}) == "5 3\n");
  CHECK(output({{"main.scn", "print(early())  include \"a\""}, {"a", "fn early() = 7"}}) == "7\n");
  CHECK(output({{"main.scn", "include \"a\"  for i in 0..2 { print(i) }"},
                {"a", "for i in 5..6 { print(i) }"}}) == "5\n0\n1\n");
}

// --- Statements
// ------------------------------------------------------------------------------------------------

TEST_CASE("evaluate: loops, break and continue", "[evaluate]") {
  CHECK(printed("for i in 0..9 { if i == 1 { continue }  if i == 4 { break }  print(i) }") == "0\n2\n3\n");
  CHECK(printed("let n = 3  while n > 0 { n = n - 1  if n == 1 { continue }  print(n) }") == "2\n0\n");
  CHECK(printed("for i in 0..2 { for j in 0..5 { if j == 1 { break }  print(i, j) } }") == "0 0\n1 0\n");
  CHECK(printed("for p in [x, 5, \"a\"] { print(p) }") == "<1, 0, 0>\n5\na\n");
  CHECK(printed(k_ball + "for o in group { ball(1)  ball(2) } { print(o.name) }") == "1\n2\n");
  CHECK(failure("for i in 5 { }") ==
        "1:10 E030 `for` goes over a range, a list or a group; this is a number");
}

TEST_CASE("evaluate: break, continue and return leave a group that is being made", "[evaluate]") {
  CHECK(added(k_ball + "for i in 0..4 { group { if i == 1 { continue }  if i == 3 { break }  ball(i) } }") ==
        "group(0) group(2)");
  CHECK(added(k_ball + "fn f() { ball(1)  let g = group { ball(2)  if true { return; } }  g }  f()") ==
        "group(1)");
  CHECK(printed(k_ball + "fn f(n) { for i in 0..9 { let g = [1, group { if i == n { return i * 10 } }]  "
                         "print(len(g)) } }  print(f(1))") == "2\n10\n");
}

TEST_CASE("evaluate: an object as a statement is added", "[evaluate]") {
  CHECK(added(k_ball + "let s = ball(1)  s  s;  [ball(2), [ball(3), []], s]") == "1 1 2 3 1");
  CHECK(added(k_ball + "group \"g\" { ball(1)  group { }  ball(2) }") == "g(1 group() 2)");
  CHECK(added("let s = sphere { <0, 0, 0>, 1 }  print(s.name)").empty());
}

TEST_CASE("evaluate: what a call makes", "[evaluate]") {
  CHECK(added(k_ball + "fn two() { ball(1)  ball(2) }  two()") == "group(1 2)");
  CHECK(added(k_ball + "fn one() { ball(1) }  one()") == "group(1)");
  CHECK(added(k_ball + "fn two() { ball(1)  ball(2) }  let a = [two()]  if len(two()) == 2 { a }") ==
        "group(1 2)");
  CHECK(added(k_ball + "fn two() = [ball(1), ball(2)]  two()") == "1 2");
  CHECK(added(k_ball + "fn outer() { ball(0)  inner()  fn inner() { ball(1) } }  outer()") ==
        "group(0 group(1))");
  CHECK(added(k_ball + "fn early(n) { ball(1)  if n > 0 { return; }  ball(2) }  early(1)  early(0)") ==
        "group(1) group(1 2)");
  CHECK(added("fn nothing() { }  nothing()  print()").empty());
  CHECK(added("fn log(v) = print(v)  log(1)  true ? log(2) : log(3)").empty());
  CHECK(printed("fn nothing() { }  let n = nothing()  print(type_of(n), len(n))") == "group 0\n");
}

TEST_CASE("evaluate: a value returned drops what was added", "[evaluate]") {
  const Ran ran = run(k_ball + "fn f() { ball(1)\nreturn ball(2) }  f()  f()");
  CHECK(ran.found == Found{"main.scn:3:1 W102 the objects that were added before this `return` are dropped"});
  CHECK(names(ran.objects) == "2 2");
}

TEST_CASE("evaluate: any other value as a statement is an error", "[evaluate]") {
  CHECK(failure("1 + 1") == "1:1 E036 this statement's value is a number, which adds nothing");
  CHECK(failure("fn f() = 1  f()") == "1:13 E036 this statement's value is a number, which adds nothing");
  CHECK(failure("[[1]]") == "1:1 E036 this list holds a number, which adds nothing");
  CHECK(failure("0..3") == "1:1 E036 this statement's value is a range, which adds nothing");
  CHECK(failure("material { }") == "1:1 E036 this statement's value is a material, which adds nothing");
}

// --- Errors and limits
// -----------------------------------------------------------------------------------------

TEST_CASE("evaluate: an error lists the calls that led to it", "[evaluate]") {
  const Ran ran = run("fn a(n) = 1 / n\nfn b() { return a(0) }\nlet c = fn () -> b()\nprint(c())");
  const Diagnostic& d = ran.only();
  CHECK(d.code == Code::not_finite);
  REQUIRE(d.trace.size() == 3);
  CHECK(d.trace[0].text == "`a`");
  CHECK(d.trace[0].span == Span{0, 32, 36});
  CHECK(d.trace[1].text == "`b`");
  CHECK(d.trace[2].text == "a function");
  CHECK(d.trace[2].span == Span{0, 66, 69});
}

TEST_CASE("evaluate: what was added before an error is known, and printed", "[evaluate]") {
  CHECK(run("print(1)  print(1 / 0)  print(2)").printed == "1\n");
}

TEST_CASE("evaluate: calls nest 10,000 deep", "[evaluate]") {
  CHECK(printed("fn f(n) = n == 1 ? 1 : 1 + f(n - 1)  print(f(10000))") == "10000\n");
  CHECK(failure("fn f(n) = n == 1 ? 1 : 1 + f(n - 1)  print(f(10001))") ==
        "1:28 E045 calls nest more than 10000 deep");
  CHECK(failure("fn f() { f() }  f()") == "1:10 E045 calls nest more than 10000 deep");
  CHECK(failure("fn f() { group { map([1], fn (a) { f() }) } }  f()").find("E045") != std::string::npos);
  Limits few;
  few.calls = 3;
  CHECK(run("fn f(n) { if n > 0 { f(n - 1) } }  f(2)", few).diagnostics.empty());
  CHECK(run("fn f(n) { if n > 0 { f(n - 1) } }  f(3)", few).only().code == Code::call_limit);
}

TEST_CASE("evaluate: calls end where the stack of the machine does", "[evaluate]") {
  // Not on a deep stack: some megabytes do not hold 10,000 of these.
  const Ran ran = run_shallow("fn f() { group { group { group { [f()] } } } }  f()");
  CHECK(ran.only().code == Code::call_limit);
  CHECK(ran.only().message != "calls nest more than 10000 deep");
}

TEST_CASE("evaluate: steps are counted and limited", "[evaluate]") {
  // One for each of the 10 rounds and the 10 statements in them, and one for the loop.
  CHECK(run("let n = 0  for i in 0..10 { n = n + i }  print(n)").steps == 10 + 10 + 1 + 3);
  Limits few;
  few.steps = 1000;
  const Diagnostic d = run("while true { }", few).only();
  CHECK(d.code == Code::step_limit);
  CHECK(d.message == "the script has used up its 1000 steps");
  CHECK(run("fn f() = f()  f()", few).only().code == Code::step_limit);
  CHECK(run("let s = \"0123456789\"  while true { s = s + s }", few).diagnostics.size() == 1);
  CHECK(run("let s = \"0123456789\"  while true { s = \"{s}{s}\" }", few).only().code == Code::step_limit);
}

TEST_CASE("evaluate: objects are limited, shared ones counted each time", "[evaluate]") {
  Limits few;
  few.objects = 10;
  const std::string ball = "let b = sphere { <0, 0, 0>, 1 }\n";
  CHECK(run(ball + "for i in 0..10 { b }", few).diagnostics.empty());
  CHECK(run(ball + "for i in 0..11 { b }", few).only().code == Code::object_limit);
  // g holds 3 with itself, h is a group of 3 such and so 10; one more is too many
  CHECK(run(ball + "let g = group { b b }\nlet h = group { g g g }\nh", few).diagnostics.empty());
  const Ran ran = run(ball + "let g = group { b b }\nlet h = group { g g g }\nh\nb", few);
  CHECK(ran.found == Found{"main.scn:5:1 E044 this makes more than 10 objects"});
  CHECK(run("let g = group { }\nfor i in 0..100 { g = group { g g } }", few).only().code ==
        Code::object_limit);
}

TEST_CASE("evaluate: a run can be interrupted", "[evaluate]") {
  const std::atomic<bool> stop{true};
  EvaluateOptions options;
  options.interrupt = &stop;
  CHECK_THROWS_AS(run_files({{"main.scn", "while true { }"}}, {}, options), Interrupted);
}

TEST_CASE("evaluate: values nested a million deep come and go", "[evaluate]") {
  CHECK(printed("let l = []  for i in 0..1000000 { l = [l] }  print(len(l))") == "1\n");
  CHECK(printed("let f = fn () -> 0  for i in 0..1000000 { let g = f  f = fn () -> g }  print(type_of(f))") ==
        "function\n");
  CHECK(printed("let g = group { }  for i in 0..1000000 { g = group { g } }  print(len(g))") == "1\n");
  CHECK(failure("let l = [1]  for i in 0..1000000 { l = [l] }  l") ==
        "1:47 E036 this list holds a number, which adds nothing");
}

TEST_CASE("evaluate: closures that hold themselves are freed", "[evaluate]") {
  // The leak check of AddressSanitizer looks at this.
  CHECK(printed("fn f() { let g = 0  g = fn () -> g  return g }  let a = [f(), f()]  print(len(a))") ==
        "2\n");
  CHECK(printed("for i in 0..10000 { let l = []  fn a() = [b, l]  fn b() = a  l = [a, b]  print(len(l)) }")
            .size() == 20000);
}

}  // namespace lancer::lang
