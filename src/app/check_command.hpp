#pragma once
// lancer check: everything but the drawing.

#include "app/command_line.hpp"
#include "app/console.hpp"

namespace lancer::app {

/// The exit code.
int check(const CheckCommand& command, const Console& console);

}  // namespace lancer::app
