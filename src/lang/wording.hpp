#pragma once
// Small pieces of the sentences in messages.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lancer::lang {

/// `word`
std::string quoted(std::string_view word);

/// "a", "a and b", "a, b and c"; with ", or" for `last`, "a, or b".
std::string listed(const std::vector<std::string>& words, std::string_view last);

/// "1 value", "2 values".
std::string count_of(std::size_t count, std::string_view noun);

}  // namespace lancer::lang
