#pragma once
// Names to slots, before anything runs: finds every unknown name, unknown, repeated or missing attribute,
// mixed form and double declaration of all scripts at once, and what nothing uses.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "lang/ast.hpp"

namespace lancer::lang {

/// A name of the top level, in the order of its slot.
struct Global {
  std::string_view id;
  Span span;
};

struct Resolved {
  std::vector<Global> globals;
  std::vector<ast::Script*> definitions;  // those that replace nothing: they run before the first script
  std::vector<Diagnostic> diagnostics;    // errors, and warnings of what nothing uses
};

/// A script that stands for a value given from outside, `let name = value` and nothing else: it takes the
/// place of the first script's own top-level `let` of that name, or else is known to all scripts.
struct Definition {
  ast::Script* script;
};

/// Fills in the "resolved" fields of all `scripts`; the first is the one that was started, the others are
/// those its `include` statements lead to. With `keep_unused` all that is declared counts as used.
Resolved resolve(const std::vector<ast::Script*>& scripts, const std::vector<Definition>& definitions = {},
                 bool keep_unused = false);

}  // namespace lancer::lang
