#pragma once
// The surfaces that may be the first that a ray meets, by the quick tests of their kinds and the bounds of
// those.

#include <cstdint>

#include "tracer/candidates.hpp"
#include "tracer/options.hpp"
#include "tracer/world.hpp"

namespace lancer::tracer {

/// A facet that the ray passes by its rim within rounding.
struct Passed {
  std::uint32_t primitive = 0;
  Root root;  // where
};
using PassedList = SmallList<Passed, 8>;

/// What a search finds.
struct Found {
  Candidates candidates;
  PassedList passed;
};

/// `ray` meets nothing right where it starts.
void search(const World& world, const Ray& ray, Stats& stats, Found& found);

}  // namespace lancer::tracer
