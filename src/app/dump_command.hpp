#pragma once
// lancer dump: what Lancer makes of a script.

#include "app/command_line.hpp"
#include "app/console.hpp"

namespace lancer::app {

/// The exit code.
int dump(const DumpCommand& command, const Console& console);

}  // namespace lancer::app
