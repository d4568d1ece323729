#pragma once
// The hard rays for planes.

#include <vector>

#include "stress/harness.hpp"

namespace lancer::stress {

/// Adds the rows of planes.
void add_plane_rows(Rows& rows, const std::vector<Method>& methods, const Oracle& oracle);

}  // namespace lancer::stress
