#pragma once
// Reads a script and everything that it includes, each file once, in the order of the include statements.

#include <deque>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "lang/ast.hpp"
#include "session/host.hpp"
#include "session/session.hpp"

namespace lancer::session {

struct Loaded {
  std::deque<ast::Script> scripts;      // the first is the one that was started
  std::vector<Diagnostic> diagnostics;  // of all files
  std::vector<Span> skipped;            // text that was not understood or followed
  std::string problem;                  // set when a file could not be read

  std::vector<ast::Script*> pointers();
};

/// A text to start from: `name` is what messages call it, `canonical` its real path (empty for no file),
/// `folder` what its includes are relative to.
struct Start {
  std::string name;
  std::string text;
  std::string canonical;
  std::string folder;
};

Loaded load(Start start, Host& host, SourceMap& sources, const RunOptions& options);

}  // namespace lancer::session
