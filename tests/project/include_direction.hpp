#pragma once
// Which room may include what: the rules of docs/architecture.md in a form that a test can hold the source
// to.

#include <string>
#include <string_view>
#include <vector>

/// The room that a source file is in, such as "base" for src/base/vec.hpp; empty for a file in none.
std::string room_of(std::string_view path);

/// The includes in `text` that a file of that room must not have, each as "line 3: <tao/pegtl.hpp>".
std::vector<std::string> forbidden_includes(std::string_view room, std::string_view text);
