#pragma once
// Vectors of double-doubles, for the methods that always use them.

#include "base/double_double.hpp"
#include "base/vec.hpp"

namespace lancer::stress {

struct Dd3 {
  DoubleDouble x, y, z;
};

inline Dd3 dd(Vec3 v) { return {{v.x, 0}, {v.y, 0}, {v.z, 0}}; }
/// a - b exactly.
inline Dd3 difference(Vec3 a, Vec3 b) { return {two_sum(a.x, -b.x), two_sum(a.y, -b.y), two_sum(a.z, -b.z)}; }
inline Dd3 operator+(const Dd3& a, const Dd3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Dd3 operator*(const Dd3& a, DoubleDouble s) { return {a.x * s, a.y * s, a.z * s}; }
inline DoubleDouble dot(const Dd3& a, const Dd3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline DoubleDouble dot(Vec3 a, const Dd3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 rounded(const Dd3& v) { return {v.x.hi, v.y.hi, v.z.hi}; }
inline Vec3 unit(const Dd3& v) {
  const DoubleDouble size = sqrt(dot(v, v));
  return {(v.x / size).hi, (v.y / size).hi, (v.z / size).hi};
}

/// The first root beyond 0 of the quadratic of a sphere around the origin, all in double-double.
struct DdFound {
  bool hit = false;
  bool entering = true;
  DoubleDouble t;
};
inline DdFound dd_quadratic(const Dd3& f, const Dd3& d, double radius) {
  const DoubleDouble a = dot(d, d), b = -dot(f, d), r2 = two_product(radius, radius);
  const Dd3 from_axis = f + d * (b / a);
  const DoubleDouble inside = r2 - dot(from_axis, from_axis);
  if (inside.hi < 0) return {};
  const DoubleDouble root = sqrt(inside * a);
  const DoubleDouble q = b.hi < 0 ? b - root : b + root;
  const DoubleDouble c = dot(f, f) - r2;
  const DoubleDouble one = q / a, other = c / q;
  const bool in_order = b.hi < 0;
  const DoubleDouble near = in_order ? one : other, far = in_order ? other : one;
  if (near.hi > 0) return {true, true, near};
  if (far.hi > 0) return {true, false, far};
  return {};
}

}  // namespace lancer::stress
