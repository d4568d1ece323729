#pragma once
// The last step of building: nodes are put in the order in which a walk comes to them, whichever thread made
// which of them when.

#include "tracer/tree/build.hpp"

namespace lancer::tracer {

/// The first frame is the whole tree's.
Tree arrange(Tree tree);

}  // namespace lancer::tracer
