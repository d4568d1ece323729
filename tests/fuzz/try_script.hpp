#pragma once
// Takes any bytes for a script, as far as they go: parse, resolve, evaluate within small limits, a picture of
// a few pixels. Nothing may come of it but an outcome.

#include <string>
#include <utility>

#include "memory_host.hpp"
#include "session/session.hpp"

namespace lancer::test {

inline session::Outcome try_script(std::string text) {
  MemoryHost host;
  session::Session session(host);
  session::RunOptions options;
  options.limits = {.steps = 20'000, .objects = 1'000, .calls = 500};
  const session::Run run = session.run_text("fuzzed.scn", std::move(text), "", options);
  // The messages must be printable whatever the places are.
  static_cast<void>(to_text(run.diagnostics, session.sources()));
  if (run.outcome != session::Outcome::fine) return run.outcome;
  static_cast<void>(scene::dump(session.scene()));
  tracer::Options small;
  small.columns = 4;
  small.rows = 3;
  small.samples = 1;
  small.threads = 1;
  // Depth is the script's to choose, and time grows with it: deep ones are not drawn.
  if (session.scene().settings.depth <= 6) static_cast<void>(session.render(session.views().front(), small));
  return run.outcome;
}

}  // namespace lancer::test
