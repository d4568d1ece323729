#pragma once
// Boxes: one slab test in the box's own frame. A box that lies along the axes of the world is tested there;
// any other in a frame whose origin is the box's centre.

#include <array>

#include "tracer/aabb.hpp"

namespace lancer::tracer {

struct BoxPrimitive {
  Vec3 lo, hi;                     // in the frame of the test
  bool aligned = true;             // that frame is the world's
  Vec3 center;                     // else: the frame's origin in the world,
  std::array<Vec3, 3> to_own{};    // and the map of offsets from it, in rows
  std::array<Vec3, 3> to_world{};  // and back
  double slack = 0;                // how far rounding may have moved the surface, in world units
};

/// Rays through edges and corners, and such as lie in a side's plane, hit.
Roots roots(const BoxPrimitive& box, const Probe& probe);
Root exit(const BoxPrimitive& box, Vec3 origin, Vec3 direction);
Vec3 normal(const BoxPrimitive& box, int face);
/// The point of the face next to p.
Vec3 project(const BoxPrimitive& box, Vec3 p, int face);
Aabb bounds(const BoxPrimitive& box);
double side(const BoxPrimitive& box, Vec3 p);

}  // namespace lancer::tracer
