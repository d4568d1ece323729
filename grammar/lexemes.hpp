#pragma once
// The smallest pieces of a text: white space, comments, and the extent of numbers and colours. Plain
// functions over characters; the rules wrap them.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"

namespace lancer::grammar {

/// Letters, digits and `_`.
bool is_word_character(char c);
/// The identifier that begins at `at`; empty where none does.
std::string_view word_at(const char* at, const char* end);

/// Behind white space and comments. `unclosed` is set to the `/*` of a comment that does not end (the result
/// is then `end`).
const char* skip_blank(const char* at, const char* end, const char** unclosed);

/// The same, where an unclosed comment is somebody else's matter.
const char* behind_blank(const char* at, const char* end);

/// Behind the number that begins at `at`, or what looks like one and is malformed; `at` itself where none
/// begins.
const char* scan_number(const char* at, const char* end);
/// What is wrong with a number's spelling; null for a good one.
const char* number_problem(std::string_view spelled);

/// Behind `#` and the letters and digits that follow.
const char* scan_color(const char* at, const char* end);

/// Behind the string that begins at `at`, interpolations included, or at the end of its line where it is not
/// closed.
const char* skip_string(const char* at, const char* end);

/// The characters that `\n`, `\u{1F600}`, ... stand for; nothing for an unknown escape.
std::optional<std::string> decode_escape(std::string_view spelled);
std::string to_utf8(std::uint32_t code_point);

/// Invalid UTF-8 and control characters, each at its place.
std::vector<Diagnostic> check_text(std::string_view text, std::uint32_t file);

/// Whether a statement begins with this word: `let`, `for`, ..., or a kind.
bool begins_statement(std::string_view word);

/// Where the next statement may begin after a mistake: `start` is where the faulty one began, `failed` where
/// it went wrong. Brackets opened in between are followed to their ends; a line that begins with a
/// statement's word at or left of the start's column ends the search in an unclosed one.
const char* next_statement(std::string_view text, const char* start, const char* failed);

/// Behind the `}` that belongs to the `{` at `at`, or the end.
const char* skip_braces(std::string_view text, const char* at);

}  // namespace lancer::grammar
