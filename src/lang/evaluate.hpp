#pragma once
// Runs resolved scripts: statements in order, objects added to the scene.

#include <atomic>
#include <functional>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "lang/ast.hpp"
#include "lang/limits.hpp"
#include "lang/object.hpp"
#include "lang/resolve.hpp"

namespace lancer::lang {

/// What the outside supplies to an evaluation.
struct EvaluateOptions {
  Limits limits;
  const std::atomic<bool>* interrupt = nullptr;
  std::function<void(std::string_view)> print;  // receives whole lines; empty: print writes nothing
};

struct Evaluated {
  std::vector<Ref<Object>> objects;  // in the order added
  scene::Settings settings;
  std::vector<Diagnostic> diagnostics;  // warnings; and the error that ended the run, if one did
  std::uint64_t steps = 0;
};

/// Runs the first of `scripts` (the others as it includes them). Throws Interrupted; a script's own error is
/// among the diagnostics.
Evaluated evaluate(const std::vector<ast::Script*>& scripts, const Resolved& resolved,
                   const EvaluateOptions& options);

}  // namespace lancer::lang
