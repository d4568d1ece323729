#include "lang/run_script.hpp"

#include <algorithm>
#include <deque>
#include <fmt/format.h>
#include <memory>
#include <tuple>

#include "base/deep_stack.hpp"
#include "catch.hpp"
#include "grammar/parse.hpp"

namespace lancer::lang {
namespace {

/// A test's own little loader: reads each file once, in the order of the `include` statements.
struct Loaded {
  SourceMap sources;
  std::deque<grammar::Parsed> parsed;
  std::vector<ast::Script*> scripts;
  std::vector<Definition> definitions;
  std::map<std::string, std::uint32_t> places;

  ast::Script* parse(const std::string& name, const std::string& text) {
    const std::uint32_t file = sources.add(name, text);
    parsed.push_back(grammar::parse(sources, file));
    INFO(to_text(parsed.back().diagnostics, sources));
    REQUIRE(parsed.back().diagnostics.empty());
    return &parsed.back().script;
  }

  void load(const Files& files, const std::string& name) {
    places[name] = static_cast<std::uint32_t>(scripts.size());
    ast::Script* script = parse(name, files.at(name));
    scripts.push_back(script);
    for (ast::Stmt* s : script->statements) {
      if (s->kind != ast::StmtKind::include) continue;
      auto& include = ast::as<ast::Include>(*s);
      const std::string path(include.path);
      if (places.count(path) != 0) {
        include.script = ast::k_no_script;
      } else {
        include.script = static_cast<std::uint32_t>(scripts.size());
        load(files, path);
      }
    }
  }
};

std::vector<std::string> listed(std::vector<Diagnostic> diagnostics, const SourceMap& sources) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tuple(a.span.file, a.span.begin) < std::tuple(b.span.file, b.span.begin);
  });
  std::vector<std::string> out;
  for (const Diagnostic& d : diagnostics) {
    const Source& source = sources[d.span.file];
    const Position p = source.position(d.span.begin);
    out.push_back(
        fmt::format("{}:{}:{} {} {}", source.name(), p.line, p.column, code_name(d.code), d.message));
  }
  return out;
}

Ran start(const Files& files, const Defines& defines, const EvaluateOptions* options) {
  Loaded loaded;
  loaded.load(files, "main.scn");
  for (const auto& [name, value] : defines) {
    loaded.definitions.push_back({loaded.parse("-D", fmt::format("let {} = {}", name, value))});
  }
  Ran out;
  const Resolved resolved = resolve(loaded.scripts, loaded.definitions);
  out.diagnostics = resolved.diagnostics;
  if (options != nullptr && !has_errors(out.diagnostics)) {
    EvaluateOptions with_print = *options;
    with_print.print = [&out](std::string_view text) { out.printed += text; };
    Evaluated evaluated = evaluate(loaded.scripts, resolved, with_print);
    out.diagnostics.insert(out.diagnostics.end(), evaluated.diagnostics.begin(), evaluated.diagnostics.end());
    out.objects = std::move(evaluated.objects);
    out.steps = evaluated.steps;
  }
  out.found = listed(out.diagnostics, loaded.sources);
  return out;
}

Ran start_deep(const Files& files, const Defines& defines, const EvaluateOptions* options) {
  Ran out;
  on_deep_stack([&] { out = start(files, defines, options); });
  return out;
}

}  // namespace

const Diagnostic& Ran::only() const {
  CAPTURE(found);
  REQUIRE(diagnostics.size() == 1);
  return diagnostics[0];
}

Ran resolve_files(const Files& files, const Defines& defines) { return start_deep(files, defines, nullptr); }
Ran resolve_text(const std::string& text) { return resolve_files({{"main.scn", text}}); }

Ran run_files(const Files& files, const Defines& defines, const EvaluateOptions& options) {
  return start_deep(files, defines, &options);
}

Ran run(const std::string& text, const Limits& limits) {
  EvaluateOptions options;
  options.limits = limits;
  return run_files({{"main.scn", text}}, {}, options);
}

Ran run_shallow(const std::string& text) {
  const EvaluateOptions options;
  return start({{"main.scn", text}}, {}, &options);
}

std::string printed(const std::string& text) {
  const Ran ran = run(text);
  CAPTURE(text, ran.found);
  REQUIRE_FALSE(has_errors(ran.diagnostics));
  return ran.printed;
}

std::string failure(const std::string& text) {
  const Ran ran = run(text);
  for (std::size_t i = 0; i < ran.found.size(); ++i) {
    const std::size_t at = ran.found[i].find(" E");
    if (at != std::string::npos) return ran.found[i].substr(std::string("main.scn:").size());
  }
  return "no error";
}

}  // namespace lancer::lang
