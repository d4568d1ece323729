#pragma once
// What machines read: one JSON object a line.

#include <string>
#include <vector>

#include "app/plan_command.hpp"
#include "app/render_command.hpp"
#include "base/diagnostic.hpp"

namespace lancer::app {

/// Sorted by file and place, all of them. Lines and columns count from 1, columns in code points;
/// `end_column` is the one behind the span.
///
///     {"code":"E013","column":27,"end_column":29,"end_line":12,"file":"lamp.scn","help":"","labels":[],"line":12,
///      "message":"...","severity":"error","trace":[]}
std::string to_json(std::vector<Diagnostic> diagnostics, const SourceMap& sources);

/// A mistake that has no place in a script.
std::string problem_to_json(const std::string& file, const std::string& message);

std::string to_json(const RenderStats& stats);

std::string to_json(const PlanReport& report);

}  // namespace lancer::app
