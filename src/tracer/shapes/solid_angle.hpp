#pragma once
// How often the facets of a closed mesh run around a point: the solid angles that they fill as seen from it
// add up to 1 inside and 0 outside. No sum of facets on a ray decides that. Where rounding would - next to a
// facet, to an edge's line, to a corner - signs are exact and angles have 192 bits.

#include "tracer/shapes/facet.hpp"

namespace lancer::tracer {

/// What a point sees of a facet.
struct Seen {
  bool touched = false;  // the point is exactly on the facet, its rim included
  double turns = 0;      // else the solid angle in full spheres, positive where the point sees its back
};
Seen seen_from(const FacetPrimitive& facet, Vec3 p);

/// The solid angle as seen from the very first of a ray that starts at p, exactly on the facet: that of the
/// facet as it is next to p, a plane, half of one or a sector. A ray within the facet is taken to run beside
/// it as rim.hpp has it.
double turns_ahead(const FacetPrimitive& facet, Vec3 p, Vec3 direction);

}  // namespace lancer::tracer
