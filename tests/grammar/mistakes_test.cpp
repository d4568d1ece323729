// Mistakes of syntax: one message each, at its place, and the rest of the text is still understood.

#include <string>
#include <vector>

#include "catch.hpp"
#include "grammar/parse.hpp"

using namespace lancer;

namespace {

struct Outcome {
  std::vector<std::string> messages;  // "line:column E001 text"
  std::size_t statements;
  bool incomplete;
};

Outcome parse(const std::string& text) {
  SourceMap sources;
  const std::uint32_t file = sources.add("test.scn", text);
  const grammar::Parsed parsed = grammar::parse(sources, file);
  Outcome out{{}, parsed.script.statements.size(), parsed.incomplete};
  for (const Diagnostic& d : parsed.diagnostics) {
    const Position at = sources[file].position(d.span.begin);
    out.messages.push_back(std::to_string(at.line) + ":" + std::to_string(at.column) + " " +
                           code_name(d.code) + " " + d.message);
  }
  return out;
}

using Messages = std::vector<std::string>;

}  // namespace

TEST_CASE("all syntax errors of a text are told at once, and good statements between them are kept",
          "[mistakes]") {
  const Outcome out = parse("let a = \nlet b = 2\nsphere { <0, 1 2>, 1 }\nprint(b)\nlet 3 = 4\nprint(1 2)\n");
  CHECK(out.messages == Messages{"1:8 E001 expected a value, found `let`",
                                 "3:16 E001 expected `>`, found `2`",
                                 "5:5 E001 expected a name for the variable, found `3`",
                                 "6:9 E001 expected `,` or `)`, found `2`"});
  CHECK(out.statements == 2);
}

TEST_CASE("what is missing at the end of a line is told behind the last token", "[mistakes]") {
  CHECK(parse("let a =\nlet b = 2").messages == Messages{"1:8 E001 expected a value, found `let`"});
}

TEST_CASE("an open bracket is told at the bracket, by what cannot stand within it", "[mistakes]") {
  CHECK(parse("sphere { <0, 0, 0>, 1\nlight { at <1, 2, 3> }").messages ==
        Messages{"1:8 E009 this `{` is never closed"});
  CHECK(parse("print((1 + 2)\nlet x = 3\n").messages == Messages{"1:6 E009 this `(` is never closed"});
  CHECK(parse("let a = [1, 2\n").messages == Messages{"1:9 E009 this `[` is never closed"});
  CHECK(parse("group {\n  sphere { <0, 0, 0>, 1 }\n").messages ==
        Messages{"1:7 E009 this `{` is never closed"});
  CHECK(parse("x = 3 }\nprint(2)").messages == Messages{"1:7 E009 this `}` closes nothing"});
}

TEST_CASE("a missing closer is one mistake, not two", "[mistakes]") {
  const Outcome out = parse("fn f() {\n  sphere { <0, 0, 0>, 1\n  let a = 1\n}\nprint(2)\n");
  CHECK(out.messages == Messages{"2:10 E009 this `{` is never closed"});
  CHECK(out.statements == 2);
}

TEST_CASE("text that ends too early asks for more, other mistakes do not", "[mistakes]") {
  for (const char* text :
       {"sphere {", "let a =", "f(1,", "fn f(a)", "if a {", "let a = 1 +", "/* a", "for i in", "<1,"}) {
    CAPTURE(text);
    CHECK(parse(text).incomplete);
  }
  for (const char* text : {"", "let a = 1", "let a = )", "print(\"abc", "sphere { } }"}) {
    CAPTURE(text);
    CHECK_FALSE(parse(text).incomplete);
  }
}

TEST_CASE("nesting is capped: a million parentheses are an error and not a crash", "[mistakes]") {
  const std::string deep = "blocks and expressions are nested more than 1,000 deep";
  const auto repeat = [](const std::string& piece, int count) {
    std::string out;
    for (int i = 0; i < count; ++i) out += piece;
    return out;
  };
  for (const char* piece : {"(", "[", "-", "a ^ ", "<", "{", "fn a() {", "sphere {", "group {", "material {",
                            "a ? ", "not ", "\"{", "if a {", "f("}) {
    CAPTURE(piece);
    const Outcome out =
        parse("x = " + repeat(piece, 1'000'000 / static_cast<int>(std::string(piece).size())));
    REQUIRE_FALSE(out.messages.empty());
    CHECK(out.messages.size() <= 2);
  }
  CHECK_THAT(parse("x = " + repeat("(", 1'000'000)).messages.at(0), ContainsSubstring(deep));
  CHECK(parse("x = " + repeat("(", 990) + "1" + repeat(")", 990)).messages.empty());
  CHECK(parse(repeat("group {", 990) + repeat("}", 990)).messages.empty());
  CHECK(parse("x = 1" + repeat(" + 1", 300'000)).messages.empty());
  CHECK(parse(repeat("if a { } else ", 100'000) + "{ }").messages.empty());
}

TEST_CASE("many mistakes take linear time", "[mistakes]") {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += "let = 3\n";
  const Messages messages = parse(text).messages;
  CHECK(messages.size() >= 1000);
  // The last one kept says as much as the others.
  CHECK(messages.back() == "1000:5 E001 expected a name for the variable, found `=`");
}

TEST_CASE("habits from other languages are answered with this language's word", "[mistakes]") {
  CHECK(parse("union { sphere { <0, 0, 0>, 1 } }").messages ==
        Messages{"1:1 E048 `union` is no kind of object"});
  CHECK(parse("#declare R = 3;").messages ==
        Messages{"1:1 E048 `#declare` is a directive of POV-Ray's language"});
  CHECK(parse("n += 1").messages == Messages{"1:3 E048 there is no `+=`"});
  CHECK(parse("if a && b { }").messages == Messages{"1:6 E048 expected `{`, found `&&`"});
  CHECK(parse("sphere { <0, 0, 0>, 1  material { diffuse rgb <1, 0, 0> } }").messages ==
        Messages{"1:47 E048 expected `,`, an attribute or `}`, found `<`"});
}

TEST_CASE("misplaced words are told at the word", "[mistakes]") {
  CHECK(parse("return 3").messages == Messages{"1:1 E011 `return` stands in a function"});
  CHECK(parse("fn f() { break }").messages == Messages{"1:10 E011 `break` stands in a loop"});
  CHECK(parse("while true { fn f() { continue } }").messages ==
        Messages{"1:23 E011 `continue` stands in a loop"});
  CHECK(parse("while true { fn f() = group { break } }").messages ==
        Messages{"1:31 E011 `break` stands in a loop"});
  CHECK(parse("while true { group { break } }").messages.empty());
  CHECK(parse("group { include \"a.scn\" }").messages ==
        Messages{"1:9 E011 `include` stands at the top level of a file"});
  CHECK(parse("if true { settings { depth 3 } }").messages ==
        Messages{"1:11 E011 `settings` stands at the top level of a file"});
  CHECK(parse("else { }").messages == Messages{"1:1 E011 `else` follows the `}` of an `if`"});
}

TEST_CASE("comparisons and ranges do not chain", "[mistakes]") {
  CHECK(parse("print(a < b < c)").messages == Messages{"1:7 E027 comparisons do not chain"});
  CHECK(parse("print(1..2..3)").messages == Messages{"1:7 E027 ranges do not chain"});
}
