#pragma once
// Scripts in the tests of this room: from text to what it prints, adds and reports.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostic.hpp"
#include "lang/evaluate.hpp"
#include "lang/resolve.hpp"

namespace lancer::lang {

/// Texts by name; "main.scn" is the one that is started. The paths of `include` are names.
using Files = std::map<std::string, std::string>;
using Defines = std::vector<std::pair<std::string, std::string>>;

struct Ran {
  std::string printed;
  std::vector<Diagnostic> diagnostics;
  std::vector<std::string> found;  // "main.scn:1:5 E020 nothing is called `a` here", sorted by place
  std::vector<Ref<Object>> objects;
  std::uint64_t steps = 0;

  const Diagnostic& only() const;  // the one diagnostic that there must be
};

/// Parses and resolves, nothing more. Texts must parse.
Ran resolve_files(const Files& files, const Defines& defines = {});
Ran resolve_text(const std::string& text);

/// Runs; stops after the resolver where that reported errors.
Ran run_files(const Files& files, const Defines& defines = {}, const EvaluateOptions& options = {});
Ran run(const std::string& text, const Limits& limits = {});

/// On the stack of the calling thread.
Ran run_shallow(const std::string& text);

/// What a script without mistakes prints.
std::string printed(const std::string& text);
/// The first error of a script: "3:7 E030 the message".
std::string failure(const std::string& text);

}  // namespace lancer::lang
