#pragma once
// Numbers for the rare questions that rounding must not answer: whether a ray that all but touches a surface
// meets it, and where.

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

#include "base/vec.hpp"
#include "tracer/triple.hpp"

namespace lancer::tracer {

/// A floating-point number of 192 bits, for quotients and roots; its range of exponents is beyond need.
using Wide = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<192, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

/// A whole number times a power of two. Every finite double is one, and sums and products of such are exact,
/// whatever their sizes.
class Exact {
 public:
  Exact() = default;
  Exact(double value) {  // NOLINT: a double is one of these
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    whole_ = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    exponent_ = exponent - 53;
  }

  int sign() const { return whole_.sign(); }

  friend Exact operator-(const Exact& a) { return {-a.whole_, a.exponent_}; }
  friend Exact operator*(const Exact& a, const Exact& b) {
    return {a.whole_ * b.whole_, a.exponent_ + b.exponent_};
  }
  friend Exact operator+(const Exact& a, const Exact& b) {
    if (a.sign() == 0) return b;
    if (b.sign() == 0) return a;
    if (a.exponent_ < b.exponent_) return b + a;
    return {(a.whole_ << (a.exponent_ - b.exponent_)) + b.whole_, b.exponent_};
  }
  friend Exact operator-(const Exact& a, const Exact& b) { return a + -b; }
  friend bool operator<(const Exact& a, const Exact& b) { return (a - b).sign() < 0; }

  /// Rounded to 192 bits.
  Wide wide() const { return ldexp(Wide(whole_), exponent_); }

 private:
  using Whole = boost::multiprecision::number<
      boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude,
                                             boost::multiprecision::unchecked>,
      boost::multiprecision::et_off>;

  Exact(Whole whole, int exponent) : whole_(std::move(whole)), exponent_(exponent) {}

  Whole whole_ = 0;
  int exponent_ = 0;
};

inline Triple<Exact> exact(Vec3 v) { return {v.x, v.y, v.z}; }
inline Triple<Wide> wide(const Triple<Exact>& v) { return {v.x.wide(), v.y.wide(), v.z.wide()}; }
inline Vec3 rounded(const Triple<Wide>& v) {
  return {v.x.convert_to<double>(), v.y.convert_to<double>(), v.z.convert_to<double>()};
}

}  // namespace lancer::tracer
