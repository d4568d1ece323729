// Functions that speak of the script itself.

#include <array>

#include "lang/builtins_arguments.hpp"
#include "lang/builtins_groups.hpp"

namespace lancer::lang {
namespace {

void refuse_where_pure(const Arguments& a) {
  if (!a.context().pure) return;
  throw ScriptError(
      Code::misplaced, a.context().span,
      "a pattern function only works out a colour; here it calls `" + std::string(a.id()) + "`");
}

Value print_of(const Arguments& a) {
  refuse_where_pure(a);
  std::string line;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (i > 0) line += " ";
    line += display(a[i], a.meter(), a.context().span);
  }
  a.context().print(line + "\n");
  return {};
}

Value assert_of(const Arguments& a) {
  refuse_where_pure(a);
  if (!a[0].is(Type::boolean)) a.wrong_type(0, "true or false");
  if (a[0].boolean()) return {};
  std::string message = "this was asserted to be true; it is false";
  if (a.size() == 2) {
    if (const std::string& reason = a.text(1); !reason.empty()) message = "failed assertion: " + reason;
  }
  a.refuse(Code::failed_assert, 0, std::move(message));
}

Value type_of(const Arguments& a) { return Value(std::string(type_name(a[0]))); }

constexpr std::array k_table{
    BuiltinInfo{"print", "print(...)", "writes the values, a space between them, and a newline", 0,
                k_any_count, print_of},
    BuiltinInfo{"assert", "assert(cond, message = \"\")", "stops the script where cond is false", 1, 2,
                assert_of},
    BuiltinInfo{"type_of", "type_of(v)", "\"number\", \"list\", ..., or the kind of an object", 1, 1,
                type_of},
};

}  // namespace

std::span<const BuiltinInfo> other_builtins() { return k_table; }

}  // namespace lancer::lang
