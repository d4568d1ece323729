#include "tracer/shapes/facet.hpp"

namespace lancer::tracer {

/// Moeller and Trumbore (Fast, Minimum Storage Ray/Triangle Intersection, 1997).
Roots roots(const FacetPrimitive& facet, const Probe& probe) {
  const Vec3 e1 = facet.b - facet.a, e2 = facet.c - facet.a;
  const Vec3 p = cross(probe.direction, e2);
  const double determinant = dot(e1, p);
  if (determinant == 0) return {};
  const double inverse = 1 / determinant;
  const Vec3 s = probe.origin - facet.a;
  const double u = dot(s, p) * inverse;
  if (u < 0 || u > 1) return {};
  const Vec3 q = cross(s, e1);
  const double v = dot(probe.direction, q) * inverse;
  if (v < 0 || u + v > 1) return {};
  return {1, {Root{dot(e2, q) * inverse, 0, (determinant > 0) != facet.flipped}, {}}};
}

Landing land(const FacetPrimitive& facet, Vec3 origin, Vec3 direction, const Root& root) {
  return {root, 0, 0, origin + direction * root.t, normal(facet)};
}

Vec3 project(const FacetPrimitive&, Vec3 p) { return p; }

bool touches(const FacetPrimitive&, Vec3, double) { return false; }

Vec3 normal_of_corners(const FacetPrimitive& facet) {
  const Vec3 n = cross(facet.b - facet.a, facet.c - facet.a);
  return n / (length(n) * (facet.flipped ? -1 : 1));
}

Barycentric barycentric(const FacetPrimitive& facet, Vec3 p) {
  const Vec3 n = cross(facet.b - facet.a, facet.c - facet.a);
  const double inverse = 1 / dot(n, n);
  const double v = dot(n, cross(p - facet.a, facet.c - facet.a)) * inverse;
  const double w = dot(n, cross(facet.b - facet.a, p - facet.a)) * inverse;
  return {1 - v - w, v, w};
}

Aabb bounds(const FacetPrimitive& facet) {
  Aabb box;
  box.add(facet.a);
  box.add(facet.b);
  box.add(facet.c);
  return box.padded(facet.slack);
}

}  // namespace lancer::tracer
