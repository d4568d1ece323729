#pragma once
// Facets to aim at, and the points on and about them.

#include <functional>

#include "stress/contest/field.hpp"
#include "stress/truth/facet.hpp"

namespace lancer::stress::flat {

/// About one unit across, neither thin nor small.
FacetNumbers any_facet(Random& random);

/// a A + b B + c C.
Vec3 at(const FacetNumbers& f, double a, double b, double c);
Vec3 inside(const FacetNumbers& f, Random& random);
/// Anywhere near the facet, on it in about half of the cases.
Vec3 near(const FacetNumbers& f, Random& random);
double size_of(const FacetNumbers& f);
Vec3 plane_normal(const FacetNumbers& f);

/// The point of an edge, corner 0 to 2, and the direction in the facet's plane away from the facet.
struct Rim {
  Vec3 point, away;
};
Rim rim(const FacetNumbers& f, int edge, double share);
Rim any_rim(const FacetNumbers& f, Random& random);

Subject subject(const FacetNumbers& f, std::function<Line(Random&)> ray);

}  // namespace lancer::stress::flat
