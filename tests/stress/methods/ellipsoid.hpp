#pragma once
// Ways to test a ray against an ellipsoid: all carry it into the space where that is the unit sphere.

#include <vector>

#include "stress/contest/harness.hpp"

namespace lancer::stress {

std::vector<Method> ellipsoid_methods();

}  // namespace lancer::stress
