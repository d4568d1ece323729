// Tokens: names, and numbers, colours and strings from their spelling to their value.

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <optional>
#include <string>

#include "base/math.hpp"
#include "grammar/builder.hpp"
#include "grammar/lexemes.hpp"

namespace lancer::grammar {
namespace {

bool is_hex_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

unsigned hex_value(std::string_view digits) {
  unsigned out = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), out, 16);
  return out;
}

/// The correctly rounded value of digits without `_`; infinite where it is too large.
double parse_double(const std::string& digits) {
  double out = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), out);
  // from_chars does not say on which side the range was left; strtod does, and rounds to denormals.
  if (result.ec == std::errc::result_out_of_range) return std::strtod(digits.c_str(), nullptr);
  return out;
}

}  // namespace

std::string to_utf8(std::uint32_t c) {
  std::string out;
  const auto push = [&](std::uint32_t byte) { out += static_cast<char>(byte); };
  if (c < 0x80) {
    push(c);
  } else if (c < 0x800) {
    push(0xC0 | c >> 6);
    push(0x80 | (c & 0x3F));
  } else if (c < 0x10000) {
    push(0xE0 | c >> 12);
    push(0x80 | (c >> 6 & 0x3F));
    push(0x80 | (c & 0x3F));
  } else {
    push(0xF0 | c >> 18);
    push(0x80 | (c >> 12 & 0x3F));
    push(0x80 | (c >> 6 & 0x3F));
    push(0x80 | (c & 0x3F));
  }
  return out;
}

std::optional<std::string> decode_escape(std::string_view spelled) {
  switch (spelled.size() > 1 ? spelled[1] : '\0') {
    case 'n': return "\n";
    case 't': return "\t";
    case '"': return "\"";
    case '\\': return "\\";
    case '{': return "{";
    case 'u': break;
    default: return std::nullopt;
  }
  if (spelled.size() < 5 || spelled.size() > 10 || spelled[2] != '{' || spelled.back() != '}')
    return std::nullopt;
  const std::string_view digits = spelled.substr(3, spelled.size() - 4);
  for (char c : digits) {
    if (!is_hex_digit(c)) return std::nullopt;
  }
  const unsigned code = hex_value(digits);
  if (code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return std::nullopt;
  return to_utf8(code);
}

void Builder::end_token(const char* at) {
  previous_end = last_end;
  last_end = offset(at);
}

void Builder::number(const char* begin, const char* end) {
  last_end = offset(end);
  const Span s = span(begin);
  double value = 0;
  if (const char* problem = number_problem({begin, static_cast<std::size_t>(end - begin)})) {
    report(error(Code::bad_number, s,
                 fmt::format("`{}` is no number: {}",
                             std::string_view(begin, static_cast<std::size_t>(end - begin)), problem),
                 "numbers look like 1, .5, 2.5e-3, 1_000_000"));
  } else {
    std::string digits;
    for (const char* c = begin; c != end; ++c) {
      if (*c != '_') digits += *c;
    }
    value = parse_double(digits);
    if (std::isinf(value)) {
      report(error(Code::number_too_large, s, "this number is too large; the largest is about 1.8e308"));
      value = 0;
    }
  }
  push(ast::Number{{ast::ExprKind::number, s}, value});
}

void Builder::color(const char* begin, const char* end) {
  last_end = offset(end);
  const Span s = span(begin);
  const std::string_view digits(begin + 1, static_cast<std::size_t>(end - begin - 1));
  bool valid = digits.size() == 3 || digits.size() == 6;
  for (char c : digits) valid = valid && is_hex_digit(c);
  double rgb[3] = {0, 0, 0};
  if (!valid) {
    report(error(Code::bad_color, s,
                 fmt::format("`#{}` is no colour: 3 or 6 hexadecimal digits follow the `#`", digits),
                 "colours look like #f80 or #ff8800"));
  } else {
    const std::size_t width = digits.size() / 3;
    for (std::size_t i = 0; i < 3; ++i) {
      const unsigned level = hex_value(digits.substr(i * width, width));
      rgb[i] = math::srgb_to_linear((width == 1 ? level * 17 : level) / 255.0);
    }
  }
  push(ast::ColorLiteral{{ast::ExprKind::color, s}, rgb[0], rgb[1], rgb[2]});
}

void Builder::truth(const char* begin) {
  push(ast::Boolean{{ast::ExprKind::boolean, span(begin)}, *begin == 't'});
}

void Builder::string_text(const char* begin, const char* end) {
  pieces.push_back({offset(begin), {begin, end}, nullptr});
}

void Builder::string_escape(const char* begin, const char* end) {
  const std::string_view spelled(begin, static_cast<std::size_t>(end - begin));
  const auto decoded = decode_escape(spelled);
  if (!decoded) {
    report(
        error(Code::bad_escape, span(offset(begin), offset(end)), fmt::format("`{}` is no escape", spelled),
              "the escapes are \\n \\t \\\" \\\\ \\{ and \\u{1F600}, a Unicode code point in hexadecimal"));
  }
  pieces.push_back({offset(begin), decoded.value_or(""), nullptr});
}

void Builder::interpolation(const char* begin) { pieces.push_back({offset(begin), {}, take_expr()}); }

void Builder::string(const char* begin) {
  const Span s = span(begin);
  if (text_.substr(s.begin, s.end - s.begin).find('\n') != std::string_view::npos) {
    report(error(Code::unclosed_string, span(s.begin, s.begin + 1), "a string stands on one line",
                 "write \\n for a line break"));
  }
  std::size_t first = pieces.size();
  while (first > 0 && pieces[first - 1].begin >= s.begin) --first;
  std::vector<ast::StringPart> parts;
  std::string literal;
  for (std::size_t i = first; i < pieces.size(); ++i) {
    literal += pieces[i].text;
    if (pieces[i].value == nullptr) continue;
    parts.push_back({arena_.text(literal), pieces[i].value});
    literal.clear();
  }
  if (!literal.empty()) parts.push_back({arena_.text(literal), nullptr});
  pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(first), pieces.end());
  push(ast::String{{ast::ExprKind::string, s}, arena_.copy(parts.data(), parts.size())});
}

void Builder::string_as_name(const char* begin) {
  string(begin);
  names.push_back(static_cast<ast::String*>(take_expr()));
}

void Builder::word(const char* begin) {
  const Span s = span(begin);
  words.push_back({s, text_.substr(s.begin, s.end - s.begin)});
}

}  // namespace lancer::grammar
