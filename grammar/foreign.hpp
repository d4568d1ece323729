#pragma once
// Habits from other languages, told before they make confusing errors. What single words mean here is in the
// table of words, `lang::foreign_hint`.

#include <string_view>

#include "grammar/builder.hpp"

namespace lancer::grammar {

/// What C, POV-Ray and OpenSCAD people mean by these signs. Empty for any other.
std::string_view sign_help(std::string_view token);

/// `rgb <1, 0, 0>`, POV-Ray's way to write a colour.
bool is_foreign_color(const Builder& b, const char* at);

/// `word {` where no kind stands: another language's object, or a misspelt one.
[[noreturn]] void fail_unknown_kind(Builder& b, std::uint32_t begin, std::uint32_t end);

/// Throws for `#declare` and its like; colours pass.
void fail_if_directive(Builder& b, const char* begin, const char* end);
/// Throws where a statement begins as only another language's does: `camera { .. }`, `n += 1`, `else` alone.
void fail_if_foreign_statement(Builder& b, const char* at, const char* end);

/// Throws for `rgb <1, 0, 0>` where a comparison could stand: POV-Ray's way to write a colour.
void fail_if_foreign_color(const Builder& b, const char* at, const char* end);

}  // namespace lancer::grammar
