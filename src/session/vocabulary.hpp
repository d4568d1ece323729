#pragma once
// What the language has, in words: for help and completion.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lancer::session {

/// "sphere", "light", ...
std::vector<std::string_view> kind_words();
/// "abs", "atan2", ...
std::vector<std::string_view> function_words();
/// A few lines on a kind, attribute or function; nothing for any other word.
std::optional<std::string> describe(std::string_view word);

}  // namespace lancer::session
