#include "app/dump_command.hpp"

#include "app/exit_code.hpp"
#include "app/report.hpp"

namespace lancer::app {

int dump(const DumpCommand& command, const Console& console) {
  DiskHost host({}, console.interrupt);
  session::Session session(host);
  session::RunOptions options = command.run;
  options.interrupt = &console.interrupt;
  const session::Run run = command.ast ? parse_script(session, host, command.file)
                                       : run_script(session, host, command.file, options);
  report_mistakes(session, run, console);
  if (run.outcome != session::Outcome::fine) return exit_code_of(run.outcome);
  console.out.write(command.ast ? session.ast_dump() : scene::dump(session.scene()));
  console.out.flush();
  return k_fine;
}

}  // namespace lancer::app
