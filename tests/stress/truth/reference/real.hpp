#pragma once
// Numbers of 50 decimal digits with an exponent that never overflows, and vectors of them: what the reference
// tracer reckons in. Doubles go in exactly.

#include <boost/multiprecision/mpfr.hpp>

#include "base/vec.hpp"

namespace lancer::reference {

using Real = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<50, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

struct Vector {
  Real x = 0, y = 0, z = 0;
  const Real& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  Real& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
};

inline Vector exact(Vec3 v) { return {v.x, v.y, v.z}; }
inline Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
inline Vector operator*(const Vector& a, const Real& s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vector operator/(const Vector& a, const Real& s) { return {a.x / s, a.y / s, a.z / s}; }
inline Real dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real length(const Vector& a) { return sqrt(dot(a, a)); }
inline Vector unit(const Vector& a) { return a / length(a); }
inline Real largest(const Vector& a) {
  const Real x = abs(a.x), y = abs(a.y), z = abs(a.z);
  return x > y ? (x > z ? x : z) : (y > z ? y : z);
}

/// Of an angle in degrees, in radians.
inline Real radians(const Real& degrees) { return degrees * acos(Real(-1)) / 180; }

}  // namespace lancer::reference
