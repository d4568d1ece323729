#include "grammar/foreign.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

#include "grammar/failure.hpp"
#include "lang/keywords.hpp"

namespace lancer::grammar {
namespace {

/// Whether a word of other languages stands before a name on its line, with `=` or `(` behind that.
bool declares_elsewhere(std::string_view word, const char* name, const char* end) {
  constexpr std::array<std::string_view, 7> k_words = {"var",      "const", "local", "macro",
                                                       "function", "def",   "module"};
  if (std::find(k_words.begin(), k_words.end(), word) == k_words.end()) return false;
  const std::string_view declared = word_at(name, end);
  if (declared.empty() || lang::is_reserved(declared)) return false;
  if (std::find(word.data() + word.size(), name, '\n') != name) return false;
  const char* next = behind_blank(name + declared.size(), end);
  const std::string_view rest(next, static_cast<std::size_t>(end - next));
  return rest.starts_with('(') || (rest.starts_with('=') && !rest.starts_with("=="));
}

}  // namespace

std::string_view sign_help(std::string_view token) {
  using Pair = std::pair<std::string_view, std::string_view>;
  constexpr std::array k_help = {
      Pair{"&&", "`&&` is `and`"}, Pair{"&", "`&` is `and`"},
      Pair{"||", "`||` is `or`"},  Pair{"|", "`|` is `or`"},
      Pair{"!", "`!` is `not`"},   Pair{"=>", "`=>` is `->`: fn (a) -> a + 1"},
      Pair{"**", "`**` is `^`"},   Pair{"'", "strings stand in double quotes"},
  };
  for (const auto& [sign, help] : k_help) {
    if (sign == token) return help;
  }
  return {};
}

bool is_foreign_color(const Builder& b, const char* at) {
  const std::string_view before = b.text().substr(0, b.last_end);
  return *at == '<' && (before.ends_with("rgb") || before.ends_with("rgbf") || before.ends_with("rgbt") ||
                        before.ends_with("color"));
}

void fail_unknown_kind(Builder& b, std::uint32_t begin, std::uint32_t end) {
  const std::string_view word = b.text().substr(begin, end - begin);
  std::vector<std::string_view> kinds;
  for (const auto& kind : lang::all_kinds()) kinds.push_back(kind.id);
  const std::string_view near = nearest(word, kinds);
  const std::string_view hint = lang::foreign_hint(word);
  std::string help = !hint.empty()   ? std::string(hint)
                     : !near.empty() ? fmt::format("did you mean `{}`?", near)
                                     : std::string(
                                           "the kinds are sphere, plane, cube, box, facet, mesh, group, "
                                           "light, sun, spot, view, material and settings");
  throw SyntaxError{error(hint.empty() ? Code::syntax : Code::foreign_word, b.span(begin, end),
                          fmt::format("`{}` is no kind of object", word), std::move(help))};
}

void fail_if_directive(Builder& b, const char* begin, const char* end) {
  const std::string_view word(begin + 1, static_cast<std::size_t>(end - begin - 1));
  constexpr std::array<std::string_view, 17> k_directives = {
      "declare", "local",  "macro", "include", "if",     "else",    "elseif",  "end",  "while",
      "for",     "switch", "case",  "ifdef",   "ifndef", "version", "default", "debug"};
  if (std::find(k_directives.begin(), k_directives.end(), word) == k_directives.end()) return;
  std::string_view help = lang::foreign_hint(word);
  if (word == "include") help = "write include \"file.scn\", without `#`";
  if (word == "if" || word == "while" || word == "for" || word == "else")
    help = "write it without `#`, with a block in braces";
  const std::uint32_t at = b.offset(begin);
  throw SyntaxError{error(Code::foreign_word, b.span(at, b.offset(end)),
                          fmt::format("`#{}` is a directive of POV-Ray's language", word),
                          std::string(help))};
}

void fail_if_foreign_statement(Builder& b, const char* at, const char* end) {
  const std::string_view word = word_at(at, end);
  if (word.empty()) return;
  const std::uint32_t begin = b.offset(at);
  const Span word_span = b.span(begin, begin + static_cast<std::uint32_t>(word.size()));
  if (word == "else")
    throw SyntaxError{error(Code::misplaced, word_span, "`else` follows the `}` of an `if`")};
  if (lang::is_reserved(word)) return;
  const char* next = behind_blank(at + word.size(), end);
  if (next != end && *next == '{') fail_unknown_kind(b, begin, word_span.end);
  if (declares_elsewhere(word, next, end)) {
    throw SyntaxError{error(Code::foreign_word, word_span, fmt::format("`{}` is no keyword", word),
                            std::string(lang::foreign_hint(word)))};
  }
  const std::string_view rest(next, static_cast<std::size_t>(end - next));
  for (std::string_view sign : {"+=", "-=", "*=", "/=", "++", "--"}) {
    if (!rest.starts_with(sign) || (sign[0] == sign[1] && word_at(next + 2, end) != "")) continue;
    const std::uint32_t place = b.offset(next);
    throw SyntaxError{
        error(Code::foreign_word, b.span(place, place + 2), fmt::format("there is no `{}`", sign),
              fmt::format("write `{0} = {0} {1} {2}`", word, sign[0], sign[1] == '=' ? ".." : "1"))};
  }
}

void fail_if_foreign_color(const Builder& b, const char* at, const char* end) {
  if (at == end || *at != '<' || !is_foreign_color(b, at)) return;
  constexpr std::ptrdiff_t k_farthest = 500;
  end = std::min(end - at, k_farthest) + at;
  int depth = 0;
  int commas = 0;
  for (const char* c = at + 1; c != end && depth >= 0 && *c != '{' && *c != '}' && *c != ';' && *c != '"';
       ++c) {
    if (*c == '(' || *c == '[') ++depth;
    if (*c == ')' || *c == ']') --depth;
    if (*c == ',' && depth == 0) ++commas;
    if (*c != '>' || depth != 0) continue;
    if (commas < 2) return;
    throw SyntaxError{error(Code::foreign_word, token_span(b, at), "expected `(`, found `<`",
                            "`rgb <1, 0, 0>` is `rgb(1, 0, 0)`")};
  }
}

}  // namespace lancer::grammar
