#pragma once
// The numbers of the truth: MPFR's, of some 660 bits, behind Boost.Multiprecision. Nothing here is shared
// with the tracer.

#include <boost/multiprecision/mpfr.hpp>

#include "base/vec.hpp"

namespace lancer::stress {

/// 200 decimal digits; each operation is rounded correctly.
using Real = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<200, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

/// Enough digits for sums of products of four doubles to be exact, whatever their exponents.
using Exact = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<5200>,
                                            boost::multiprecision::et_off>;

/// A vector of either.
template <class Number>
struct Triple {
  Number x, y, z;

  const Number& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  Number& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }

  friend Triple operator+(const Triple& a, const Triple& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Triple operator-(const Triple& a, const Triple& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Triple operator*(const Triple& a, const Number& s) { return {a.x * s, a.y * s, a.z * s}; }
  friend Triple operator/(const Triple& a, const Number& s) { return {a.x / s, a.y / s, a.z / s}; }
  friend Number dot(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend Triple cross(const Triple& a, const Triple& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};
using Real3 = Triple<Real>;

/// The doubles as they are.
template <class Number>
Triple<Number> as(Vec3 v) {
  return {Number(v.x), Number(v.y), Number(v.z)};
}
inline Real3 real(Vec3 v) { return as<Real>(v); }

inline Real length(const Real3& v) { return sqrt(dot(v, v)); }
inline Real3 normalized(const Real3& v) { return v / length(v); }
inline double to_double(const Real& value) { return value.convert_to<double>(); }
inline Vec3 to_vec3(const Real3& v) { return {to_double(v.x), to_double(v.y), to_double(v.z)}; }

}  // namespace lancer::stress
