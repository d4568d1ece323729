#include "app/repl/repl.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <utility>

#include "app/exit_code.hpp"
#include "app/interrupt.hpp"
#include "app/option_values.hpp"
#include "app/repl/commands.hpp"
#include "app/repl/lines.hpp"
#include "app/report.hpp"

namespace lancer::app {
namespace {

constexpr const char* k_greeting =
    "Lancer: type statements to build a scene, :help for what there is, :quit to leave.\n";

class Repl {
 public:
  Repl(const ReplCommand& command, const Console& console)
      : command_(command),
        talk_(console, command.run),
        is_prompted_(isatty(STDIN_FILENO) == 1 && console.out.is_terminal()) {
    talk_.options = command.options;
  }

  int run() {
    if (is_prompted_) talk_.tell(k_greeting);
    if (!command_.file.empty() && !take([&] { open_command(talk_, {command_.file}); })) {
      if (!is_prompted_) return failed_;
    }
    while (!talk_.is_over) {
      if (!step() && !is_prompted_ && !command_.keep_going) return failed_;
    }
    return is_prompted_ ? k_fine : failed_;
  }

 private:
  /// Reads one entry or command and does it; false where that failed.
  bool step() {
    std::optional<std::string> line = ask(pending_.empty() ? "> " : ". ");
    if (!line) return finish();
    if (pending_.empty() && line->find_first_not_of(" \t\r") == std::string::npos) return true;
    if (pending_.empty() && line->starts_with(':'))
      return take([&] { run_command(talk_, std::string_view(*line).substr(1)); });
    pending_ += (pending_.empty() ? "" : "\n") + *line;
    return take([&] { enter(false); });
  }

  /// The end of input: what is still incomplete stays so, and is told as the mistake that it is.
  bool finish() {
    talk_.is_over = true;
    if (is_prompted_) talk_.tell("\n");
    return pending_.empty() || take([&] { enter(true); });
  }

  void enter(bool is_last) {
    const std::string entry = std::exchange(pending_, {});
    const session::Reply reply = talk_.document.enter(entry, talk_.run);
    if (reply.is_incomplete && !is_last) {
      pending_ = entry;
    } else {
      talk_.answer(reply);
    }
  }

  std::optional<std::string> ask(const char* prompt) {
    for (;;) {
      try {
        if (is_prompted_) talk_.tell(prompt);
        std::optional<std::string> line = lines_.next();
        interruptions_ = 0;
        return line;
      } catch (const Stopped&) {
        if (!is_prompted_) throw;
        forget_interrupt();
        const bool is_fresh = pending_.empty();
        pending_.clear();
        if (is_fresh && ++interruptions_ == 2) return std::nullopt;
        talk_.tell(is_fresh ? "\n(once more, or Ctrl-D, leaves)\n" : "\n");
        prompt = "> ";
      }
    }
  }

  /// Does it and says what went wrong; false where something did.
  template <class F>
  bool take(const F& what) {
    try {
      what();
      return true;
    } catch (const UsageError& problem) {
      say(fmt::format("{}\n", problem.what()));
    } catch (const Refused&) {
    } catch (const Stopped&) {
      if (!is_prompted_) throw;
      forget_interrupt();
      say("stopped; all is as it was\n");
    }
    failed_ = k_script_wrong;
    return false;
  }

  const ReplCommand& command_;
  Talk talk_;
  bool is_prompted_;
  Lines lines_;
  std::string pending_;  // an entry that is not complete yet
  int interruptions_ = 0;
  int failed_ = k_fine;
};

}  // namespace

int repl(const ReplCommand& command, const Console& console) { return Repl(command, console).run(); }

}  // namespace lancer::app
