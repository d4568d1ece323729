#pragma once
// Rays exactly through the edges and corners of a closed mesh. There it matters how many facets are crossed:
// an odd number takes the ray from one side to the other, an even one does not. So such a ray counts as one
// that runs beside it, moved by next to nothing, always in the same way: that one meets no edge and no
// corner, and its crossings alternate. After H. Edelsbrunner and E. P. Muecke, "Simulation of Simplicity"
// (ACM Transactions on Graphics, 1990): the ray is moved by <e, e^2, e^3> for an e that is nearly 0.

#include "tracer/shapes/facet.hpp"

namespace lancer::tracer {

/// Does the moved ray's line cross the facet? Exact. Never where the ray runs in the facet's plane.
bool is_crossed_beside(const FacetPrimitive& facet, Vec3 origin, Vec3 direction);

/// On which side of the plane through 0 with this normal, in which the ray runs, the moved one does: the sign
/// of normal . <e, e^2, e^3>.
template <class Number>
int sign_beside(const Number& x, const Number& y, const Number& z) {
  return x.sign() != 0 ? x.sign() : y.sign() != 0 ? y.sign() : z.sign();
}

}  // namespace lancer::tracer
