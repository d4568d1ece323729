#pragma once
// Runs a script for a command, and says how that went.

#include <string>

#include "app/console.hpp"
#include "app/disk_host.hpp"
#include "session/session.hpp"

namespace lancer::app {

/// What messages call a script from standard input.
inline constexpr const char* k_input_name = "<stdin>";

session::Run run_script(session::Session& session, DiskHost& host, const std::string& file,
                        const session::RunOptions& options);
/// Only parsed, without its includes.
session::Run parse_script(session::Session& session, DiskHost& host, const std::string& file);

int exit_code_of(session::Outcome outcome);

/// Errors, warnings and problems to standard error, as people read them.
void report(const session::Session& session, const session::Run& run, const Console& console);
/// The same, but for names that are not used: of those `check` tells.
void report_mistakes(const session::Session& session, session::Run run, const Console& console);

}  // namespace lancer::app
