// Which tree a text is: precedence, line breaks, and where attributes end.

#include <string>

#include "catch.hpp"
#include "grammar/parse.hpp"

using namespace lancer;

namespace {

/// The dump on one line, depth shown by parentheses.
std::string tree(const std::string& text) {
  SourceMap sources;
  const grammar::Parsed parsed = grammar::parse(sources, sources.add("test.scn", text));
  if (!parsed.diagnostics.empty()) return parsed.diagnostics.front().message;
  const std::string dump = ast::dump(parsed.script);
  std::string out;
  std::size_t depth = 0;
  for (std::size_t at = 0; at < dump.size();) {
    const std::size_t end = dump.find('\n', at);
    std::string line = dump.substr(at, end - at);
    const std::size_t indent = line.find_first_not_of(' ');
    const std::size_t level = indent / 2;
    if (!out.empty() && level == depth) out += ", ";
    if (level > depth) out += "(";
    for (std::size_t i = level; i < depth; ++i) out += ")";
    if (level < depth) out += ", ";
    depth = level;
    out += line.substr(indent);
    at = end + 1;
  }
  for (std::size_t i = 0; i < depth; ++i) out += ")";
  return out;
}

/// Of `let v = text`.
std::string value(const std::string& text) {
  const std::string all = tree("let v = " + text);
  return all.starts_with("let v(") ? all.substr(6, all.size() - 7) : all;
}

}  // namespace

TEST_CASE("operators bind as the language says", "[tree]") {
  CHECK(value("1 + 2 * 3") == value("1 + (2 * 3)"));
  CHECK(value("1 - 2 - 3") == value("1 - 2 - 3"));
  CHECK(value("-2 ^ 2") == value("-(2 ^ 2)"));
  CHECK(value("2 ^ -1") == value("2 ^ (-1)"));
  CHECK(value("2 ^ 3 ^ 2") == value("2 ^ (3 ^ 2)"));
  CHECK(value("2 ^ 3 ^ 2") != value("(2 ^ 3) ^ 2"));
  CHECK(value("not a == b") == value("not (a == b)"));
  CHECK(value("a or b and c") == value("a or (b and c)"));
  CHECK(value("0..n + 1") == value("0..(n + 1)"));
  CHECK(value("a + 1 < b..c") == value("(a + 1) < (b..c)"));
  CHECK(value("a ? b : c ? d : e") == value("a ? b : (c ? d : e)"));
  CHECK(value("a or b ? 1 : 2") == value("(a or b) ? 1 : 2"));
  CHECK(value("-a.x") == value("-(a.x)"));
  CHECK(value("a[1].x(2)") == value("((a[1]).x)(2)"));
  CHECK(value("1 - 2 - 3") != value("1 - (2 - 3)"));
}

TEST_CASE("a call and an index stand on the line of what they apply to, operators may follow below",
          "[tree]") {
  CHECK(tree("a\n(b)") == "add(name a), add(name b)");
  CHECK(tree("a\n[b]") == "add(name a), add(list(name b))");
  CHECK(tree("a /* \n */ (b)") == "add(name a), add(name b)");
  CHECK(tree("a(b)") == "add(call(name a, name b))");
  CHECK(tree("let v = a\n  + b") == tree("let v = a + b"));
  CHECK(tree("let v = a\n  .x") == tree("let v = a.x"));
}

TEST_CASE("a vector holds no bare comparison, and its angle closes even before ==", "[tree]") {
  CHECK(value("<1, 2, 3>==v") == value("(<1, 2, 3>) == v"));
  CHECK(value("<a ? 1 : 0, 2>") == "vector(choose(name a, number 1, number 0), number 2)");
  CHECK(value("<(a < b) ? 1 : 0, 2>") ==
        "vector(choose(compare <(name a, name b), number 1, number 0), number 2)");
  CHECK_THAT(value("<a < b ? 1 : 0, 2>"), ContainsSubstring("found `<`"));
  CHECK(value("<f(a < b), 2>") == "vector(call(name f, compare <(name a, name b)), number 2)");
  CHECK(value("a < <1, 2>") == "compare <(name a, vector(number 1, number 2))");
}

TEST_CASE("in a block a name that is an attribute of its kind is that attribute", "[tree]") {
  CHECK(tree("sphere { c, r }") == "add(sphere(value(name c), value(name r)))");
  CHECK(tree("sphere { c, radius }") == "add(sphere(value(name c), value(name radius)))");
  CHECK(tree("sphere { center center radius radius }") ==
        "add(sphere(attribute center(name center), attribute radius(name radius)))");
  CHECK_THAT(tree("sphere { center, 1 }"), ContainsSubstring("expected a value, found `,`"));
  CHECK(tree("sphere { centre <1, 2, 3> radius 1 }") ==
        "add(sphere(attribute centre(vector(number 1, number 2, number 3)), attribute radius(number 1)))");
  CHECK(tree("cube { center c; ; side 2; }") ==
        "add(cube(attribute center(name c), attribute side(number 2)))");
  CHECK(tree("cube { rotate x, 30 side 2 }") ==
        "add(cube(attribute rotate(name x, number 30), attribute side(number 2)))");
}

TEST_CASE("a group mixes statements and attributes, and may assign to an attribute's name", "[tree]") {
  CHECK(tree("group { scale = 3 scale 2 }") ==
        "add(group(assign scale(number 3), attribute scale(number 2)))");
  CHECK(tree("group { trnslate <1, 2, 3> }") ==
        "add(group(attribute trnslate(vector(number 1, number 2, number 3))))");
  CHECK(tree("group { material { diffuse 1 } s }") ==
        "add(group(attribute material(material(attribute diffuse(number 1))), add(name s)))");
}

TEST_CASE("return takes a value unless a brace or semicolon follows", "[tree]") {
  CHECK(tree("fn f() { return }") == "fn f(do(return))");
  CHECK(tree("fn f() { return; 1 }") == "fn f(do(return, add(number 1)))");
  CHECK(tree("fn f() { return\n1 }") == "fn f(do(return(number 1)))");
}

TEST_CASE("strings keep text and expressions apart", "[tree]") {
  CHECK(value("\"a{b}c\\n\"") == "string(\"a\", name b, \"c\\n\")");
  CHECK(value("\"{f(\"x {y} }\")}\"") == "string(call(name f, string(\"x \", name y, \" }\")))");
  CHECK(value("\"}\"") == "string \"}\"");
  CHECK(value("\"\"") == "string \"\"");
}
