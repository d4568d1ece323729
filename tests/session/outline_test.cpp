#include "session/outline.hpp"

#include "catch.hpp"

using namespace lancer::session;

TEST_CASE("outline: statements have their names and places", "[outline]") {
  const std::string text = "let a = 1\nfn f() = a\nsphere \"s\" { <0, 0, 0>, a }\nf()\nfor i in 0..2 { }\n";
  const Outline out = outline_of(text);
  REQUIRE(out.items.size() == 5);
  CHECK(out.items[0].kind == Item::Kind::variable);
  CHECK(find_item(out, Item::Kind::function, "f") == &out.items[1]);
  CHECK(text_of(text, *find_item(out, Item::Kind::object, "s")) == "sphere \"s\" { <0, 0, 0>, a }");
  CHECK(out.items[3].kind == Item::Kind::expression);
  CHECK(out.items[4].kind == Item::Kind::other);
  CHECK(find_item(out, Item::Kind::object, "a") == nullptr);
}

TEST_CASE("outline: a name with a value in it is none", "[outline]") {
  const Outline out = outline_of("let i = 1 sphere \"s{i}\" { <0, 0, 0>, 1 }");
  REQUIRE(out.items.size() == 2);
  CHECK(out.items[1].name == "");
}

TEST_CASE("outline: the parser tells what ends too early", "[outline]") {
  CHECK(outline_of("fn f() {").is_incomplete);
  CHECK(outline_of("let a =").is_incomplete);
  CHECK(outline_of("1 +").is_incomplete);
  CHECK_FALSE(outline_of("let a = )").is_incomplete);
  CHECK(outline_of("let a = )").is_wrong);
  CHECK_FALSE(outline_of("let a = 1").is_incomplete);
}

TEST_CASE("outline: an item goes with its own lines only", "[outline]") {
  const std::string text = "// one\nlet a = 1;\n// two\nlet b = 2  let c = 3\n";
  const Outline out = outline_of(text);
  REQUIRE(out.items.size() == 3);
  CHECK(without(text, out.items[0]) == "// one\n// two\nlet b = 2  let c = 3\n");
  CHECK(without(text, out.items[1]) == "// one\nlet a = 1;\n// two\nlet c = 3\n");
  CHECK(without(text, out.items[2]) == "// one\nlet a = 1;\n// two\nlet b = 2 \n");
  CHECK(replaced(text, out.items[1], "let b = 5") == "// one\nlet a = 1;\n// two\nlet b = 5  let c = 3\n");
}

TEST_CASE("outline: a quoted name reads back the same", "[outline]") {
  const std::string name = "a \"b\" {c} \\ \n";
  const Outline out = outline_of("sphere " + quoted_name(name) + " { <0, 0, 0>, 1 }");
  REQUIRE(out.items.size() == 1);
  CHECK(out.items[0].name == name);
}
