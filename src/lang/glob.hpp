#pragma once
// Names by pattern: `*` stands for any characters, none included, `?` for one; case counts.

#include <string_view>

namespace lancer::lang {

/// Whether the whole of `name` is as `pattern` says. Characters are code points; both are valid UTF-8.
bool matches_glob(std::string_view pattern, std::string_view name);

/// Whether it stands for other names than itself.
bool is_glob(std::string_view pattern);

}  // namespace lancer::lang
