// Functions of strings.

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "base/number.hpp"
#include "lang/builtins_arguments.hpp"
#include "lang/builtins_groups.hpp"

namespace lancer::lang {
namespace {

Value str_of(const Arguments& a) { return Value(display(a[0], a.meter(), a.context().span)); }

Value join_of(const Arguments& a) {
  const Value& list = a.list(0);
  const std::string& separator = a.text(1);
  std::string out;
  for (std::size_t i = 0; i < list.length(); ++i) {
    a.charge(1 + separator.size() / 64);
    if (i > 0) out += separator;
    out += display(list.item(i), a.meter(), a.context().span);
  }
  return Value(std::move(out));
}

/// Where the character that begins at `at` ends.
std::size_t character_end(const std::string& text, std::size_t at) {
  do {
    ++at;
  } while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80);
  return at;
}

Value split_of(const Arguments& a) {
  const std::string& text = a.text(0);
  const std::string& separator = a.text(1);
  a.charge(text.size() / 64);
  std::vector<Value> out;
  const auto add = [&](std::size_t begin, std::size_t end) {
    a.charge(1);
    out.emplace_back(text.substr(begin, end - begin));
  };
  if (separator.empty()) {
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = character_end(text, at);
      add(at, end);
      at = end;
    }
    return Value(std::move(out));
  }
  std::size_t begin = 0;
  for (std::size_t at = text.find(separator); at != std::string::npos; at = text.find(separator, begin)) {
    add(begin, at);
    begin = at + separator.size();
  }
  add(begin, text.size());
  return Value(std::move(out));
}

Value format_of(const Arguments& a) {
  const Value& v = a[0];
  if (!v.is(Type::number) && !v.is(Type::vector)) a.wrong_type(0, "a number or a vector");
  const double digits = a.number(1);
  if (digits != std::floor(digits) || digits < 0 || digits > 100) {
    a.refuse(Code::out_of_range, 1,
             fmt::format("the digits behind the point are a whole number from 0 to 100; this one is {}",
                         to_text(digits)));
  }
  const auto fixed = [&](int i) { return to_fixed(v.component(i), static_cast<int>(digits)); };
  a.charge(8);
  if (v.is(Type::number)) return Value(fixed(0));
  return Value("<" + fixed(0) + ", " + fixed(1) + (v.dimension() == 3 ? ", " + fixed(2) : "") + ">");
}

constexpr std::array k_table{
    BuiltinInfo{"str", "str(v)", "any value as `print` shows it", 1, 1, str_of},
    BuiltinInfo{"join", "join(list, sep)", "the elements in one string, sep between them", 2, 2, join_of},
    BuiltinInfo{"split", "split(s, sep)",
                "the parts of a string between each sep; its characters where sep is \"\"", 2, 2, split_of},
    BuiltinInfo{"format", "format(v, digits)", "a number with so many digits behind the point", 2, 2,
                format_of},
};

}  // namespace

std::span<const BuiltinInfo> string_builtins() { return k_table; }

}  // namespace lancer::lang
