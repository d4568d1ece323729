#pragma once
// In place of the tracer's own: the plain test, in sphere.cpp.

#include "tracer/shapes/sphere.hpp"

namespace lancer::tracer {

Roots roots(const SpherePrimitive& sphere, const Probe& probe);

}  // namespace lancer::tracer
