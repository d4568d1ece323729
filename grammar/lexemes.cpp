#include "grammar/lexemes.hpp"

#include <fmt/format.h>

namespace lancer::grammar {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Behind a comment that nests; null where it does not end.
const char* skip_block_comment(const char* at, const char* end) {
  int depth = 0;
  while (end - at >= 2) {
    if (at[0] == '/' && at[1] == '*') {
      ++depth;
      at += 2;
    } else if (at[0] == '*' && at[1] == '/') {
      at += 2;
      if (--depth == 0) return at;
    } else {
      ++at;
    }
  }
  return nullptr;
}

/// Moves over digits with `_` between them; false where a `_` stands elsewhere.
bool take_digits(std::string_view s, std::size_t& i) {
  while (i < s.size() && (is_digit(s[i]) || s[i] == '_')) {
    if (s[i] == '_' && (i == 0 || !is_digit(s[i - 1]) || i + 1 == s.size() || !is_digit(s[i + 1])))
      return false;
    ++i;
  }
  return true;
}

/// The length of the valid UTF-8 sequence at `at` (RFC 3629), or 0.
std::size_t utf8_length(std::string_view rest) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(rest[i]); };
  const unsigned char lead = byte(0);
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || length > rest.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  if ((lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) >= 0xA0)) return 0;
  if ((lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) >= 0x90)) return 0;
  return length;
}

bool is_control(std::string_view text, std::size_t i, std::size_t length) {
  const auto c = static_cast<unsigned char>(text[i]);
  if (length == 2) return c == 0xC2 && static_cast<unsigned char>(text[i + 1]) < 0xA0;
  if (length != 1 || c == '\n' || c == '\t') return false;
  if (c == '\r') return i + 1 == text.size() || text[i + 1] != '\n';
  return c < 0x20 || c == 0x7F;
}

}  // namespace

bool is_word_character(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

std::string_view word_at(const char* at, const char* end) {
  if (at == end || is_digit(*at)) return {at, 0};
  const char* stop = at;
  while (stop != end && is_word_character(*stop)) ++stop;
  return {at, static_cast<std::size_t>(stop - at)};
}

const char* skip_blank(const char* at, const char* end, const char** unclosed) {
  for (;;) {
    while (at != end && (*at == ' ' || *at == '\n' || *at == '\t' || *at == '\r')) ++at;
    if (end - at < 2 || *at != '/') return at;
    if (at[1] == '/') {
      while (at != end && *at != '\n') ++at;
    } else if (at[1] == '*') {
      const char* behind = skip_block_comment(at, end);
      if (behind == nullptr) {
        *unclosed = at;
        return end;
      }
      at = behind;
    } else {
      return at;
    }
  }
}

const char* behind_blank(const char* at, const char* end) {
  const char* unclosed = nullptr;
  return skip_blank(at, end, &unclosed);
}

const char* scan_number(const char* at, const char* end) {
  const char* c = at;
  if (c == end || !(is_digit(*c) || (*c == '.' && c + 1 != end && is_digit(c[1])))) return at;
  while (c != end) {
    const bool exponent_sign = (*c == '+' || *c == '-') && c + 1 != end && is_digit(c[1]) &&
                               (c[-1] == 'e' || c[-1] == 'E') && c - at >= 2 &&
                               (is_digit(c[-2]) || c[-2] == '.');
    const bool point = *c == '.' && !(c + 1 != end && c[1] == '.');
    if (!is_word_character(*c) && !point && !exponent_sign) break;
    // The two dots of a range do not belong to the number before them.
    if (*c == '.' && c != at && c[-1] == '.') break;
    ++c;
  }
  return c;
}

const char* number_problem(std::string_view s) {
  std::size_t i = 0;
  if (!take_digits(s, i)) return "`_` stands between digits only";
  if (i < s.size() && s[i] == '.') {
    ++i;
    if (i == s.size() || !is_digit(s[i])) return "a digit follows the point";
    if (!take_digits(s, i)) return "`_` stands between digits only";
  }
  if (i < s.size() && (s[i] == 'e' || s[i] == 'E')) {
    ++i;
    if (i < s.size() && (s[i] == '+' || s[i] == '-')) ++i;
    if (i == s.size() || !is_digit(s[i])) return "digits follow the `e` of an exponent";
    if (!take_digits(s, i)) return "`_` stands between digits only";
  }
  if (i == s.size()) return nullptr;
  return s[i] == '.' ? "it has two points" : "no letter stands directly behind it";
}

const char* scan_color(const char* at, const char* end) {
  ++at;
  while (at != end && (is_letter(*at) || is_digit(*at))) ++at;
  return at;
}

const char* skip_string(const char* at, const char* end) {
  int braces = 0;
  bool inner = false;  // a string within an interpolation
  for (++at; at != end && *at != '\n'; ++at) {
    if (*at == '\\' && at + 1 != end && at[1] != '\n') {
      ++at;
    } else if (*at == '"') {
      if (braces == 0) return at + 1;
      inner = !inner;
    } else if (!inner && *at == '{') {
      ++braces;
    } else if (!inner && *at == '}' && braces > 0) {
      --braces;
    }
  }
  return at;
}

std::vector<Diagnostic> check_text(std::string_view text, std::uint32_t file) {
  std::vector<Diagnostic> out;
  constexpr std::size_t k_enough = 100;
  for (std::size_t i = 0; i < text.size() && out.size() < k_enough;) {
    const std::size_t length = utf8_length(text.substr(i));
    const std::size_t shown = length == 0 ? 1 : length;
    const Span span{file, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + shown)};
    if (length == 0) {
      out.push_back(
          error(Code::bad_text, span,
                fmt::format("the byte {:#04x} is not valid UTF-8", static_cast<unsigned char>(text[i])),
                "scripts are UTF-8"));
    } else if (is_control(text, i, length)) {
      const unsigned code = static_cast<unsigned char>(text[i + length - 1]);
      out.push_back(error(Code::bad_text, span,
                          fmt::format("the control character U+{:04X} has no place in a script", code)));
    }
    i += shown;
  }
  return out;
}

}  // namespace lancer::grammar
