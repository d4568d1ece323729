#pragma once
// Views by the names that users give.

#include <cstddef>
#include <string>

#include "session/session.hpp"

namespace lancer::app {

/// The place of the view among session.views(). Throws UsageError, with the names there are.
std::size_t find_view(const session::Session& session, const std::string& name);

}  // namespace lancer::app
