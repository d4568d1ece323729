#include "grammar/lexemes.hpp"

#include <cstring>

#include "catch.hpp"

using namespace lancer::grammar;

namespace {

std::string number_of(const std::string& text) {
  return {text.data(), scan_number(text.data(), text.data() + text.size())};
}

std::string behind_blank(const std::string& text) {
  const char* unclosed = nullptr;
  const char* at = skip_blank(text.data(), text.data() + text.size(), &unclosed);
  return unclosed != nullptr ? "unclosed" : std::string(at, text.data() + text.size());
}

}  // namespace

TEST_CASE("a number reaches as far as its spelling, and not into a range", "[lexemes]") {
  CHECK(number_of("12+3") == "12");
  CHECK(number_of(".5,") == ".5");
  CHECK(number_of("2.5e-3 x") == "2.5e-3");
  CHECK(number_of("1_000_000}") == "1_000_000");
  CHECK(number_of("0..10") == "0");
  CHECK(number_of("1.5..3") == "1.5");
  CHECK(number_of("3x4") == "3x4");
  CHECK(number_of("1e5-2") == "1e5");
  CHECK(number_of("..3").empty());
  CHECK(number_of("x1").empty());
}

TEST_CASE("a malformed number is told from a good one", "[lexemes]") {
  for (const char* good : {"1", ".5", "2.5e-3", "1_000_000", "1E9", "0.000_1", "1e1_0"}) {
    CAPTURE(good);
    CHECK(number_problem(good) == nullptr);
  }
  for (const char* bad : {"1_", "1__0", "1.", "1._5", "1e", "1e+", "2x", "0x10", "1.5.2", "1e5_"}) {
    CAPTURE(bad);
    CHECK(number_problem(bad) != nullptr);
  }
}

TEST_CASE("comments nest, and white space and comments are skipped together", "[lexemes]") {
  CHECK(behind_blank(" \t\r\n// a\n /* b /* c */ d */ x") == "x");
  CHECK(behind_blank("/* a */") == "");
  CHECK(behind_blank("/* a /* b */") == "unclosed");
  CHECK(behind_blank("// no line end") == "");
  CHECK(behind_blank("/ 2") == "/ 2");
}

TEST_CASE("escapes are decoded, unknown ones and impossible code points are not", "[lexemes]") {
  CHECK(decode_escape("\\n") == "\n");
  CHECK(decode_escape("\\{") == "{");
  CHECK(decode_escape("\\u{41}") == "A");
  CHECK(decode_escape("\\u{1F600}") == "\xF0\x9F\x98\x80");
  CHECK(decode_escape("\\u{e9}") == "\xC3\xA9");
  for (const char* bad :
       {"\\q", "\\u{}", "\\u{D800}", "\\u{110000}", "\\u{12", "\\u41", "\\u{xyz}", "\\u{0000041}"}) {
    CAPTURE(bad);
    CHECK_FALSE(decode_escape(bad));
  }
}

TEST_CASE("invalid bytes and control characters are found at their places", "[lexemes]") {
  CHECK(check_text("a\tb\r\nc\n\xC3\xA9 \xF0\x9F\x98\x80", 0).empty());
  const auto places = [](const std::string& text) {
    std::vector<std::uint32_t> out;
    for (const auto& d : check_text(text, 0)) out.push_back(d.span.begin);
    return out;
  };
  using Places = std::vector<std::uint32_t>;
  CHECK(places("a\xFF"
               "b") == Places{1});
  CHECK(places("\xC0\xAF") == Places{0, 1});          // an overlong `/`
  CHECK(places("x\xED\xA0\x80") == Places{1, 2, 3});  // a surrogate
  CHECK(places("\xF4\x90\x80\x80").size() == 4);      // beyond 10FFFF
  CHECK(places("a\rb") == Places{1});
  CHECK(places(std::string("a\0b", 3)) == Places{1});
  CHECK(places("\x7F") == Places{0});
  CHECK(places("\xC2\x85") == Places{0});
}

TEST_CASE("after a mistake the search for the next statement follows brackets to their ends", "[recover]") {
  const auto next = [](const std::string& text, std::size_t failed) {
    return std::string(next_statement(text, text.data(), text.data() + failed));
  };
  CHECK(next("let a = ) 3\nb", 8) == "b");
  CHECK(next("f(1 2,\n 3)\ng", 4) == "g");
  CHECK(next("sphere { <0 1>\n radius 2 }\nnext", 12) == "next");
  CHECK(next("f(1 2; 3); g", 4) == " g");
  CHECK(next("f(\"a } {b} \" 2)\ng", 13) == "g");
  CHECK(next("group { a b(\nlet c = 1", 12) == "let c = 1");
  CHECK(next("x ) }", 2) == "}");
}
