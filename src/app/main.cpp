// lancer: scenes from scripts, pictures from scenes.

#include <new>
#include <string>
#include <variant>
#include <vector>

#include "app/check_command.hpp"
#include "app/command_line.hpp"
#include "app/console.hpp"
#include "app/dump_command.hpp"
#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/plan_command.hpp"
#include "app/render_command.hpp"
#include "app/repl/repl.hpp"

namespace lancer::app {
namespace {

int answer(const Answer& answer, const Console& console) {
  if (answer.exit_code != k_fine) {
    say(answer.text);
  } else {
    console.out.write(answer.text);
    console.out.flush();
  }
  return answer.exit_code;
}

int run(const Command& command, const Console& console) {
  if (const auto* c = std::get_if<RenderCommand>(&command)) return render(*c, console);
  if (const auto* c = std::get_if<CheckCommand>(&command)) return check(*c, console);
  if (const auto* c = std::get_if<DumpCommand>(&command)) return dump(*c, console);
  if (const auto* c = std::get_if<PlanCommand>(&command)) return plan(*c, console);
  if (const auto* c = std::get_if<ReplCommand>(&command)) return repl(*c, console);
  return answer(std::get<Answer>(command), console);
}

int run(std::vector<std::string> arguments) {
  const std::atomic<bool>& interrupt = watch_for_interrupts();
  Output out(interrupt);
  const Console console = make_console(out, interrupt);
  try {
    return run(parse_command_line(std::move(arguments)), console);
  } catch (const OutputError& problem) {
    complain(problem.what());
    return k_file_trouble;
  } catch (const Stopped&) {
    complain("interrupted");
    return k_interrupted;
  } catch (const std::bad_alloc&) {
    complain("there is not enough memory for this");
    return k_file_trouble;
  }
}

}  // namespace
}  // namespace lancer::app

int main(int argc, char** argv) {
  return lancer::app::run(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc));
}
