#include "app/report.hpp"

#include <optional>

#include "app/exit_code.hpp"
#include "app/output_path.hpp"

namespace lancer::app {
namespace {

using session::Outcome;
using session::Run;

/// The text of standard input; nothing, with the reason in `run`, where it cannot be read.
std::optional<std::string> read_input(DiskHost& host, Run& run) {
  session::FileText input = host.read_input();
  if (input.status == session::FileText::Status::read) return std::move(input.text);
  run.outcome = Outcome::unreadable;
  run.problem = "cannot read standard input: " + input.problem;
  return std::nullopt;
}

}  // namespace

Run run_script(session::Session& session, DiskHost& host, const std::string& file,
               const session::RunOptions& options) {
  if (file != k_stream) return session.run_file(file, options);
  Run run;
  std::optional<std::string> text = read_input(host, run);
  return text ? session.run_text(k_input_name, std::move(*text), "", options) : run;
}

Run parse_script(session::Session& session, DiskHost& host, const std::string& file) {
  if (file != k_stream) return session.parse_file(file);
  Run run;
  std::optional<std::string> text = read_input(host, run);
  return text ? session.parse_text(k_input_name, std::move(*text)) : run;
}

int exit_code_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::fine: return k_fine;
    case Outcome::script_wrong: return k_script_wrong;
    case Outcome::define_wrong: return k_command_wrong;
    case Outcome::unreadable: return k_file_trouble;
    case Outcome::interrupted: return k_interrupted;
  }
  return k_script_wrong;
}

void report(const session::Session& session, const Run& run, const Console& console) {
  say(to_text(run.diagnostics, session.sources(), console.colors));
  // What a message has said already is not said twice.
  if (!run.problem.empty() && !has_errors(run.diagnostics)) complain(run.problem);
  if (run.outcome == Outcome::interrupted) complain("interrupted");
}

void report_mistakes(const session::Session& session, Run run, const Console& console) {
  std::erase_if(run.diagnostics, [](const Diagnostic& d) { return d.code == Code::unused; });
  report(session, run, console);
}

}  // namespace lancer::app
