#pragma once
// Triangles, alone or of a mesh.

#include <cstdint>

#include "tracer/aabb.hpp"
#include "tracer/shapes/landing.hpp"

namespace lancer::tracer {

struct FacetPrimitive {
  Vec3 a, b, c;            // in the world
  Vec3 normal;             // outward, unit length
  bool flipped = false;    // a mirroring transform: the outward normal is (c-a) x (b-a)
  std::uint32_t face = 0;  // of a mesh: which
  double slack = 0;        // how far rounding may have moved the surface
};

/// Weights of the three corners; they sum to 1.
struct Barycentric {
  double a = 0, b = 0, c = 0;
};

/// The test of Woop, Benthin and Wald (Watertight Ray/Triangle Intersection, JCGT 2013), with a bound of what
/// rounding does to its edge functions, beyond which their signs are found exactly: a ray at an edge or
/// corner that facets share hits every one of them. A ray in the facet's plane misses.
Roots roots(const FacetPrimitive& facet, const Probe& probe);
/// Is p on the facet, give or take the tolerance?
bool touches(const FacetPrimitive& facet, Vec3 p, double tolerance);
Landing land(const FacetPrimitive& facet, Vec3 origin, Vec3 direction, const Root& root);
inline Vec3 normal(const FacetPrimitive& facet) { return facet.normal; }
/// The outward unit normal of the corners, to the last bit; 0 where they are on a line.
Vec3 normal_of_corners(const FacetPrimitive& facet);
Vec3 project(const FacetPrimitive& facet, Vec3 p);
/// Of a point on the facet; within [0, 1].
Barycentric barycentric(const FacetPrimitive& facet, Vec3 p);
Aabb bounds(const FacetPrimitive& facet);

}  // namespace lancer::tracer
