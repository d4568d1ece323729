#include "lang/build.hpp"

#include <cmath>
#include <fmt/format.h>

#include "base/deep_stack.hpp"
#include "catch.hpp"
#include "grammar/parse.hpp"
#include "lang/build_object.hpp"
#include "lang/evaluate.hpp"
#include "lang/resolve.hpp"
#include "lang/script_error.hpp"

namespace lancer::lang {
namespace {

void stages(SourceMap& sources, const std::string& text, std::vector<Diagnostic>& diagnostics,
            scene::Scene& scene) {
  const auto take = [&](std::vector<Diagnostic> more) {
    for (Diagnostic& d : more) diagnostics.push_back(std::move(d));
    return !has_errors(diagnostics);
  };
  grammar::Parsed parsed = grammar::parse(sources, sources.add("main.scn", text));
  if (!take(std::move(parsed.diagnostics))) return;
  const std::vector<ast::Script*> scripts{&parsed.script};
  Resolved resolved = resolve(scripts);
  if (!take(std::move(resolved.diagnostics))) return;
  Evaluated evaluated = evaluate(scripts, resolved, {});
  if (!take(std::move(evaluated.diagnostics))) return;
  Meter meter(Limits{}, nullptr);
  try {
    scene = build_scene(evaluated.objects, evaluated.settings, meter);
  } catch (const ScriptError& problem) {
    diagnostics.push_back(problem.diagnostic);
  }
}

}  // namespace

Built build(const std::string& text) {
  Built out;
  SourceMap sources;
  std::vector<Diagnostic> diagnostics;
  on_deep_stack([&] { stages(sources, text, diagnostics, out.scene); });
  for (const Diagnostic& d : diagnostics) {
    out.messages.push_back(fmt::format("{} [{}] {}", code_name(d.code), sources.text(d.span), d.message));
  }
  return out;
}

scene::Scene scene_of(const std::string& text) {
  Built built = build(text);
  CAPTURE(text, built.messages);
  REQUIRE(built.messages.empty());
  return std::move(built.scene);
}

std::string refusal(const std::string& text) {
  const Built built = build(text);
  CAPTURE(text, built.messages);
  REQUIRE(built.messages.size() == 1);
  return built.messages[0];
}

bool is_near(Vec3 a, Vec3 b, double tolerance) { return max_abs(a - b) <= tolerance; }

}  // namespace lancer::lang
