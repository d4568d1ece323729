#include "lang/wording.hpp"

#include <fmt/format.h>

namespace lancer::lang {

std::string quoted(std::string_view word) { return fmt::format("`{}`", word); }

std::string listed(const std::vector<std::string>& words, std::string_view last) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i != 0) out += i + 1 == words.size() ? fmt::format("{}{} ", last[0] == ',' ? "" : " ", last) : ", ";
    out += words[i];
  }
  return out;
}

std::string count_of(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace lancer::lang
