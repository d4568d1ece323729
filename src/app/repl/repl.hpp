#pragma once
// lancer repl: a scene is built by talking.

#include "app/command_line.hpp"
#include "app/console.hpp"

namespace lancer::app {

/// Reads entries and commands from standard input until its end; the exit code. Without a terminal there is
/// no prompt, and the first error ends it unless the command says otherwise.
int repl(const ReplCommand& command, const Console& console);

}  // namespace lancer::app
