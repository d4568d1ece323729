#include "app/check_command.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "app/exit_code.hpp"
#include "app/json.hpp"
#include "app/output_path.hpp"
#include "app/report.hpp"

namespace lancer::app {
namespace {

/// Where prints are let through, standard output is theirs alone.
void write_json(const CheckCommand& command, const Console& console, const std::string& lines) {
  if (command.prints) {
    console.out.flush();
    say(lines);
  } else {
    console.out.write(lines);
  }
}

void report_json(const CheckCommand& command, const Console& console, const std::string& file,
                 const session::Session& session, const session::Run& run) {
  std::string lines = to_json(run.diagnostics, session.sources());
  if (!run.problem.empty() && !has_errors(run.diagnostics)) lines += problem_to_json(file, run.problem);
  write_json(command, console, lines);
}

void report_text(const Console& console, const std::string& file, const session::Session& session,
                 const session::Run& run) {
  console.out.flush();
  report(session, run, console);
  if (run.outcome != session::Outcome::fine) return;
  const std::size_t warnings = run.diagnostics.size();
  say(warnings == 0 ? fmt::format("{}: fine\n", file)
                    : fmt::format("{}: fine, with {} warning{}\n", file, warnings, warnings == 1 ? "" : "s"));
}

int check_file(const CheckCommand& command, const Console& console, const std::string& file) {
  DiskHost::Print print;
  if (command.prints) print = [&](std::string_view text) { console.out.write(text); };
  DiskHost host(print, console.interrupt);
  session::Session session(host);
  session::RunOptions options = command.run;
  options.interrupt = &console.interrupt;
  const session::Run run = run_script(session, host, file, options);
  const std::string name = file == k_stream ? k_input_name : file;
  if (command.json) {
    report_json(command, console, name, session, run);
  } else {
    report_text(console, name, session, run);
  }
  return exit_code_of(run.outcome);
}

}  // namespace

int check(const CheckCommand& command, const Console& console) {
  int worst = k_fine;
  for (const std::string& file : command.files) {
    const int code = check_file(command, console, file);
    if (code == k_interrupted || code == k_command_wrong) return code;
    worst = std::max(worst, code);
  }
  console.out.flush();
  return worst;
}

}  // namespace lancer::app
