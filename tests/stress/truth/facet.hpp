#pragma once
// The truth about a ray and a facet: hit or miss by exact signs, everything else in MPFR.

#include "stress/truth/number.hpp"
#include "tracer/shapes/facet.hpp"

namespace lancer::stress::flat {

/// A ray's first meeting with one surface or solid.
struct Truth {
  bool hit = false;
  Real t;
  Real3 point, normal;  // the normal outward, of unit length
  bool entering = false;
  int face = 0;  // of a box: 2 axis, + 1 for the upper side
};

struct FacetNumbers {
  Vec3 a, b, c;
  bool flipped = false;  // the outward normal is (c-a) x (b-a)
};
inline FacetNumbers numbers_of(const tracer::FacetPrimitive& f) { return {f.a, f.b, f.c, f.flipped}; }

/// A ray exactly through an edge or a corner hits; one in the facet's plane misses, and so does what lies at
/// its start or behind it.
Truth facet_truth(const FacetNumbers& facet, Vec3 origin, Vec3 direction);

/// Might the ray do otherwise, were each number of the ray and the facet off by up to 4 ulp?
bool facet_in_band(const FacetNumbers& facet, Vec3 origin, Vec3 direction);

/// Does the line of the ray cross the facet, edges and corners included, at whichever distance?
bool facet_crossed(const FacetNumbers& facet, Vec3 origin, Vec3 direction);

/// 4 ulp of each component.
Vec3 four_ulp(Vec3 v);

}  // namespace lancer::stress::flat
