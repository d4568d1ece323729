#pragma once
// In place of the tracer's own: the plain test, in plane.cpp.

#include "tracer/shapes/plane.hpp"

namespace lancer::tracer {

Roots roots(const PlanePrimitive& plane, const Probe& probe);

}  // namespace lancer::tracer
