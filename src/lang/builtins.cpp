#include "lang/builtins.hpp"

#include <cmath>
#include <fmt/format.h>
#include <unordered_map>
#include <vector>

#include "lang/builtins_arguments.hpp"
#include "lang/builtins_groups.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

using Slots = std::unordered_map<std::string_view, std::uint32_t>;

std::vector<BuiltinInfo> join_groups() {
  std::vector<BuiltinInfo> all;
  for (const auto& group : {component_builtins(), vector_builtins(), color_builtins(), chance_builtins(),
                            list_builtins(), string_builtins(), other_builtins()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

template <class Info>
Slots slots_of(std::span<const Info> table) {
  Slots slots;
  for (std::uint32_t i = 0; i < table.size(); ++i) slots.emplace(table[i].id, i);
  return slots;
}

std::optional<std::uint32_t> find(const Slots& slots, std::string_view id) {
  const auto found = slots.find(id);
  if (found == slots.end()) return std::nullopt;
  return found->second;
}

std::string wanted_count(const BuiltinInfo& info) {
  const unsigned least = info.min_arguments;
  const unsigned most = info.max_arguments;
  const std::string_view noun = least == 1 ? "argument" : "arguments";
  if (most == k_any_count) return fmt::format("{} {} or more", least, noun);
  if (least == most) return fmt::format("{} {}", least, noun);
  return fmt::format("{} {} {} arguments", least, most == least + 1 ? "or" : "to", most);
}

[[noreturn]] void refuse_count(const BuiltinInfo& info, std::size_t given, Span span) {
  throw ScriptError(Code::argument_count, span,
                    fmt::format("`{}` takes {}; this call has {}", info.id, wanted_count(info), given),
                    fmt::format("it is called as `{}`", info.signature));
}

/// "infinite", "not a number", or empty where all is well.
std::string_view flaw(const Value& value) {
  std::string_view found;
  const int count = value.is(Type::number) ? 1 : value.is(Type::vector) ? value.dimension() : 0;
  for (int i = 0; i < count; ++i) {
    if (std::isnan(value.component(i))) return "not a number";
    if (std::isinf(value.component(i))) found = "infinite";
  }
  return found;
}

[[noreturn]] void refuse_result(const BuiltinInfo& info, std::span<const Value> arguments,
                                std::string_view flaw, const CallContext& context) {
  std::string shown;
  for (const Value& a : arguments) {
    if (!shown.empty()) shown += ", ";
    shown += display(a, context.meter, context.span);
  }
  throw ScriptError(Code::not_finite, context.span,
                    fmt::format("every number stays finite; `{}({})` is {}", info.id, shown, flaw));
}

}  // namespace

std::span<const BuiltinInfo> all_builtins() {
  static const std::vector<BuiltinInfo> table = join_groups();
  return table;
}

std::optional<std::uint32_t> find_builtin(std::string_view id) {
  static const Slots slots = slots_of(all_builtins());
  return find(slots, id);
}

std::optional<std::uint32_t> find_constant(std::string_view id) {
  static const Slots slots = slots_of(all_constants());
  return find(slots, id);
}

Value call_builtin(std::uint32_t slot, std::span<const Value> arguments, const CallContext& context) {
  const BuiltinInfo& info = all_builtins()[slot];
  const std::size_t given = arguments.size();
  const bool too_many = info.max_arguments != k_any_count && given > info.max_arguments;
  if (given < info.min_arguments || too_many) refuse_count(info, given, context.span);
  Value result = info.function(Arguments(info.id, arguments, context));
  if (const std::string_view wrong = flaw(result); !wrong.empty())
    refuse_result(info, arguments, wrong, context);
  return result;
}

}  // namespace lancer::lang
