#pragma once
// Cuts a range of references in two where the binned surface area heuristic says so (Wald 2007: On fast
// construction of SAH-based bounding volume hierarchies).

#include <utility>

#include "tracer/tree/references.hpp"

namespace lancer::tracer {

/// Both parts hold something; the range has at least two references. Where the grid does not tell the centres
/// apart, and where `in_halves` is set, the parts are of equal size.
std::pair<Range, Range> split(References& references, const Range& range, bool in_halves);

}  // namespace lancer::tracer
