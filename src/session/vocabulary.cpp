#include "session/vocabulary.hpp"

#include <fmt/format.h>

#include "lang/builtins.hpp"
#include "lang/keywords.hpp"

namespace lancer::session {

std::vector<std::string_view> kind_words() {
  std::vector<std::string_view> out;
  for (const lang::KindInfo& k : lang::all_kinds()) out.push_back(k.id);
  return out;
}

std::vector<std::string_view> function_words() {
  std::vector<std::string_view> out;
  for (const lang::BuiltinInfo& b : lang::all_builtins()) out.push_back(b.id);
  return out;
}

std::optional<std::string> describe(std::string_view word) {
  if (const auto kind = lang::find_kind(word)) {
    std::vector<std::string_view> ids;
    for (const lang::AttributeInfo& a : lang::kind_info(*kind).attributes) ids.push_back(a.id);
    return fmt::format("{} {{ .. }} has {}\n", word, fmt::join(ids, ", "));
  }
  std::string out;
  if (const auto slot = lang::find_builtin(word)) {
    const lang::BuiltinInfo& b = lang::all_builtins()[*slot];
    out += fmt::format("{}: {}\n", b.signature, b.summary);
  }
  if (lang::find_attribute(word) != nullptr) {
    std::vector<std::string_view> owners;
    for (const lang::KindInfo& k : lang::all_kinds()) {
      if (lang::find_attribute(k.kind, word) != nullptr) owners.push_back(k.id);
    }
    out += fmt::format("{} is an attribute of {}\n", word, fmt::join(owners, ", "));
  }
  if (out.empty()) return std::nullopt;
  return out;
}

}  // namespace lancer::session
