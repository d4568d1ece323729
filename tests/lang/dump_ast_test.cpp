#include "catch.hpp"
#include "grammar/parse.hpp"
#include "lang/ast.hpp"

namespace lancer::ast {
namespace {

std::string dumped(const std::string& text) {
  SourceMap sources;
  const grammar::Parsed parsed = grammar::parse(sources, sources.add("main.scn", text));
  INFO(to_text(parsed.diagnostics, sources));
  REQUIRE(parsed.diagnostics.empty());
  return dump(parsed.script);
}

}  // namespace

TEST_CASE("dump: statements", "[dump]") {
  CHECK(dumped("let a = 1\na = 2\nfor i in 0..3 { break }\nwhile true { continue }") ==
        R"(let a
  number 1
assign a
  number 2
for i
  range ..
    number 0
    number 3
  do
    break
while
  true
  do
    continue
)");
  CHECK(dumped("if a { b } else if c { } else { d }\ninclude \"x.scn\"\nremove \"b *\"\nmodify \"c\" { "
               "radius 2 }") ==
        R"(if
  when
    name a
  then
    add
      name b
  when
    name c
  then
  else
    add
      name d
include "x.scn"
remove
  string "b *"
modify
  string "c"
  attribute radius
    number 2
)");
}

TEST_CASE("dump: functions", "[dump]") {
  CHECK(dumped("fn f(a, b = 2) = a\nfn g() { return; }\nlet h = fn (x) -> x") ==
        R"(fn f
  parameter a
  parameter b
    number 2
  value
    name a
fn g
  do
    return
let h
  function
    parameter x
    value
      name x
)");
}

TEST_CASE("dump: expressions", "[dump]") {
  CHECK(dumped("f(1 + 2 - 3 * -a, <1, 2>, [x ^ 2], b ? v.x : l[0], not (p and q or 1 <= 2), #0f0, \"n{i}!\", "
               "\"q\\\"\")") ==
        R"(add
  call
    name f
    chain
      number 1
      +
        number 2
      -
        chain
          number 3
          *
            negate
              name a
    vector
      number 1
      number 2
    list
      power
        name x
        number 2
    choose
      name b
      member x
        name v
      index
        name l
        number 0
    not
      or
        and
          name p
          name q
        compare <=
          number 1
          number 2
    color 0 1 0
    string
      "n"
      name i
      "!"
    string "q\""
)");
}

TEST_CASE("dump: blocks", "[dump]") {
  CHECK(dumped("group \"g\" { let r = 1  sphere { x, r  material { diffuse 1 } }  scale 2 }\nsettings { "
               "depth 3 }") ==
        R"(add
  group
    name
      string "g"
    let r
      number 1
    add
      sphere
        value
          name x
        value
          name r
        attribute material
          material
            attribute diffuse
              number 1
    attribute scale
      number 2
settings
  attribute depth
    number 3
)");
}

}  // namespace lancer::ast
