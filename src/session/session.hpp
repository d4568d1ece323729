#pragma once
// The one object that every front end holds: a script becomes a scene, a scene becomes pictures.

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "lang/limits.hpp"
#include "scene/scene.hpp"
#include "session/host.hpp"
#include "tracer/plan.hpp"
#include "tracer/render.hpp"

namespace lancer::session {

/// `name = value` from outside the script; takes the place of the started script's own top-level `let` of
/// that name.
struct Define {
  std::string name;
  std::string value;  // an expression
};

struct RunOptions {
  std::vector<std::string> include_folders;  // the -I folders
  std::string library_folder;                // the built-in library; may be empty
  std::vector<Define> defines;
  lang::Limits limits;
  bool keep_unused = false;  // evaluates what nothing uses, too, and does not warn of it
  const std::atomic<bool>* interrupt = nullptr;
};

enum class Outcome {
  fine,
  script_wrong,  // diagnostics say why
  unreadable,    // the started script or an included file could not be read: `problem`
  define_wrong,  // a Define is no `name = value`; diagnostics or `problem` say why
  interrupted,
};

/// How far a run got and what was found on the way.
struct Run {
  Outcome outcome = Outcome::fine;
  std::vector<Diagnostic> diagnostics;  // errors and warnings
  std::string problem;                  // one line, for Outcome::unreadable and define_wrong
  std::uint64_t steps = 0;
};

class Session {
 public:
  explicit Session(Host& host);
  ~Session();

  /// Reads, parses, resolves and evaluates a script and the files that it includes; the scene is then
  /// `scene()`. On failure the scene stays as it was.
  Run run_file(const std::string& path, const RunOptions& options);
  /// The same for a text that is no file; includes are relative to `folder`.
  Run run_text(const std::string& name, std::string text, const std::string& folder,
               const RunOptions& options);

  /// Only parses a script, without its includes; the tree is then `ast_dump()`.
  Run parse_file(const std::string& path);
  Run parse_text(const std::string& name, std::string text);
  /// The tree of the script that was parsed or run last, as `dump --ast` shows it.
  std::string ast_dump() const;

  const scene::Scene& scene() const;
  const SourceMap& sources() const;

  /// The views of the scene, in order; the automatic view alone where the scene has none.
  std::vector<scene::View> views() const;
  /// What to call view number `index` of those: its name, or "view 1" by its place among those without one.
  std::string view_name(std::size_t index) const;

  /// What render() would do, and leave out.
  tracer::Plan plan(const scene::View& view, const tracer::Options& options) const;
  tracer::Rendered render(const scene::View& view, const tracer::Options& options,
                          const tracer::Watch& watch = {}) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lancer::session
