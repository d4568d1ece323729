#pragma once
// Ways to test a ray against a plane.

#include <vector>

#include "stress/contest/harness.hpp"

namespace lancer::stress {

std::vector<Method> plane_methods();

}  // namespace lancer::stress
