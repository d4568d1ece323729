#include "grammar/failure.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>

#include "grammar/foreign.hpp"
#include "grammar/lexemes.hpp"
#include "lang/keywords.hpp"

namespace lancer::grammar {
namespace {

constexpr std::size_t k_most_errors = 1000;

const char* end_of(const Builder& b) { return b.text().data() + b.text().size(); }

/// The token at `at`, as far as a message shows it.
std::string_view token_at(const Builder& b, const char* at) {
  const char* end = end_of(b);
  if (const std::string_view word = word_at(at, end); !word.empty()) return word;
  const char* number = scan_number(at, end);
  if (number != at) return {at, static_cast<std::size_t>(number - at)};
  if (*at == '"') return {at, 1};
  if (*at == '#') return {at, static_cast<std::size_t>(scan_color(at, end) - at)};
  constexpr std::array<std::string_view, 14> k_long = {
      "..=", "&&", "||", "==", "!=", "<=", ">=", "->", "=>", "++", "--", "+=", "-=", "**"};
  const std::string_view rest(at, static_cast<std::size_t>(end - at));
  for (std::string_view sign : k_long) {
    if (rest.starts_with(sign)) return sign;
  }
  std::size_t length = 1;
  while (length < rest.size() && (static_cast<unsigned char>(rest[length]) & 0xC0) == 0x80) ++length;
  return rest.substr(0, length);
}

std::string found(const Builder& b, const char* at) {
  if (at == end_of(b)) return "the end of the file";
  if (*at == '"') return "a string";
  return fmt::format("`{}`", token_at(b, at));
}

/// Before a token on a later line, the message points behind the last one: there something is missing.
Span place_of(const Builder& b, const char* at) {
  const std::string_view between = b.text().substr(b.last_end, b.offset(at) - b.last_end);
  if (b.last_end > 0 && (at == end_of(b) || between.find('\n') != std::string_view::npos))
    return b.span(b.last_end, b.last_end);
  return token_span(b, at);
}

bool is_comparison(std::string_view token) {
  return token == "<" || token == ">" || token == "<=" || token == ">=" || token == "==" || token == "!=";
}

/// Directly within a vector or an object's block, where a comparison needs parentheses.
bool in_closed_place(const Builder& b) {
  if (b.brackets.empty()) return false;
  const char opener = b.text()[b.brackets.back()];
  return opener == '<' || (opener == '{' && !b.kinds.empty());
}

/// A variable that bears an attribute's name, where an attribute begins.
bool is_shadowed_variable(const Builder& b, const char* at, Expectation expectation) {
  const bool ends =
      *at == ',' || *at == '}' || *at == '.' || *at == '+' || *at == '-' || *at == '*' || *at == '/';
  return expectation.is_value() && ends && !b.kinds.empty() &&
         lang::find_attribute(b.kinds.back(), b.last_word()) != nullptr;
}

/// `center <0, 0, 0>, radius 1`: behind the comma the attribute's name was taken for a value.
bool is_separated_attribute(const Builder& b, Expectation expectation) {
  if (!expectation.is_closer() || b.kinds.empty() || b.brackets.empty() || b.text()[b.brackets.back()] != '{')
    return false;
  const std::string_view word = b.last_word();
  if (word.empty() || lang::find_attribute(b.kinds.back(), word) == nullptr) return false;
  const std::string_view before = b.text().substr(0, b.last_end - static_cast<std::uint32_t>(word.size()));
  const std::size_t sign = before.find_last_not_of(" \t\r\n");
  return sign != std::string_view::npos && before[sign] == ',';
}

/// Advice for what was found, or nothing.
std::string help_for(const Builder& b, const char* at, Expectation expectation) {
  if (at == end_of(b)) return {};
  const std::string_view token = token_at(b, at);
  if (const std::string_view help = sign_help(token); !help.empty()) return std::string(help);
  if (is_shadowed_variable(b, at, expectation)) {
    return fmt::format("here `{0}` is the attribute; a variable of that name is `{0} {0}` or `({0})`",
                       b.last_word());
  }
  if (is_separated_attribute(b, expectation))
    return fmt::format("no comma stands before an attribute: `{}` was read as a value here", b.last_word());
  if (expectation.role == Expectation::Role::loop_name)
    return "a loop is `for i in 0..10 { .. }`, without parentheses";
  if (is_foreign_color(b, at)) return "`rgb <1, 0, 0>` is `rgb(1, 0, 0)`";
  if (static_cast<unsigned char>(*at) >= 0x80) return "letters outside ASCII belong in strings and comments";
  if (in_closed_place(b) && is_comparison(token))
    return "in a vector or block a comparison stands in parentheses: `(a < b)`";
  if (token == "=" && !expectation.is_value()) {
    return b.kinds.empty() ? "equality is `==`" : "an attribute's value follows without `=`: `radius 1`";
  }
  if (token == "," && expectation.role == Expectation::Role::vector_end)
    return "a vector has 2 or 3 components";
  if (token == ":") return b.kinds.empty() ? "" : "an attribute's value follows without `:`: `radius 1`";
  return std::string(lang::foreign_hint(token));
}

Code code_for(const Builder& b, const char* at) {
  if (at == end_of(b)) return Code::syntax;
  if (is_foreign_color(b, at)) return Code::foreign_word;
  if (static_cast<unsigned char>(*at) >= 0x80) return Code::bad_text;
  const std::string_view token = token_at(b, at);
  return sign_help(token).empty() && lang::foreign_hint(token).empty() ? Code::syntax : Code::foreign_word;
}

char closer_of(char opener) { return opener == '(' ? ')' : opener == '[' ? ']' : opener == '<' ? '>' : '}'; }

/// Whether what was found can only mean that the innermost bracket was left open.
bool is_unclosed(const Builder& b, const char* at, Expectation expectation) {
  if (b.brackets.empty()) return false;
  if (at == end_of(b)) return true;
  const char opener = b.text()[b.brackets.back()];
  if (opener == '"') return false;
  if ((*at == ')' || *at == ']' || *at == '}') && *at != closer_of(opener)) return expectation.is_closer();
  if (!expectation.is_closer()) return false;
  const char* line = at;
  while (line != b.text().data() && (line[-1] == ' ' || line[-1] == '\t')) --line;
  const bool first_on_line = line == b.text().data() || line[-1] == '\n';
  return first_on_line && begins_statement(token_at(b, at));
}

[[noreturn]] void fail_unclosed(Builder& b, const char* at) {
  const std::uint32_t opener = b.brackets.back();
  const char sign = b.text()[opener];
  const bool at_end = at == end_of(b);
  SyntaxError out{error(Code::unclosed_bracket, b.span(opener, opener + 1),
                        fmt::format("this `{}` is never closed", sign),
                        at_end ? fmt::format("a `{}` is missing before the end of the file", closer_of(sign))
                               : fmt::format("a `{}` is missing before {}", closer_of(sign), found(b, at)))};
  if (!at_end) {
    const Span place = token_span(b, at);
    out.diagnostic.labels.push_back({place, fmt::format("expected `{}` before this", closer_of(sign))});
  }
  out.resume_here = true;
  out.last = at_end;
  b.incomplete = at_end;
  throw out;
}

/// The quote of a string around this place that does not end on its own line; nothing where there is none.
std::optional<std::uint32_t> broken_string(const Builder& b, const char* at) {
  for (auto bracket = b.brackets.rbegin(); bracket != b.brackets.rend(); ++bracket) {
    if (b.text()[*bracket] != '"') continue;
    const std::string_view since = b.text().substr(*bracket, b.offset(at) - *bracket);
    if (at == end_of(b) || *at == '\n' || since.find('\n') != std::string_view::npos) return *bracket;
  }
  return std::nullopt;
}

/// Where the `}` of an interpolation should stand, the quote that was to end the string.
bool is_open_interpolation(const Builder& b, const char* at, Expectation expectation) {
  if (at == end_of(b) || *at != '"' || !expectation.is_closer() || b.brackets.size() < 2) return false;
  return b.text()[b.brackets.back()] == '{' && b.text()[b.brackets[b.brackets.size() - 2]] == '"';
}

[[noreturn]] void fail_interpolation(Builder& b) {
  const std::uint32_t brace = b.brackets.back();
  throw SyntaxError{error(Code::unclosed_bracket, b.span(brace, brace + 1), "this `{` is never closed",
                          "the value within a string ends with `}`; a brace that is text is `\\{`")};
}

[[noreturn]] void fail_string(Builder& b, std::uint32_t quote) {
  throw SyntaxError{error(Code::unclosed_string, b.span(quote, quote + 1), "this string is never closed",
                          "a string ends with `\"` on its own line; write \\n for a line break")};
}

void check_reserved(const Builder& b, const char* at, Expectation expectation) {
  const std::string_view word = word_at(at, end_of(b));
  if (!expectation.is_name() || word.empty()) return;
  throw SyntaxError{error(Code::reserved_word, token_span(b, at),
                          fmt::format("`{}` is a reserved word and cannot be a name", word),
                          fmt::format("choose another name, such as `my_{}` or `{}_1`", word, word))};
}

/// `a[0] = 1`, `v.x = 1`, `f(a) = a`: an `=` behind an expression that is no variable.
void check_assigned(const Builder& b, const char* at, Expectation expectation) {
  const bool is_assignment =
      at != end_of(b) && *at == '=' && expectation.role == Expectation::Role::statement;
  if (!is_assignment || b.stmts.empty() || b.stmts.back()->kind != ast::StmtKind::expression) return;
  const ast::Expr& target = *ast::as<ast::ExprStmt>(*b.stmts.back()).value;
  if (target.span.end != b.last_end) return;
  const bool is_call = target.kind == ast::ExprKind::call;
  throw SyntaxError{error(Code::cannot_assign, target.span, "only a variable can be assigned",
                          is_call ? "a function is `fn name(a, b) = value`"
                                  : "lists and vectors are values: assign a new one to the variable")};
}

/// The word that ended just before, where a `{` was found behind it.
void check_unknown_kind(Builder& b, const char* at) {
  if (at == end_of(b) || *at != '{' || b.last_end == 0) return;
  const std::string_view word = b.last_word();
  const std::uint32_t begin = b.last_end - static_cast<std::uint32_t>(word.size());
  if (!word.empty() && !lang::is_reserved(word)) fail_unknown_kind(b, begin, b.last_end);
}

}  // namespace

Span token_span(const Builder& b, const char* at) {
  const std::uint32_t begin = b.offset(at);
  return b.span(begin, at == end_of(b) ? begin : begin + static_cast<std::uint32_t>(token_at(b, at).size()));
}

void fail(Builder& b, const char* at, Expectation expectation) {
  if (const auto quote = broken_string(b, at)) fail_string(b, *quote);
  if (is_open_interpolation(b, at, expectation)) fail_interpolation(b);
  if (is_unclosed(b, at, expectation)) fail_unclosed(b, at);
  check_reserved(b, at, expectation);
  check_assigned(b, at, expectation);
  check_unknown_kind(b, at);
  if (at != end_of(b) && expectation.is_value()) fail_if_foreign_statement(b, at, end_of(b));
  SyntaxError out{error(code_for(b, at), place_of(b, at),
                        fmt::format("expected {}, found {}", expectation.wanted, found(b, at)),
                        help_for(b, at, expectation))};
  out.last = at == end_of(b);
  b.incomplete = b.incomplete || out.last;
  throw out;
}

void fail_too_deep(Builder& b, const char* at) {
  SyntaxError out{error(Code::too_deep, token_span(b, at),
                        "blocks and expressions are nested more than 1,000 deep",
                        "give inner parts a name with `let` or `fn`")};
  out.last = true;
  throw out;
}

void fail_unclosed_comment(Builder& b, const char* opener) {
  const std::uint32_t at = b.offset(opener);
  SyntaxError out{error(Code::unclosed_comment, b.span(at, at + 2), "this comment is never closed",
                        "comments nest: each `/*` needs its own `*/`")};
  out.last = true;
  b.incomplete = true;
  throw out;
}

const char* end_of_mistake(Builder& b, const SyntaxError& problem, const char* start) {
  const char* target = nullptr;
  if (problem.resume_here) {
    ++b.assumed_closers;
    target = b.text().data() + problem.diagnostic.labels.front().span.begin;
  } else {
    target = next_statement(b.text(), start, b.text().data() + problem.diagnostic.span.begin);
  }
  if (target == start) ++target;
  b.skipped.push_back(b.span(b.offset(start), b.offset(target)));
  return target;
}

void tell(Builder& b, SyntaxError& problem) {
  if (b.diagnostics.size() + 1 >= k_most_errors) {
    problem.last = true;
    throw std::move(problem);
  }
  b.report(std::move(problem.diagnostic));
}

}  // namespace lancer::grammar
