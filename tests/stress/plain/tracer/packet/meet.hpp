#pragma once
// In place of the tracer's own: the plain tests, four lanes at a time. Every answer is taken for
// right: nothing is in doubt, and no error is known.

#include "tracer/packet/surfaces.hpp"

namespace lancer::tracer::LANCER_TARGET {

/// Of a convex solid that is crossed at `in` and `leave`.
LANCER_INLINE bool cross(Mask crossed, Lanes in, Lanes leave, Crossings& out) {
  out.crossed = crossed;
  if (!any(crossed)) return false;
  out.entering = mask(in > lanes(0.0));
  out.t = select(out.entering, in, leave);
  out.out_t = leave;
  out.met = crossed & mask(out.t > lanes(0.0));
  out.clear = lanes(k_infinity);
  return true;
}

LANCER_INLINE bool meet(const Spheres& sphere, const Probes& p, Mask asked, Crossings& out) {
  const Vectors f = p.origin - sphere.center;
  const Lanes b = dot(f, p.direction);
  const Lanes discriminant = b * b - (dot(f, f) - sphere.radius * sphere.radius);
  const Mask hits = asked & mask(discriminant >= lanes(0.0));
  if (!any(hits)) return false;
  const Lanes half = square_root(discriminant);
  return cross(hits, -b - half, half - b, out);
}

LANCER_INLINE bool meet(const PlanePrimitive& plane, const Probes& p, Mask asked, Crossings& out) {
  const Vectors n = vectors(plane.normal);
  const Lanes slope = dot(n, p.direction);
  out.t = (lanes(plane.level) - dot(n, p.origin - vectors(plane.point))) / slope;
  out.entering = mask(slope < lanes(0.0));
  out.met = asked & mask(out.t > lanes(0.0)) & is_finite(out.t);
  return true;
}

/// Moeller and Trumbore (Fast, Minimum Storage Ray/Triangle Intersection, 1997).
LANCER_INLINE bool meet(const Facets& facet, const Probes& ray, Mask asked, Crossings& out) {
  const auto cross = [](const Vectors& a, const Vectors& b) {
    return Vectors{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  const Lanes none = lanes(0.0), one = lanes(1.0);
  const Vectors e1 = facet.b - facet.a, e2 = facet.c - facet.a;
  const Vectors p = cross(ray.direction, e2);
  const Lanes determinant = dot(e1, p), inverse = one / determinant;
  const Vectors s = ray.origin - facet.a;
  const Lanes u = dot(s, p) * inverse;
  Mask hits = asked & mask(u >= none) & mask(u <= one);
  if (!any(hits)) return false;
  const Vectors q = cross(s, e1);
  const Lanes v = dot(ray.direction, q) * inverse;
  hits &= mask(v >= none) & mask(u + v <= one);
  out.t = dot(e2, q) * inverse;
  out.entering = mask(determinant > none) ^ facet.flipped;
  out.slope = one;
  out.crossed = hits;
  out.met = hits & mask(out.t > none);
  return true;
}

/// One by one.
LANCER_INLINE bool meet(const Other& other, const Probes& p, Mask asked, Crossings& out) {
  for (int i = 0; i < 4; ++i) {
    if (asked[i] == 0) continue;
    const FirstRoot first =
        first_root(other.world, other.primitive, {p.origin.x[i], p.origin.y[i], p.origin.z[i]},
                   {p.direction.x[i], p.direction.y[i], p.direction.z[i]});
    out.met[i] = first.met ? -1 : 0;
    out.crossed[i] = first.crossed ? -1 : 0;
    out.entering[i] = first.entering ? -1 : 0;
    out.t[i] = first.t;
  }
  return any(out.met | out.crossed);
}

}  // namespace lancer::tracer::LANCER_TARGET
