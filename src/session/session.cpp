#include "session/session.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <utility>

#include "base/deep_stack.hpp"
#include "grammar/lexemes.hpp"
#include "grammar/parse.hpp"
#include "lang/build_object.hpp"
#include "lang/evaluate.hpp"
#include "lang/resolve.hpp"
#include "lang/script_error.hpp"
#include "session/load.hpp"

namespace lancer::session {
namespace {

bool is_name(std::string_view text) {
  return !text.empty() && grammar::word_at(text.data(), text.data() + text.size()).size() == text.size();
}

void append(std::vector<Diagnostic>& to, std::vector<Diagnostic> more) {
  std::move(more.begin(), more.end(), std::back_inserter(to));
}

/// Whether text that was not understood may have made this name: it holds the word, or an `include`.
bool may_make(std::string_view text, std::string_view name) {
  for (auto at = text.begin(); at != text.end();) {
    const auto begin = std::find_if(at, text.end(), grammar::is_word_character);
    at = std::find_if_not(begin, text.end(), grammar::is_word_character);
    const std::string_view word(begin, at);
    if (word == name || word == "include") return true;
  }
  return false;
}

/// Where text was not understood, names that it may have made are not known to be missing.
void drop_consequences(std::vector<Diagnostic>& diagnostics, const std::vector<Span>& skipped,
                       const SourceMap& sources) {
  std::erase_if(diagnostics, [&](const Diagnostic& d) {
    if (d.severity != Severity::error) return true;
    if (d.code != Code::unknown_name && d.code != Code::cannot_assign) return false;
    const std::string_view word = sources.text(d.span);
    return std::any_of(skipped.begin(), skipped.end(),
                       [&](Span s) { return may_make(sources.text(s), word); });
  });
}

}  // namespace

struct Session::State {
  explicit State(Host& h) : host(h) {}

  Host& host;
  std::unique_ptr<SourceMap> sources = std::make_unique<SourceMap>();
  scene::Scene scene;
  Loaded loaded;
  std::deque<ast::Script> defines;

  /// Parses `name = value` pairs from outside; false when one is wrong.
  bool parse_defines(const RunOptions& options, std::vector<lang::Definition>& out, Run& run);
  void stages(Start start, const RunOptions& options, Run& run);
  Run start(Start start, const RunOptions& options);
};

bool Session::State::parse_defines(const RunOptions& options, std::vector<lang::Definition>& out, Run& run) {
  for (const Define& define : options.defines) {
    if (!is_name(define.name)) {
      run.problem = fmt::format("`{}` is no name for a variable", define.name);
      return false;
    }
    const std::uint32_t file =
        sources->add("-D " + define.name, fmt::format("let {} = {}", define.name, define.value));
    grammar::Parsed parsed = grammar::parse(*sources, file);
    append(run.diagnostics, std::move(parsed.diagnostics));
    if (has_errors(run.diagnostics)) return false;
    if (parsed.script.statements.size() != 1 || parsed.script.statements[0]->kind != ast::StmtKind::let) {
      run.problem = fmt::format("the value of `{}` is not one expression", define.name);
      return false;
    }
    defines.push_back(std::move(parsed.script));
    out.push_back({&defines.back()});
  }
  return true;
}

/// The whole way from text to scene. Each stage that reports errors is the last.
void Session::State::stages(Start start, const RunOptions& options, Run& run) {
  std::vector<lang::Definition> definitions;
  if (!parse_defines(options, definitions, run)) {
    run.outcome = Outcome::define_wrong;
    return;
  }
  loaded = load(std::move(start), host, *sources, options);
  run.problem = loaded.problem;
  append(run.diagnostics, std::move(loaded.diagnostics));
  const bool parsed = !has_errors(run.diagnostics);
  const std::vector<ast::Script*> scripts = loaded.pointers();
  lang::Resolved resolved = lang::resolve(scripts, definitions, options.keep_unused);
  if (!parsed) drop_consequences(resolved.diagnostics, loaded.skipped, *sources);
  append(run.diagnostics, std::move(resolved.diagnostics));
  if (has_errors(run.diagnostics)) return;

  const auto print = [this](std::string_view line) { host.print(line); };
  lang::Evaluated evaluated = lang::evaluate(scripts, resolved, {options.limits, options.interrupt, print});
  run.steps = evaluated.steps;
  append(run.diagnostics, std::move(evaluated.diagnostics));
  if (has_errors(run.diagnostics)) return;
  lang::Meter meter(lang::Limits{.steps = 0}, options.interrupt);
  scene = lang::build_scene(evaluated.objects, evaluated.settings, meter);
}

Run Session::State::start(Start start, const RunOptions& options) {
  Run run;
  sources = std::make_unique<SourceMap>();
  loaded = {};
  defines.clear();
  on_deep_stack([&] {
    try {
      stages(std::move(start), options, run);
    } catch (lang::ScriptError& problem) {
      run.diagnostics.push_back(std::move(problem.diagnostic));
    } catch (const lang::Interrupted&) {
      run.outcome = Outcome::interrupted;
    }
  });
  if (run.outcome != Outcome::fine) return run;
  if (has_errors(run.diagnostics))
    run.outcome = run.problem.empty() ? Outcome::script_wrong : Outcome::unreadable;
  return run;
}

Session::Session(Host& host) : state_(std::make_unique<State>(host)) {}
Session::~Session() = default;

namespace {

/// Reads the started script; false, with the reason in `run`, where that fails.
bool read_start(Host& host, const std::string& path, Start& start, Run& run) {
  start.name = path;
  start.canonical = host.canonical(path);
  start.folder = std::filesystem::path(path).parent_path().string();
  FileText file = start.canonical.empty() ? FileText{FileText::Status::missing, {}, "no such file"}
                                          : host.read(start.canonical);
  if (file.status == FileText::Status::read) {
    start.text = std::move(file.text);
    return true;
  }
  run.outcome = Outcome::unreadable;
  run.problem = fmt::format("cannot read {}: {}", path, file.problem);
  return false;
}

}  // namespace

Run Session::run_file(const std::string& path, const RunOptions& options) {
  Run run;
  Start start;
  if (!read_start(state_->host, path, start, run)) return run;
  return state_->start(std::move(start), options);
}

Run Session::run_text(const std::string& name, std::string text, const std::string& folder,
                      const RunOptions& options) {
  return state_->start({name, std::move(text), {}, folder}, options);
}

Run Session::parse_file(const std::string& path) {
  Run run;
  Start start;
  if (!read_start(state_->host, path, start, run)) return run;
  return parse_text(path, std::move(start.text));
}

Run Session::parse_text(const std::string& name, std::string text) {
  state_->loaded = {};
  state_->sources = std::make_unique<SourceMap>();
  grammar::Parsed parsed = grammar::parse(*state_->sources, state_->sources->add(name, std::move(text)));
  state_->loaded.scripts.push_back(std::move(parsed.script));
  Run run;
  run.diagnostics = std::move(parsed.diagnostics);
  if (has_errors(run.diagnostics)) run.outcome = Outcome::script_wrong;
  return run;
}

std::string Session::ast_dump() const {
  return state_->loaded.scripts.empty() ? std::string{} : ast::dump(state_->loaded.scripts.front());
}

const scene::Scene& Session::scene() const { return state_->scene; }
const SourceMap& Session::sources() const { return *state_->sources; }

std::vector<scene::View> Session::views() const {
  if (state_->scene.views.empty()) return {scene::automatic_view(state_->scene)};
  return state_->scene.views;
}

std::string Session::view_name(std::size_t index) const {
  const auto& views = state_->scene.views;
  if (views.empty()) return "automatic";
  if (views[index].name != 0) return state_->scene.names[views[index].name];
  const auto last = views.begin() + static_cast<std::ptrdiff_t>(index) + 1;
  return fmt::format("view {}",
                     std::count_if(views.begin(), last, [](const scene::View& v) { return v.name == 0; }));
}

tracer::Plan Session::plan(const scene::View& view, const tracer::Options& options) const {
  return tracer::plan(state_->scene, view, options);
}

tracer::Rendered Session::render(const scene::View& view, const tracer::Options& options,
                                 const tracer::Watch& watch) const {
  return tracer::render(state_->scene, view, options, watch);
}

}  // namespace lancer::session
