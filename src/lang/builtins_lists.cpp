// Functions of lists. A range serves as a list wherever one is only read.

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <functional>

#include "base/number.hpp"
#include "lang/builtins_arguments.hpp"
#include "lang/builtins_groups.hpp"
#include "lang/object.hpp"

namespace lancer::lang {
namespace {

/// Room is made beforehand for lists up to this length; longer ones grow, charged step by step.
constexpr std::size_t k_room = std::size_t{1} << 20;

/// Appends the elements of a list or range, charging each.
void append(const Arguments& a, std::size_t i, std::vector<Value>& out) {
  const Value& list = a.list(i);
  const std::size_t length = list.length();
  a.charge(length);
  out.reserve(out.size() + std::min(length, k_room));
  for (std::size_t k = 0; k < length; ++k) out.push_back(list.item(k));
}

/// The characters of UTF-8 text.
std::size_t count_characters(const Arguments& a, const std::string& text) {
  a.charge(text.size() / 64);
  const auto is_lead = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), is_lead));
}

Value len_of(const Arguments& a) {
  const Value& v = a[0];
  if (v.is_list_like()) return static_cast<double>(v.length());
  if (v.is(Type::string)) return static_cast<double>(count_characters(a, v.text()));
  if (v.is(Type::vector)) return static_cast<double>(v.dimension());
  if (v.is(Type::object) && v.object().kind == ast::Kind::group) {
    return static_cast<double>(v.object().members.size());
  }
  a.wrong_type(0, "a list, a range, a string, a vector or a group");
}

Value push_of(const Arguments& a) {
  std::vector<Value> out;
  append(a, 0, out);
  out.push_back(a[1]);
  return Value(std::move(out));
}

Value concat_of(const Arguments& a) {
  std::vector<Value> out;
  for (std::size_t i = 0; i < a.size(); ++i) append(a, i, out);
  return Value(std::move(out));
}

Value map_of(const Arguments& a) {
  const Value& list = a.list(0);
  a.function(1);
  std::vector<Value> out;
  for (std::size_t i = 0; i < list.length(); ++i) {
    a.charge(1);
    const Value item = list.item(i);
    out.push_back(a.call(1, {&item, 1}));
  }
  return Value(std::move(out));
}

/// What a function that must answer true or false says.
bool answer(const Arguments& a, std::size_t function, std::span<const Value> arguments) {
  const Value result = a.call(function, arguments);
  if (result.is(Type::boolean)) return result.boolean();
  a.refuse(Code::wrong_type, function,
           fmt::format("the function of `{}` returns true or false; this one returned {}", a.id(),
                       with_article(result)));
}

Value filter_of(const Arguments& a) {
  const Value& list = a.list(0);
  a.function(1);
  std::vector<Value> out;
  for (std::size_t i = 0; i < list.length(); ++i) {
    a.charge(1);
    const Value item = list.item(i);
    if (answer(a, 1, {&item, 1})) out.push_back(item);
  }
  return Value(std::move(out));
}

Value fold_of(const Arguments& a) {
  const Value& list = a.list(0);
  a.function(2);
  Value result = a[1];
  for (std::size_t i = 0; i < list.length(); ++i) {
    a.charge(1);
    const std::array<Value, 2> pair{result, list.item(i)};
    result = a.call(2, pair);
  }
  return result;
}

using Before = std::function<bool(const Value&, const Value&)>;

/// Merges the sorted halves [begin, middle) and [middle, end) of `from` into `to`.
void merge(const std::vector<Value>& from, std::vector<Value>& to, std::size_t begin, std::size_t middle,
           std::size_t end, const Before& before) {
  std::size_t left = begin;
  std::size_t right = middle;
  for (std::size_t i = begin; i < end; ++i) {
    const bool take_right = right < end && (left == middle || before(from[right], from[left]));
    to[i] = take_right ? from[right++] : from[left++];
  }
}

/// Stable, and at ease with a `before` that contradicts itself, which std::stable_sort is not.
std::vector<Value> merge_sort(std::vector<Value> items, const Arguments& a, const Before& before) {
  std::vector<Value> other(items.size());
  for (std::size_t width = 1; width < items.size(); width *= 2) {
    a.charge(items.size());
    for (std::size_t begin = 0; begin < items.size(); begin += 2 * width) {
      const std::size_t middle = std::min(begin + width, items.size());
      merge(items, other, begin, middle, std::min(middle + width, items.size()), before);
    }
    items.swap(other);
  }
  return items;
}

Value sort_of(const Arguments& a) {
  std::vector<Value> items;
  append(a, 0, items);
  if (a.size() == 2) {
    a.function(1);
    return Value(merge_sort(std::move(items), a, [&](const Value& x, const Value& y) {
      const std::array<Value, 2> pair{x, y};
      return answer(a, 1, pair);
    }));
  }
  return Value(merge_sort(std::move(items), a,
                          [&](const Value& x, const Value& y) { return less(x, y, a.meter(), a.span(0)); }));
}

Value reverse_of(const Arguments& a) {
  std::vector<Value> out;
  append(a, 0, out);
  std::reverse(out.begin(), out.end());
  return Value(std::move(out));
}

/// How many of first, first + step, first + 2 step, ... come before `end`.
double count_steps(double first, double end, double step) {
  const auto comes_before = [&](double k) {
    return step > 0 ? first + k * step < end : first + k * step > end;
  };
  double count = std::max(std::ceil((end - first) / step), 0.0);
  while (count > 0 && !comes_before(count - 1))
    count -= 1;  // at most once or twice: the division was rounded
  return count;
}

Value range_of(const Arguments& a) {
  const double first = a.size() == 1 ? 0 : a.number(0);
  const double end = a.number(a.size() == 1 ? 0 : 1);
  const double step = a.size() == 3 ? a.number(2) : 1;
  if (step == 0) {
    a.refuse(Code::bad_argument, 2, "the step of `range` is not 0; this one is 0");
  }
  const double count = count_steps(first, end, step);
  if (!(count < 0x1p32)) {
    throw ScriptError(
        Code::bad_argument, a.context().span,
        fmt::format("a list has fewer than 2^32 elements; this one would have {}", to_text(count)));
  }
  const auto length = static_cast<std::size_t>(count);
  a.charge(length);
  std::vector<Value> out;
  out.reserve(std::min(length, k_room));
  for (std::size_t i = 0; i < length; ++i) out.emplace_back(first + static_cast<double>(i) * step);
  return Value(std::move(out));
}

Value zip_of(const Arguments& a) {
  const Value& left = a.list(0);
  const Value& right = a.list(1);
  std::vector<Value> out;
  for (std::size_t i = 0; i < std::min(left.length(), right.length()); ++i) {
    a.charge(1);
    out.emplace_back(std::vector<Value>{left.item(i), right.item(i)});
  }
  return Value(std::move(out));
}

constexpr std::array k_table{
    BuiltinInfo{"len", "len(v)", "the number of elements, of characters of a string, of members of a group",
                1, 1, len_of},
    BuiltinInfo{"push", "push(list, v)", "a new list with v at its end", 2, 2, push_of},
    BuiltinInfo{"concat", "concat(a, b, ...)", "one list of the elements of several", 1, k_any_count,
                concat_of},
    BuiltinInfo{"map", "map(list, f)", "the list of f(v) for each element v", 2, 2, map_of},
    BuiltinInfo{"filter", "filter(list, f)", "the elements for which f(v) is true", 2, 2, filter_of},
    BuiltinInfo{"fold", "fold(list, start, f)", "f(f(f(start, v0), v1), v2) and so on", 3, 3, fold_of},
    BuiltinInfo{"sort", "sort(list[, f])", "the elements in order; f(a, b) says whether a comes first", 1, 2,
                sort_of},
    BuiltinInfo{"reverse", "reverse(list)", "the elements from the last to the first", 1, 1, reverse_of},
    BuiltinInfo{"range", "range(a, b, step)",
                "a list of numbers from a up to but without b; `range(n)` from 0", 1, 3, range_of},
    BuiltinInfo{"zip", "zip(a, b)", "the list of pairs, as long as the shorter list", 2, 2, zip_of},
};

}  // namespace

std::span<const BuiltinInfo> list_builtins() { return k_table; }

}  // namespace lancer::lang
