#include "image/tone.hpp"

#include <cmath>
#include <limits>

#include "base/math.hpp"
#include "catch.hpp"

using lancer::image::ToneCurve;
namespace math = lancer::math;

namespace {

int exact(double light, int codes) {
  return static_cast<int>(std::round(math::linear_to_srgb(light) * codes));
}

/// How many of the floats within `reach` steps of `light` get a code other than the exact one.
template <class Curve>
int wrong_around(double light, int reach, int codes, Curve code_of) {
  float from = static_cast<float>(light);
  for (int i = 0; i < reach; ++i) from = std::nextafter(from, 0.0F);
  int wrong = 0;
  for (int i = 0; i <= 2 * reach; ++i) {
    if (from <= 1 && int{code_of(from)} != exact(from, codes)) ++wrong;
    from = std::nextafter(from, 2.0F);
  }
  return wrong;
}

}  // namespace

TEST_CASE("tone: values worked out by hand", "[tone]") {
  const ToneCurve curve(1);
  // 1.055 * 0.5^(1/2.4) - 0.055 = 0.735357: times 255 is 187.516, times 65535 is 48191.62.
  CHECK(int{curve.to_8bit(0.5F)} == 188);
  CHECK(int{curve.to_16bit(0.5F)} == 48192);
  // 0.25: 0.5370987, 136.960 and 35198.77.
  CHECK(int{curve.to_8bit(0.25F)} == 137);
  CHECK(int{curve.to_16bit(0.25F)} == 35199);
  // 1/512 is on the straight part: 12.92 / 512 = 0.025234375, 6.435 and 1653.73.
  CHECK(int{curve.to_8bit(0.001953125F)} == 6);
  CHECK(int{curve.to_16bit(0.001953125F)} == 1654);
}

TEST_CASE("tone: what is outside 0 to 1 is clamped, and no number is black", "[tone]") {
  const ToneCurve curve(1);
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float light : {0.0F, -0.0F, -1.0F, -infinity, std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::denorm_min()}) {
    CHECK(int{curve.to_8bit(light)} == 0);
    CHECK(int{curve.to_16bit(light)} == 0);
  }
  for (const float light : {1.0F, 1.0000001F, 7.0F, std::numeric_limits<float>::max(), infinity}) {
    CHECK(int{curve.to_8bit(light)} == 255);
    CHECK(int{curve.to_16bit(light)} == 65535);
  }
}

TEST_CASE("tone: the exposure multiplies before the clamp", "[tone]") {
  CHECK(int{ToneCurve(2).to_8bit(0.25F)} == 188);    // as 0.5 above
  CHECK(int{ToneCurve(0.25).to_8bit(2.0F)} == 188);  // not clamped first
  CHECK(int{ToneCurve(0.25).to_16bit(2.0F)} == 48192);
  CHECK(int{ToneCurve(1e300).to_8bit(1.0F)} == 255);
  CHECK(int{ToneCurve(1e-300).to_8bit(1.0F)} == 0);
}

TEST_CASE("tone: the 8-bit code is the exact one around every place where it changes", "[tone]") {
  const ToneCurve curve(1);
  for (int code = 1; code <= 255; ++code) {
    CAPTURE(code);
    CHECK(wrong_around(math::srgb_to_linear((code - 0.5) / 255), 20, 255,
                       [&](float x) { return curve.to_8bit(x); }) == 0);
    CHECK(int{curve.to_8bit(static_cast<float>(math::srgb_to_linear(code / 255.0)))} == code);
  }
}

TEST_CASE("tone: the 8-bit code changes at the very double where the exact one does", "[tone]") {
  for (int code = 1; code <= 255; ++code) {
    double light = math::srgb_to_linear((code - 0.5) / 255);
    while (exact(light, 255) >= code) light = std::nextafter(light, 0.0);
    const double next = std::nextafter(light, 1.0);
    REQUIRE(exact(next, 255) == code);
    // White under an exposure lets any double reach the curve.
    CAPTURE(code);
    CHECK(int{ToneCurve(light).to_8bit(1.0F)} == code - 1);
    CHECK(int{ToneCurve(next).to_8bit(1.0F)} == code);
  }
}

TEST_CASE("tone: the 16-bit code is the exact one around every place where it changes", "[tone]") {
  const ToneCurve curve(1);
  int wrong = 0;
  for (int code = 1; code <= 65535; ++code) {
    wrong += wrong_around(math::srgb_to_linear((code - 0.5) / 65535), 1, 65535,
                          [&](float x) { return curve.to_16bit(x); });
  }
  CHECK(wrong == 0);
  // Where the straight part of the curve meets the other.
  CHECK(wrong_around(0.0031308, 200, 65535, [&](float x) { return curve.to_16bit(x); }) == 0);
}
