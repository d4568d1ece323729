#pragma once
// How much of a light reaches a point.

#include "base/color.hpp"
#include "tracer/intersect.hpp"
#include "tracer/plan.hpp"

namespace lancer::tracer {

/// The share of light that comes through along the ray, over `distance` (infinite for a sun): opaque, 0 or 1;
/// filtered, the product of the plain transmission of all surfaces in between that cast shadows. With
/// `any_hit` the first that lets nothing through ends the search; without, all are found.
Color light_through(const World& world, ShadowWork work, const Ray& ray, double distance, Stats& stats,
                    bool any_hit = true);

}  // namespace lancer::tracer
