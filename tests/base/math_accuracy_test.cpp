// The functions of math.hpp against an oracle of more bits: every result is the nearest double.

#include <cmath>
#include <limits>

#ifdef LANCER_HAS_QUADMATH
#include <quadmath.h>
#endif

#include "base/math.hpp"
#include "catch.hpp"
#include "numbers.hpp"

namespace lancer {
namespace {

#ifdef LANCER_HAS_QUADMATH
using Real = __float128;
// The oracle's own error is about 2^-60 of an ulp of the result.
constexpr double k_slack = 0x1p-40;
Real o_sin(Real x) { return sinq(x); }
Real o_cos(Real x) { return cosq(x); }
Real o_tan(Real x) { return tanq(x); }
Real o_asin(Real x) { return asinq(x); }
Real o_acos(Real x) { return acosq(x); }
Real o_atan(Real x) { return atanq(x); }
Real o_atan2(Real y, Real x) { return atan2q(y, x); }
Real o_exp(Real x) { return expq(x); }
Real o_log(Real x) { return logq(x); }
Real o_cbrt(Real x) { return cbrtq(x); }
Real o_pow(Real x, Real y) { return powq(x, y); }
Real o_pi() { return 2 * asinq(1); }
#else
using Real = long double;
// 2^-11 ulp or more, depending on what long double is.
constexpr double k_slack = std::numeric_limits<long double>::digits > 53 ? 0x1p-6 : 1;
Real o_sin(Real x) { return std::sin(x); }
Real o_cos(Real x) { return std::cos(x); }
Real o_tan(Real x) { return std::tan(x); }
Real o_asin(Real x) { return std::asin(x); }
Real o_acos(Real x) { return std::acos(x); }
Real o_atan(Real x) { return std::atan(x); }
Real o_atan2(Real y, Real x) { return std::atan2(y, x); }
Real o_exp(Real x) { return std::exp(x); }
Real o_log(Real x) { return std::log(x); }
Real o_cbrt(Real x) { return std::cbrt(x); }
Real o_pow(Real x, Real y) { return std::pow(x, y); }
Real o_pi() { return 2 * std::asin(Real(1)); }
#endif

constexpr int k_count = 4000;

/// The distance of `result` from the truth in ulp of the truth, denormal ulps included.
double error_in_ulp(double result, Real truth) {
  const double rounded = std::fabs(static_cast<double>(truth));
  if (std::isinf(rounded)) return rounded == std::fabs(result) ? 0 : 1e300;
  const double ulp = rounded < 0x1p-1022 ? 0x1p-1074 : std::ldexp(1.0, std::ilogb(rounded) - 52);
  const Real difference = static_cast<Real>(result) - truth;
  return std::fabs(static_cast<double>(difference / static_cast<Real>(ulp)));
}

/// The worst error of many.
struct Worst {
  double error = 0, x = 0, y = 0;
  void see(double result, Real truth, double at_x, double at_y = 0) {
    const double e = error_in_ulp(result, truth);
    if (!(e <= error)) *this = {e, at_x, at_y};
  }
};

void check(const Worst& worst) {
  CAPTURE(worst.x, worst.y, worst.error);
  CHECK(worst.error <= 0.5 + k_slack);
}

/// An angle in radians within an eighth of a turn, and how many quarters it was turned by.
struct Turned {
  Real radians;
  int quarters;
};
Turned turned(double degrees) {
  int quarters = 0;
  const double rest = std::remquo(degrees, 90.0, &quarters);
  return {rest * o_pi() / 180, quarters & 3};
}

Real true_sin(double degrees, int ahead) {
  const Turned t = turned(degrees);
  const int quarters = (t.quarters + ahead) & 3;
  const Real s = (quarters & 1) != 0 ? o_cos(t.radians) : o_sin(t.radians);
  return (quarters & 2) != 0 ? -s : s;
}

Real true_tan(double degrees) {
  const Turned t = turned(degrees);
  return (t.quarters & 1) != 0 ? -1 / o_tan(t.radians) : o_tan(t.radians);
}

/// Ordinary angles, tiny and huge ones, and such near multiples of 45 degrees.
double some_angle(Numbers& n, int i) {
  switch (i % 4) {
    case 0: return n.uniform(-720, 720);
    case 1: return n.of_any_size(-400, 60);
    case 2: return 45 * n.whole(-12, 12) + n.of_any_size(-45, 0);
    default: return n.whole(-720, 720);
  }
}

/// Within [-1, 1], towards 0 and towards the ends.
double some_sine(Numbers& n, int i) {
  switch (i % 3) {
    case 0: return n.uniform(-1, 1);
    case 1: return n.of_any_size(-300, 0);
    default: return std::copysign(1 - std::fabs(n.of_any_size(-52, 0)), n.uniform(-1, 1));
  }
}

}  // namespace

TEST_CASE("math: sine, cosine and tangent of degrees are the nearest numbers", "[math]") {
  Numbers n(1);
  Worst sin, cos, tan;
  for (int i = 0; i < k_count; ++i) {
    const double a = some_angle(n, i);
    sin.see(math::sin_deg(a), true_sin(a, 0), a);
    cos.see(math::cos_deg(a), true_sin(a, 1), a);
    if (turned(a).radians != 0) tan.see(math::tan_deg(a), true_tan(a), a);
  }
  check(sin);
  check(cos);
  check(tan);
}

TEST_CASE("math: the inverse functions in degrees are the nearest numbers", "[math]") {
  Numbers n(2);
  Worst asin, acos, atan, atan2;
  const Real degree = 180 / o_pi();
  for (int i = 0; i < k_count; ++i) {
    const double s = some_sine(n, i);
    asin.see(math::asin_deg(s), o_asin(s) * degree, s);
    // Near 1 the oracle's acos loses bits of its own: the sine of the angle is known exactly to more.
    if (std::fabs(s) < 0.9) acos.see(math::acos_deg(s), o_acos(s) * degree, s);
    const double t = n.of_any_size(i % 2 == 0 ? -3 : -300, i % 2 == 0 ? 3 : 300);
    atan.see(math::atan_deg(t), o_atan(t) * degree, t);
    const int range = i % 2 == 0 ? 3 : 300;
    const double y = n.of_any_size(-range, range);
    const double x = n.of_any_size(-range, range);
    atan2.see(math::atan2_deg(y, x), o_atan2(y, x) * degree, y, x);
  }
  check(asin);
  check(acos);
  check(atan);
  check(atan2);
}

TEST_CASE("math: acos near 1 keeps all its bits", "[math]") {
  // acos(1 - d) = 2 asin(sqrt(d / 2)), where 1 - d and d are exact.
  Numbers n(3);
  Worst worst;
  for (int i = 0; i < k_count; ++i) {
    const double d = n.whole(1, 1 << 20) * 0x1p-52;
    const Real half = static_cast<Real>(d) / 2;
    const Real root = o_pow(half, Real(0.5));
    worst.see(math::acos_deg(1 - d), 2 * o_asin(root) * 180 / o_pi(), 1 - d);
  }
  check(worst);
}

TEST_CASE("math: exponentials and logarithms are the nearest numbers", "[math]") {
  Numbers n(4);
  Worst exp, log, log2, log10;
  const Real ln2 = o_log(2);
  const Real ln10 = o_log(10);
  for (int i = 0; i < k_count; ++i) {
    const double x = i % 3 == 0   ? n.uniform(-746, 710)
                     : i % 3 == 1 ? n.of_any_size(-50, 4)
                                  : n.uniform(-745.2, -708);
    exp.see(math::exp(x), o_exp(x), x);
    const double v = i % 3 == 0   ? std::fabs(n.of_any_size(-1074, 1024))
                     : i % 3 == 1 ? n.uniform(0.4, 4)
                                  : 1 + n.of_any_size(-50, -1);
    log.see(math::log(v), o_log(v), v);
    log2.see(math::log2(v), o_log(v) / ln2, v);
    log10.see(math::log10(v), o_log(v) / ln10, v);
  }
  check(exp);
  check(log);
  check(log2);
  check(log10);
}

TEST_CASE("math: powers and cube roots are the nearest numbers", "[math]") {
  Numbers n(5);
  Worst pow, cbrt;
  for (int i = 0; i < k_count; ++i) {
    double x = n.uniform(0, 2);
    double y = n.uniform(-50, 200);
    if (i % 4 == 1) {
      x = std::fabs(n.of_any_size(-1074, 1024));
      y = n.uniform(-1, 1);
    } else if (i % 4 == 2) {
      x = 1 + n.of_any_size(-30, -1);
      y = n.of_any_size(-10, 20);
    } else if (i % 4 == 3) {  // denormal results
      x = n.uniform(0.5, 1) * 0x1p-100;
      y = n.uniform(10.3, 10.7);
    }
    const Real truth = o_pow(x, y);
    if (truth < static_cast<Real>(1e308)) pow.see(math::pow(x, y), truth, x, y);
    const double c = i % 2 == 0 ? n.uniform(-8, 8) : n.of_any_size(-1074, 1024);
    cbrt.see(math::cbrt(c), o_cbrt(c), c);
  }
  check(pow);
  check(cbrt);
}

TEST_CASE("math: the curve of sRGB and its inverse are the nearest numbers", "[math]") {
  Numbers n(6);
  Worst decode, encode;
  const Real offset = Real(55) / 1000;
  const Real gain = Real(1055) / 1000;
  const Real slope = Real(1292) / 100;
  for (int i = 0; i < k_count; ++i) {
    const double v = n.uniform(0, 1);
    decode.see(math::srgb_to_linear(v), v <= 0.04045 ? v / slope : o_pow((v + offset) / gain, Real(24) / 10),
               v);
    encode.see(math::linear_to_srgb(v), v <= 0.0031308 ? v * slope : gain * o_pow(v, Real(10) / 24) - offset,
               v);
  }
  check(decode);
  check(encode);
}

}  // namespace lancer
