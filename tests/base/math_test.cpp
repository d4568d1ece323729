// The places of the functions of math.hpp at which the result is known exactly.

#include "base/math.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "catch.hpp"

namespace lancer {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

bool is_plus_zero(double v) { return v == 0 && !std::signbit(v); }

}  // namespace

TEST_CASE("math: sines and cosines of multiples of 30 and 90 degrees are exact", "[math]") {
  for (const double turn : {-1e6 * 360, -360.0, 0.0, 360.0, 720.0, 1e9 * 360}) {
    CAPTURE(turn);
    CHECK(is_plus_zero(math::sin_deg(turn)));
    CHECK(is_plus_zero(math::sin_deg(turn + 180)));
    CHECK(is_plus_zero(math::sin_deg(turn - 180)));
    CHECK(is_plus_zero(math::cos_deg(turn + 90)));
    CHECK(is_plus_zero(math::cos_deg(turn - 90)));
    CHECK(math::sin_deg(turn + 90) == 1);
    CHECK(math::sin_deg(turn + 270) == -1);
    CHECK(math::cos_deg(turn) == 1);
    CHECK(math::cos_deg(turn + 180) == -1);
    CHECK(math::sin_deg(turn + 30) == 0.5);
    CHECK(math::sin_deg(turn + 150) == 0.5);
    CHECK(math::sin_deg(turn + 210) == -0.5);
    CHECK(math::sin_deg(turn + 330) == -0.5);
    CHECK(math::cos_deg(turn + 60) == 0.5);
    CHECK(math::cos_deg(turn + 120) == -0.5);
    CHECK(math::cos_deg(turn + 240) == -0.5);
    CHECK(math::cos_deg(turn + 300) == 0.5);
  }
  CHECK(is_plus_zero(math::sin_deg(-0.0)));
}

TEST_CASE("math: sines of other whole degrees, from tables", "[math]") {
  // Abramowitz and Stegun, table 4.10: 15 digits are enough to fix the double.
  CHECK(math::sin_deg(45) == 0.7071067811865476);
  CHECK(math::cos_deg(45) == 0.7071067811865476);
  CHECK(math::sin_deg(1) == 0.017452406437283512);
  CHECK(math::cos_deg(30) == 0.8660254037844386);
  CHECK(math::tan_deg(30) == 0.5773502691896257);
}

TEST_CASE("math: tangents are exact at multiples of 45 degrees", "[math]") {
  for (const double turn : {-720.0, -180.0, 0.0, 180.0, 3600.0}) {
    CAPTURE(turn);
    CHECK(is_plus_zero(math::tan_deg(turn)));
    CHECK(math::tan_deg(turn + 45) == 1);
    CHECK(math::tan_deg(turn - 45) == -1);
    CHECK(std::isinf(math::tan_deg(turn + 90)));
  }
  CHECK(is_plus_zero(math::tan_deg(-0.0)));
}

TEST_CASE("math: the inverse functions are exact where the angle is known", "[math]") {
  const std::vector<std::pair<double, double>> sines{{-1, -90}, {-0.5, -30}, {0.5, 30}, {1, 90}};
  for (const auto& [s, angle] : sines) {
    CHECK(math::asin_deg(s) == angle);
    CHECK(math::acos_deg(s) == 90 - angle);
  }
  CHECK(is_plus_zero(math::asin_deg(0)));
  CHECK(is_plus_zero(math::asin_deg(-0.0)));
  CHECK(math::acos_deg(0) == 90);
  CHECK(is_plus_zero(math::acos_deg(1)));
  CHECK(math::atan_deg(1) == 45);
  CHECK(math::atan_deg(-1) == -45);
  CHECK(is_plus_zero(math::atan_deg(0)));
  CHECK(math::atan_deg(1e300) == 90);
  CHECK(math::atan_deg(-k_infinity) == -90);
}

TEST_CASE("math: atan2 knows its quadrants", "[math]") {
  for (const double size : {1e-300, 3.0, 1e300}) {
    CAPTURE(size);
    CHECK(is_plus_zero(math::atan2_deg(0, size)));
    CHECK(math::atan2_deg(size, size) == 45);
    CHECK(math::atan2_deg(size, 0) == 90);
    CHECK(math::atan2_deg(size, -size) == 135);
    CHECK(math::atan2_deg(0, -size) == 180);
    CHECK(math::atan2_deg(-0.0, -size) == 180);
    CHECK(math::atan2_deg(-size, -size) == -135);
    CHECK(math::atan2_deg(-size, 0) == -90);
    CHECK(math::atan2_deg(-size, size) == -45);
  }
  CHECK(is_plus_zero(math::atan2_deg(0, 0)));
  CHECK(math::atan2_deg(1e300, 1e-300) == 90);
  CHECK(math::atan2_deg(1e-300, -1e300) == 180);
  CHECK(math::atan2_deg(1e-300, 1e300) == 0);
  CHECK(math::atan2_deg(k_infinity, -k_infinity) == 135);
}

TEST_CASE("math: angles in the other unit", "[math]") {
  CHECK(math::radians(180) == 3.141592653589793);
  CHECK(math::radians(-90) == -1.5707963267948966);
  CHECK(math::degrees(3.141592653589793) == 180);
  CHECK(math::radians(0) == 0);
  CHECK(math::degrees(1.7e308) == k_infinity);
  CHECK(math::radians(1.7e308) == 2.9670597283903604e306);  // 1.7 pi / 180 = 0.029670597283903604
  CHECK(math::radians(5e-324) == 0);                        // 0.017 of the least number
  CHECK(math::degrees(5e-324) == 57 * 5e-324);              // 57.3
}

TEST_CASE("math: exponentials and logarithms at known places", "[math]") {
  CHECK(math::exp(0) == 1);
  CHECK(math::exp(1) == 2.718281828459045);
  CHECK(math::exp(-1e-300) == 1);
  CHECK(math::exp(709.782712893384) == 1.7976931348622732e308);  // ln of the largest number, rounded down
  CHECK(math::exp(709.7827128933841) == k_infinity);
  CHECK(math::exp(-745.1332191019411) == 5e-324);
  CHECK(math::exp(-745.1332191019412) == 0);  // below half the least number
  CHECK(is_plus_zero(math::log(1)));
  CHECK(math::log(0) == -k_infinity);
  CHECK(std::isnan(math::log(-1)));
  CHECK(math::log(10) == 2.302585092994046);
  for (int e = -1074; e < 1024; ++e) {
    if (math::log2(std::ldexp(1.0, e)) != e) FAIL_CHECK(e);
  }
  double ten = 1;
  for (int e = 0; e <= 22; ++e, ten *= 10) {
    if (math::log10(ten) != e) FAIL_CHECK(e);
  }
}

TEST_CASE("math: powers are exact where the result is", "[math]") {
  CHECK(math::pow(2, 10) == 1024);
  CHECK(math::pow(-2, 3) == -8);
  CHECK(math::pow(-2, -2) == 0.25);
  CHECK(math::pow(10, 22) == 1e22);
  CHECK(math::pow(10, -3) == 0.001);
  CHECK(math::pow(9, 0.5) == 3);
  CHECK(math::pow(9, 1.5) == 27);
  CHECK(math::pow(2.25, 2.5) == 7.59375);  // 1.5^5
  CHECK(math::pow(2, 0.5) == std::sqrt(2.0));
  CHECK(math::pow(2, -1074) == 5e-324);
  CHECK(math::pow(2, 1023) == 0x1p1023);
  CHECK(math::pow(2, 1024) == k_infinity);
  for (int base = 2; base <= 50; ++base) {
    double product = base;  // exact while below 2^53
    for (int n = 2; product * base < 0x1p53; ++n) {
      product *= base;
      CAPTURE(base, n);
      CHECK(math::pow(base, n) == product);
      CHECK(math::pow(product, 1.0 / n) == Approx(base).epsilon(1e-15));
    }
  }
}

TEST_CASE("math: powers halfway between two numbers go to the even one", "[math]") {
  // 7^19 = 11398895185373143 lies halfway between ...142 and ...144, of significands 2^53 and more; 144 / 2
  // is even.
  CHECK(math::pow(7, 19) == 11398895185373144.0);
  CHECK(math::pow(49, 9.5) == 11398895185373144.0);
  // 134217729^2 = (2^27 + 1)^2 = 2^54 + 2^28 + 1: a quarter above a multiple of 4, not a tie; 94906267^2 has
  // 54 bits: 9007199515875289 = 2 * 4503599757937644 + 1, a tie, and 4503599757937644 is even.
  CHECK(math::pow(134217729, 2) == 18014398777917440.0);
  CHECK(math::pow(94906267, 2) == 9007199515875288.0);
  // 2^-1075 is half the least number: a tie, to 0. 3 * 2^-1075 lies between 1 and 2 of them, to 2; 1.5^2 is
  // 9/4, and 9 * 2^-1076 = 2.25 * 2^-1074 is no tie.
  CHECK(math::pow(2, -1075) == 0);
  CHECK(math::pow(0x1.8p-537, 2) == 2 * 5e-324);
}

TEST_CASE("math: powers at the ends follow C", "[math]") {
  CHECK(math::pow(0, 0) == 1);
  CHECK(math::pow(-5, 0) == 1);
  CHECK(math::pow(1, k_infinity) == 1);
  CHECK(math::pow(0, 2) == 0);
  CHECK(math::pow(0, -1) == k_infinity);
  CHECK(math::pow(-0.0, -1) == -k_infinity);
  CHECK(std::signbit(math::pow(-0.0, 3)));
  CHECK(std::isnan(math::pow(-8, 1.0 / 3)));
  CHECK(math::pow(-1, 9007199254740993.0) == 1);   // rounded to an even number
  CHECK(math::pow(-1, 9007199254740991.0) == -1);  // 2^53 - 1
  CHECK(math::pow(-1, k_infinity) == 1);
  CHECK(math::pow(0.5, k_infinity) == 0);
  CHECK(math::pow(0.5, -k_infinity) == k_infinity);
  CHECK(math::pow(-k_infinity, 3) == -k_infinity);
  CHECK(math::pow(-k_infinity, -3) == 0);
  CHECK(math::pow(1e300, 1e300) == k_infinity);
  CHECK(math::pow(1e300, -1e300) == 0);
  CHECK(math::pow(0.999, 1e300) == 0);
  CHECK(math::pow(1 + 0x1p-52, 1e-300) == 1);
}

TEST_CASE("math: cube roots of cubes are exact", "[math]") {
  for (int i = 1; i <= 2000; ++i) {
    const double cube = static_cast<double>(i) * i * i;
    if (math::cbrt(cube) != i || math::cbrt(-cube) != -i ||
        math::cbrt(std::ldexp(cube, -900)) != std::ldexp(i, -300)) {
      FAIL_CHECK(i);
    }
  }
  CHECK(math::cbrt(0) == 0);
  CHECK(math::cbrt(0x1p-1074) == 0x1p-358);
  CHECK(math::cbrt(k_infinity) == k_infinity);
}

TEST_CASE("math: the sRGB curve at known places", "[math]") {
  CHECK(math::srgb_to_linear(0) == 0);
  CHECK(math::srgb_to_linear(1) == 1);
  CHECK(math::linear_to_srgb(0) == 0);
  CHECK(math::linear_to_srgb(1) == 1);
  CHECK(math::srgb_to_linear(0.04045) == Approx(0.04045 / 12.92).epsilon(1e-15));
  CHECK(math::srgb_to_linear(0.5) == Approx(0.21404114048223255).epsilon(1e-14));
  CHECK(math::linear_to_srgb(0.5) == Approx(0.7353569830524495).epsilon(1e-14));
  for (int i = 0; i <= 65535; ++i) {
    const double v = i / 65535.0;
    if (std::fabs(math::linear_to_srgb(math::srgb_to_linear(v)) - v) > 1e-15) FAIL_CHECK(i);
  }
}

TEST_CASE("math: what is no number stays none", "[math]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (auto* f : {math::sin_deg, math::cos_deg, math::tan_deg, math::asin_deg, math::acos_deg, math::atan_deg,
                  math::exp, math::log, math::log2, math::log10, math::cbrt, math::radians, math::degrees}) {
    CHECK(std::isnan(f(nan)));
  }
  CHECK(std::isnan(math::pow(nan, 2)));
  CHECK(std::isnan(math::pow(2, nan)));
  CHECK(std::isnan(math::atan2_deg(nan, 1)));
  for (const double wide : {1.0000000000000002, -2.0}) {
    CHECK(std::isnan(math::asin_deg(wide)));
    CHECK(std::isnan(math::acos_deg(wide)));
  }
  CHECK(std::isnan(math::sin_deg(k_infinity)));
}

}  // namespace lancer
