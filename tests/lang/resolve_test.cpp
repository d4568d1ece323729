#include "catch.hpp"
#include "lang/run_script.hpp"

namespace lancer::lang {
namespace {

using Found = std::vector<std::string>;

Found found(const std::string& text) { return resolve_text(text).found; }
Found found(const Files& files, const Defines& defines = {}) { return resolve_files(files, defines).found; }

}  // namespace

TEST_CASE("resolve: all unknown names are told at once, in unused code too", "[resolve]") {
  CHECK(found("print(a)\nfn f() = b + \"{c}\"\nif true { d = 1 }") ==
        Found{"main.scn:1:7 E020 nothing is called `a` here",
              "main.scn:2:4 W101 nothing uses `f`, so it is not evaluated",
              "main.scn:2:10 E020 nothing is called `b` here",
              "main.scn:2:16 E020 nothing is called `c` here",
              "main.scn:3:11 E026 there is no variable `d` to assign to"});
}

TEST_CASE("resolve: an unknown name gets the nearest known one as help", "[resolve]") {
  CHECK(resolve_text("let radius = 2  print(raduis, radius)").only().help == "did you mean `radius`?");
  CHECK(resolve_text("print(1)  prnt(2)").only().help == "did you mean `print`?");
  CHECK(resolve_text("vec3(1, 2, 3)").only().help == "a vector is `<1, 2, 3>`");
  CHECK(resolve_text("print(q)").only().help.empty());
}

TEST_CASE("resolve: a name that begins a block and resembles an attribute is taken for one", "[resolve]") {
  const Diagnostic d = resolve_text("sphere { centr, 2 }").only();
  CHECK(d.code == Code::unknown_name);
  CHECK(d.help == "is the attribute `center` meant?");
}

TEST_CASE("resolve: a let is known from its end on", "[resolve]") {
  const Diagnostic d = resolve_text("print(a)\nlet a = 1").diagnostics.at(0);
  CHECK(d.message == "nothing is called `a` here");
  REQUIRE(d.labels.size() == 1);
  CHECK(d.labels[0].text == "its `let` comes only here");
  CHECK(found("let a = a") == Found{"main.scn:1:5 W101 nothing uses `a`, so it is not evaluated",
                                    "main.scn:1:9 E020 nothing is called `a` here"});
  CHECK(found("if true { let b = 1  print(b) }  print(b)") ==
        Found{"main.scn:1:40 E020 nothing is called `b` here"});
}

TEST_CASE("resolve: a fn is known in its whole block", "[resolve]") {
  CHECK(found("print(f())\nfn f() = g()\nfn g() = 1").empty());
  CHECK(found("fn f() { print(g())  fn g() = 1 }  f()").empty());
  CHECK(found("if true { fn f() = 1  f() }  f()") == Found{"main.scn:1:30 E020 nothing is called `f` here"});
}

TEST_CASE("resolve: a name is declared once in a scope", "[resolve]") {
  const Diagnostic d = resolve_text("let a = 1\nlet a = 2\nprint(a)").diagnostics.at(0);
  CHECK(d.code == Code::declared_twice);
  CHECK(d.span.begin == 14);
  REQUIRE(d.labels.size() == 1);
  CHECK(d.labels[0].span.begin == 4);
  CHECK(found("let _f = 1\nfn _f() = 2") == Found{"main.scn:2:4 E025 `_f` is declared twice in one scope"});
  CHECK(found("fn _f() = 1\nlet _f = 2") == Found{"main.scn:2:5 E025 `_f` is declared twice in one scope"});
  CHECK(found("print(fn (a, a) -> 1)") == Found{"main.scn:1:14 E025 `a` is declared twice in one scope"});
}

TEST_CASE("resolve: parameters behind one with a default have one too", "[resolve]") {
  CHECK(found("print(fn (a, b = 1, c = 2) -> 0)").empty());
  CHECK(found("print(fn (a = 1, b) -> 0)") ==
        Found{"main.scn:1:18 E001 `b` stands behind a parameter with a default and has none"});
}

TEST_CASE("resolve: an inner scope may use a name anew", "[resolve]") {
  CHECK(found("let a = 1  if a > 0 { let a = 2  print(a) }  fn f(a) { let a = a + 1  print(a) }  f(a)")
            .empty());
  CHECK(found("for i in 0..3 { let i = i  print(i) }").empty());
  CHECK(found("let pi = 3  fn sin(x) = x  print(sin(pi))").empty());
  CHECK(found("group { let a = 1  sphere { <a, 0, 0>, 1 } }  let a = 2  print(a)").empty());
}

TEST_CASE("resolve: what is built in is not assigned", "[resolve]") {
  CHECK(found("pi = 3\nsin = 4") == Found{"main.scn:1:1 E026 `pi` is built in and cannot be assigned",
                                          "main.scn:2:1 E026 `sin` is built in and cannot be assigned"});
  CHECK(found("let pi = 3  pi = 4  print(pi)").empty());
}

TEST_CASE("resolve: names of an included file join the scope of the include", "[resolve]") {
  CHECK(found({{"main.scn", "include \"a\"  print(one, two(1))"}, {"a", "let one = 1  fn two(x) = x"}})
            .empty());
  CHECK(found({{"main.scn", "print(two(1))  include \"a\""}, {"a", "fn two(x) = x"}}).empty());
  CHECK(found({{"main.scn", "print(one)  include \"a\""}, {"a", "let one = 1"}}) ==
        Found{"main.scn:1:7 E020 nothing is called `one` here"});
  CHECK(found({{"main.scn", "let n = 2  include \"a\""}, {"a", "print(n)"}}).empty());
  CHECK(found({{"main.scn", "include \"a\"  include \"b\""},
               {"a", "let one = 1"},
               {"b", "include \"a\"  print(one)"}})
            .empty());
}

TEST_CASE("resolve: a declaration may take the place of an included one", "[resolve]") {
  CHECK(found({{"main.scn", "include \"a\"  let one = 2  print(one)"}, {"a", "let one = 1"}}).empty());
  CHECK(found({{"main.scn", "include \"a\"  include \"b\"  print(one)"},
               {"a", "let one = 1"},
               {"b", "let one = 2"}})
            .empty());
  CHECK(found({{"main.scn", "let one = 1  include \"a\"  print(one)"}, {"a", "let one = 2"}}) ==
        Found{"a:1:5 E025 `one` is declared twice in one scope"});
  CHECK(found({{"main.scn", "include \"a\"  fn one() = 2  print(one())"}, {"a", "fn one() = 1"}}).empty());
  CHECK(found({{"main.scn", "fn one() = 2  include \"a\"  print(one())"}, {"a", "fn one() = 1"}}) ==
        Found{"a:1:4 E025 `one` is declared twice in one scope"});
}

TEST_CASE("resolve: what nothing uses is told once, at its cause", "[resolve]") {
  CHECK(found("let a = 1") == Found{"main.scn:1:5 W101 nothing uses `a`, so it is not evaluated"});
  CHECK(found("let a = 1\nlet b = a") == Found{"main.scn:1:5 W101 nothing uses `a`, so it is not evaluated",
                                               "main.scn:2:5 W101 nothing uses `b`, so it is not evaluated"});
  CHECK(found("fn f() = f()") == Found{"main.scn:1:4 W101 nothing uses `f`, so it is not evaluated"});
  CHECK(found("fn f() { let a = 1 }") == Found{"main.scn:1:4 W101 nothing uses `f`, so it is not evaluated"});
  CHECK(found("fn f() { let a = 1 }  f()") ==
        Found{"main.scn:1:14 W101 nothing uses `a`, so it is not evaluated"});
  CHECK(found("let a = 1  a = 2") == Found{"main.scn:1:5 W101 nothing uses `a`, so it is not evaluated"});
}

TEST_CASE("resolve: a mention is a use, reached or not", "[resolve]") {
  CHECK(found("let a = 1  a = a + 1").empty());
  CHECK(found("let a = 1  if false { print(a) }").empty());
  CHECK(found("let a = 1  fn f(n = a) = n  print(f())").empty());
  CHECK(found("let a = 1  print(\"{a}\")").empty());
  CHECK(found("let a = 1  let b = fn () -> a  b()").empty());
  CHECK(found("fn f(unused) = 2  print(f(1))  for i in 0..2 { }").empty());
  CHECK(found({{"main.scn", "include \"a\""}, {"a", "let one = 1"}}).empty());
}

TEST_CASE("resolve: a definition from outside takes the place of a let", "[resolve]") {
  CHECK(found({{"main.scn", "let n = unknown_too  print(n)"}}, {{"n", "3"}}) ==
        Found{"main.scn:1:9 E020 nothing is called `unknown_too` here"});
  CHECK(found({{"main.scn", "print(n)"}}, {{"n", "3"}}).empty());
  CHECK(found({{"main.scn", "print(1)"}}, {{"n", "3"}}) ==
        Found{"-D:1:5 W101 nothing uses `n`, so it is not evaluated"});
  CHECK(found({{"main.scn", "include \"a\""}, {"a", "print(n)"}}, {{"n", "3"}}).empty());
  CHECK(found({{"main.scn", "print(n)"}}, {{"n", "m"}}) == Found{"-D:1:9 E020 nothing is called `m` here"});
}

TEST_CASE("check: an unknown attribute gets help", "[check]") {
  const auto help = [](const std::string& text) { return resolve_text(text).only().help; };
  const Diagnostic d = resolve_text("sphere { center <0, 0, 0>  radus 1 }").only();
  CHECK(d.code == Code::unknown_attribute);
  CHECK(d.message == "a sphere has no attribute `radus`");
  CHECK(d.help == "did you mean `radius`?");
  CHECK(d.span.begin == 27);
  CHECK(help("view { location <0, 0, 0>  look z }") == "the eye of a view is `eye`");
  CHECK(help("sphere { center <0, 0, 0>  radius 1  look_at z }") ==
        "`look_at` is an attribute of `spot` and `view`");
  CHECK(help("settings { zzzzz 1 }") ==
        "`settings` has `background`, `ambient`, `depth`, `ior`, `shadows`, `sum` and `exposure`");
}

TEST_CASE("check: an attribute stands once", "[check]") {
  const Diagnostic d = resolve_text("sphere { center <0, 0, 0>  radius 1  radius 2 }").only();
  CHECK(d.code == Code::repeated_attribute);
  CHECK(d.message == "`radius` is given twice");
  CHECK(d.span.begin == 37);
  CHECK(resolve_text("material { color 1  diffuse 2 }").only().message ==
        "`color` and `diffuse` are the same attribute");
  CHECK(found("group { material { }  sphere { <0, 0, 0>, 1 }  material { } }") ==
        Found{"main.scn:1:48 E022 `material` is given twice"});
  CHECK(found("sphere { <0, 0, 0>, 1  translate x  scale 2  translate y }").empty());
}

TEST_CASE("check: an attribute has its number of values", "[check]") {
  CHECK(found("sphere { center x, y, z  radius 1 }") ==
        Found{"main.scn:1:20 E024 `center` takes 1 value; here are 3"});
  CHECK(found("cube { points x, y }") == Found{"main.scn:1:8 E024 `points` takes 3 values; here are 2"});
  CHECK(found("sphere { <0, 0, 0>, 1  rotate x, 30, 2 }") ==
        Found{"main.scn:1:38 E024 `rotate` takes 1 or 2 values; here are 3"});
}

TEST_CASE("check: a block uses one form", "[check]") {
  const Diagnostic d = resolve_text("sphere { <0, 0, 0>, 1  center x }").only();
  CHECK(d.code == Code::mixed_forms);
  CHECK(d.message == "a sphere has values without names or `center`, not both");
  CHECK(d.span.begin == 23);
  REQUIRE(d.labels.size() == 1);
  CHECK(d.labels[0].span == Span{0, 9, 21});
  CHECK(resolve_text("plane { point x  points x, y, z }").only().message ==
        "a plane has `point` or `points`, not both");
  CHECK(resolve_text("view { eye x  look y  look_at z }").only().message ==
        "a view has `look` or `look_at`, not both");
  CHECK(resolve_text("view { eye x  look y  fov 40  width 2 }").only().message ==
        "a view has `fov` or `width`, not both");
  CHECK(resolve_text("view { eye x  corners x, y, z  up y }").only().message ==
        "a view has `corners` or `up`, not both");
  CHECK(found("view { eye x  corners x, y, z  size 4, 3 }").empty());
  CHECK(found("facet { x, y, z  normals x, y, z }").empty());
}

TEST_CASE("check: the number of values without names", "[check]") {
  CHECK(found("sphere { <0, 0, 0> }") ==
        Found{"main.scn:1:1 E024 a sphere takes 2 values without names; this one has 1"});
  CHECK(found("sphere { <0, 0, 0>, 1, 2 }") ==
        Found{"main.scn:1:24 E024 a sphere takes 2 values without names; this one has 3"});
  CHECK(found("plane { x, y, z, x }") ==
        Found{"main.scn:1:18 E024 a plane takes 2 or 3 values without names; this one has 4"});
  CHECK(found("light { <0, 5, 0> }") ==
        Found{"main.scn:1:9 E024 the values of a light stand behind the names of its attributes"});
}

TEST_CASE("check: what has no default must be given", "[check]") {
  CHECK(found("sphere { radius 1 }") == Found{"main.scn:1:1 E023 a sphere needs `center`"});
  CHECK(found("sphere { }") == Found{"main.scn:1:1 E023 a sphere needs `center` and `radius`"});
  CHECK(found("plane { }") == Found{"main.scn:1:1 E023 a plane needs `point` and `normal`, or `points`"});
  CHECK(found("view { }") ==
        Found{"main.scn:1:1 E023 a view needs `eye`, and `look`, `look_at` or `corners`"});
  CHECK(found("view { eye x  fov 20 }") == Found{"main.scn:1:1 E023 a view needs `look` or `look_at`"});
  CHECK(found("spot { at y }") == Found{"main.scn:1:1 E023 a spot needs `look_at`"});
  CHECK(found("material { }  group { }  settings { }").empty());
}

}  // namespace lancer::lang
