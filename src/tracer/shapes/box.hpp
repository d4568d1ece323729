#pragma once
// Boxes: one slab test in the box's own frame. A box that lies along the axes of the world is tested there;
// any other in the space where it is the cube [-1, 1]^3, with the error of the way there carried along.

#include "tracer/aabb.hpp"
#include "tracer/shapes/landing.hpp"
#include "tracer/shapes/linear_map.hpp"

namespace lancer::tracer {

/// Aligned: the points x within [lo, hi]. Turned: those with to_own (x - center) within it.
struct BoxPrimitive {
  Vec3 lo{-1, -1, -1}, hi{1, 1, 1};
  bool aligned = true;
  Vec3 center;
  Rows to_own{};        // offsets from the centre to the cube's space
  Rows to_world{};      // and back
  Rows normals{};       // of the upper sides, unit length
  Vec3 reach{1, 1, 1};  // sums of the magnitudes in the rows of to_own
  double slack = 0;     // how far rounding may have moved the surface, in world units
};

/// Rays through edges and corners, and such as lie in a side's plane, hit. Of two sides at the same distance
/// the one across the lower axis counts.
Roots roots(const BoxPrimitive& box, const Probe& probe);
Root exit(const BoxPrimitive& box, Vec3 origin, Vec3 direction);
Landing land(const BoxPrimitive& box, Vec3 origin, Vec3 direction, const Root& root);
Vec3 normal(const BoxPrimitive& box, int face);
/// The point of the face next to p.
Vec3 project(const BoxPrimitive& box, Vec3 p, int face);
Aabb bounds(const BoxPrimitive& box);
/// < 0 inside, 0 exactly on the surface, > 0 outside.
double side(const BoxPrimitive& box, Vec3 p);

}  // namespace lancer::tracer
