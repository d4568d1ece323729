#pragma once
// Ctrl-C: the first asks the work to stop, the second ends the program at once.

#include <atomic>

namespace lancer::app {

/// From now on SIGINT and SIGTERM set the flag that is returned. SIGPIPE is ignored: a reader that went away
/// shows as a failed write.
const std::atomic<bool>& watch_for_interrupts();
/// What was asked to stop has stopped, and the program goes on.
void forget_interrupt();

}  // namespace lancer::app
