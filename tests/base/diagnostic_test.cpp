// Messages as people read them, as whole texts.

#include "base/diagnostic.hpp"

#include <algorithm>

#include "catch.hpp"

namespace lancer {
namespace {

/// The span of the first `marked` in the text.
Span find(const SourceMap& sources, std::string_view marked, std::uint32_t file = 0) {
  const std::size_t at = sources[file].text().find(marked);
  REQUIRE(at != std::string::npos);
  return {file, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + marked.size())};
}

SourceMap one(std::string text) {
  SourceMap sources;
  sources.add("lamp.scn", std::move(text));
  return sources;
}

/// The line of carets of a message about `marked`.
std::string carets(const SourceMap& sources, Span span) {
  const std::string text = to_text(error(Code::syntax, span, "m"), sources);
  const std::size_t end = text.size() - 1;
  return text.substr(text.rfind('\n', end - 1) + 1);
}

std::string lines(int count) {
  std::string out;
  for (int i = 0; i < count; ++i) out += "\n";
  return out;
}

}  // namespace

TEST_CASE("diagnostic: the layout", "[diagnostic]") {
  const SourceMap sources = one(lines(11) + "  sphere { center <0,1,0> radius -1 }\n");
  const Diagnostic d = error(Code::not_positive, find(sources, "-1"),
                             "a sphere's radius is positive; this one is -1", "leave the minus out");
  CHECK(to_text(d, sources) ==
        "lamp.scn:12:34: error[E013]: a sphere's radius is positive; this one is -1\n"
        "   |\n"
        "12 |   sphere { center <0,1,0> radius -1 }\n"
        "   |                                  ^^\n"
        "   = help: leave the minus out\n");
}

TEST_CASE("diagnostic: warnings, notes and messages without a code", "[diagnostic]") {
  const SourceMap sources = one("let a = 1");
  CHECK(to_text(warning(Code::unused, find(sources, "a"), "nothing uses `a`"), sources) ==
        "lamp.scn:1:5: warning[W101]: nothing uses `a`\n"
        "  |\n"
        "1 | let a = 1\n"
        "  |     ^\n");
  Diagnostic note = error(Code::none, find(sources, "1"), "a number");
  note.severity = Severity::note;
  CHECK(to_text(note, sources) ==
        "lamp.scn:1:9: note: a number\n"
        "  |\n"
        "1 | let a = 1\n"
        "  |         ^\n");
}

TEST_CASE("diagnostic: names of codes", "[diagnostic]") {
  CHECK(code_name(Code::none).empty());
  CHECK(code_name(Code::syntax) == "E001");
  CHECK(code_name(Code::foreign_word) == "E048");
  CHECK(code_name(Code::unused) == "W101");
}

TEST_CASE("diagnostic: carets stand below what they mark", "[diagnostic]") {
  // Columns are code points: two letters of two and three bytes stand before the mark. Tabs are kept.
  const SourceMap sources = one("\tlet \xC3\xA9\xE2\x82\xAC = bad\n");
  const Diagnostic d = error(Code::unknown_name, find(sources, "bad"), "m");
  CHECK(to_text(d, sources) ==
        "lamp.scn:1:11: error[E020]: m\n"
        "  |\n"
        "1 | \tlet \xC3\xA9\xE2\x82\xAC = bad\n"
        "  | \t         ^^^\n");
}

TEST_CASE("diagnostic: a mark over several lines goes to the end of the first", "[diagnostic]") {
  const SourceMap sources = one("let a = [1,\n  2,\n  3]\n");
  CHECK(carets(sources, find(sources, "[1,\n  2,\n  3]")) == "  |         ^^^\n");
  CHECK(carets(sources, find(sources, "\n  2")) == "  |            ^\n");
}

TEST_CASE("diagnostic: the end of the file can be marked", "[diagnostic]") {
  const SourceMap sources = one("let a =");
  CHECK(to_text(error(Code::syntax, {0, 7, 7}, "a value is missing"), sources) ==
        "lamp.scn:1:8: error[E001]: a value is missing\n"
        "  |\n"
        "1 | let a =\n"
        "  |        ^\n");
  const SourceMap ended = one("let a =\n");
  CHECK(to_text(error(Code::syntax, {0, 8, 8}, "a value is missing"), ended) ==
        "lamp.scn:2:1: error[E001]: a value is missing\n"
        "  |\n"
        "2 |\n"
        "  | ^\n");
  const SourceMap empty = one("");
  CHECK(carets(empty, {0, 0, 0}) == "  | ^\n");
}

TEST_CASE("diagnostic: carriage returns and byte order marks are not shown", "[diagnostic]") {
  const SourceMap sources = one("\xEF\xBB\xBFlet a = bad\r\nlet b = 1\r\n");
  CHECK(to_text(error(Code::unknown_name, find(sources, "bad"), "m"), sources) ==
        "lamp.scn:1:9: error[E020]: m\n"
        "  |\n"
        "1 | let a = bad\n"
        "  |         ^^^\n");
}

TEST_CASE("diagnostic: what would disturb a terminal is not shown as it is", "[diagnostic]") {
  const SourceMap sources = one("a \x1B[2J \xFF b");
  CHECK(to_text(error(Code::bad_text, find(sources, "\xFF"), "bad \x1B byte"), sources) ==
        "lamp.scn:1:8: error[E002]: bad \xEF\xBF\xBD byte\n"
        "  |\n"
        "1 | a \xEF\xBF\xBD[2J \xEF\xBF\xBD b\n"
        "  |        ^\n");
}

TEST_CASE("diagnostic: messages of several lines are indented", "[diagnostic]") {
  const SourceMap sources = one("let a = 1");
  CHECK(to_text(error(Code::failed_assert, find(sources, "1"), "one\ntwo", "three\nfour"), sources) ==
        "lamp.scn:1:9: error[E035]: one\n"
        "     two\n"
        "  |\n"
        "1 | let a = 1\n"
        "  |         ^\n"
        "  = help: three\n"
        "     four\n");
}

TEST_CASE("diagnostic: long lines are cut to a window around the mark", "[diagnostic]") {
  const SourceMap late = one(std::string(500, 'a') + " bad " + std::string(500, 'b'));
  CHECK(to_text(error(Code::unknown_name, find(late, "bad"), "m"), late) ==
        "lamp.scn:1:502: error[E020]: m\n"
        "  |\n"
        "1 | ..." +
            std::string(39, 'a') + " bad " + std::string(76, 'b') +
            "...\n"
            "  |    " +
            std::string(40, ' ') + "^^^\n");
  const SourceMap early = one("bad " + std::string(500, 'b'));
  CHECK(to_text(error(Code::unknown_name, find(early, "bad"), "m"), early) ==
        "lamp.scn:1:1: error[E020]: m\n"
        "  |\n"
        "1 | bad " +
            std::string(116, 'b') +
            "...\n"
            "  | ^^^\n");
  const SourceMap wide = one(std::string(130, 'a'));
  CHECK(carets(wide, {0, 0, 130}) == "  | " + std::string(120, '^') + "\n");
}

TEST_CASE("diagnostic: labels show a second place", "[diagnostic]") {
  SourceMap sources = one("let gold = 1\n" + lines(8) + "let gold = 2\n");
  sources.add("other.scn", "\nlet gold = 3\n");
  Diagnostic d = error(Code::declared_twice, find(sources, "gold = 2"), "`gold` is declared twice");
  d.span.end = d.span.begin + 4;
  d.labels.push_back({{0, 4, 8}, "first declared here"});
  d.labels.push_back({find(sources, "gold", 1), "and here"});
  CHECK(to_text(d, sources) ==
        "lamp.scn:10:5: error[E025]: `gold` is declared twice\n"
        "   |\n"
        "10 | let gold = 2\n"
        "   |     ^^^^\n"
        "lamp.scn:1:5: note: first declared here\n"
        "   |\n"
        " 1 | let gold = 1\n"
        "   |     ^^^^\n"
        "other.scn:2:5: note: and here\n"
        "   |\n"
        " 2 | let gold = 3\n"
        "   |     ^^^^\n");
}

TEST_CASE("diagnostic: calls are listed, innermost first", "[diagnostic]") {
  const SourceMap sources = one(lines(13) + "ring(3)\n");
  Diagnostic d = error(Code::not_finite, find(sources, "3"), "m", "h");
  d.trace.push_back({find(sources, "ring(3)"), "call of `ring`"});
  CHECK(to_text(d, sources) ==
        "lamp.scn:14:6: error[E031]: m\n"
        "   |\n"
        "14 | ring(3)\n"
        "   |      ^\n"
        "   = help: h\n"
        "   = in: call of `ring` at lamp.scn:14:1\n");
}

TEST_CASE("diagnostic: of many calls the first and last few", "[diagnostic]") {
  const SourceMap sources = one("f(1)");
  Diagnostic d = error(Code::call_limit, {0, 0, 4}, "m");
  for (int i = 0; i < 1000; ++i) d.trace.push_back({{0, 0, 4}, "call " + std::to_string(i)});
  CHECK(to_text(d, sources) ==
        "lamp.scn:1:1: error[E045]: m\n"
        "  |\n"
        "1 | f(1)\n"
        "  | ^^^^\n"
        "  = in: call 0 at lamp.scn:1:1\n"
        "  = in: call 1 at lamp.scn:1:1\n"
        "  = in: call 2 at lamp.scn:1:1\n"
        "  = in: call 3 at lamp.scn:1:1\n"
        "  = in: ... 992 more calls\n"
        "  = in: call 996 at lamp.scn:1:1\n"
        "  = in: call 997 at lamp.scn:1:1\n"
        "  = in: call 998 at lamp.scn:1:1\n"
        "  = in: call 999 at lamp.scn:1:1\n");
  d.trace.resize(9);
  CHECK(to_text(d, sources).find("more") == std::string::npos);
}

TEST_CASE("diagnostic: colours only when asked for", "[diagnostic]") {
  const SourceMap sources = one("let a = 1");
  const Diagnostic d = error(Code::syntax, find(sources, "a"), "m", "h");
  const std::string colored = to_text(d, sources, true);
  CHECK(colored.find("\x1b[1;31merror[E001]:\x1b[0m") != std::string::npos);
  CHECK(colored.find("^\x1b[0m") != std::string::npos);
  std::string plain;
  for (std::size_t i = 0; i < colored.size(); ++i) {
    if (colored[i] == '\x1b') {
      i = colored.find('m', i);
    } else {
      plain += colored[i];
    }
  }
  CHECK(plain == to_text(d, sources));
}

TEST_CASE("diagnostic: several are sorted by file and place, equals as they came", "[diagnostic]") {
  SourceMap sources = one("a b");
  sources.add("z.scn", "c");
  std::vector<Diagnostic> all{
      error(Code::syntax, {1, 0, 1}, "fourth"), error(Code::syntax, {0, 2, 3}, "second"),
      warning(Code::unused, {0, 2, 3}, "third"), error(Code::syntax, {0, 0, 1}, "first")};
  const std::string text = to_text(all, sources);
  CHECK(text ==
        "lamp.scn:1:1: error[E001]: first\n  |\n1 | a b\n  | ^\n"
        "\n"
        "lamp.scn:1:3: error[E001]: second\n  |\n1 | a b\n  |   ^\n"
        "\n"
        "lamp.scn:1:3: warning[W101]: third\n  |\n1 | a b\n  |   ^\n"
        "\n"
        "z.scn:1:1: error[E001]: fourth\n  |\n1 | c\n  | ^\n");
}

TEST_CASE("diagnostic: at most 20 errors, then a count", "[diagnostic]") {
  const SourceMap sources = one("a");
  std::vector<Diagnostic> all(20, error(Code::syntax, {0, 0, 1}, "m"));
  CHECK(to_text(all, sources).find("more") == std::string::npos);
  all.push_back(error(Code::syntax, {0, 0, 1}, "m"));
  all.push_back(warning(Code::unused, {0, 0, 1}, "w"));
  const std::string text = to_text(all, sources);
  CHECK(text.substr(text.rfind("lamp.scn")) ==
        "lamp.scn:1:1: warning[W101]: w\n  |\n1 | a\n  | ^\n\n... and 1 more error\n");
  all.push_back(error(Code::syntax, {0, 0, 1}, "m"));
  const std::string two = to_text(all, sources);
  CHECK(two.substr(two.rfind("...")) == "... and 2 more errors\n");
  CHECK(std::count(two.begin(), two.end(), '^') == 21);
}

TEST_CASE("diagnostic: a message without a place", "[diagnostic]") {
  CHECK(to_text(error(Code::include_missing, {}, "m"), SourceMap{}) == "error[E040]: m\n");
}

TEST_CASE("diagnostic: errors among others", "[diagnostic]") {
  CHECK_FALSE(has_errors({}));
  CHECK_FALSE(has_errors({warning(Code::unused, {}, "w")}));
  CHECK(has_errors({warning(Code::unused, {}, "w"), error(Code::syntax, {}, "e")}));
}

}  // namespace lancer
