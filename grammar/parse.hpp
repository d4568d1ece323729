#pragma once
// Text to tree: the grammar's one verb. Free of PEGTL; parse.cpp is the one file that includes it.

#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "lang/ast.hpp"

namespace lancer::grammar {

struct Parsed {
  ast::Script script;
  std::vector<Diagnostic> diagnostics;  // every syntax error, in the order of the text
  std::vector<Span> skipped;            // text that was passed over after a mistake
  bool incomplete = false;              // the one thing wrong is that the text ends too early
};

/// Parses the text number `file` of `sources`, which must outlive the tree.
Parsed parse(const SourceMap& sources, std::uint32_t file);

}  // namespace lancer::grammar
