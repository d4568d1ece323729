#include "tracer/optics.hpp"

#include "base/math.hpp"
#include "catch.hpp"

using namespace lancer;
using namespace lancer::tracer;

namespace {

/// Arriving at the surface z = 0 from above, `angle` from the normal.
Vec3 arriving(double angle) { return {math::sin_deg(angle), 0, -math::cos_deg(angle)}; }
const Vec3 k_up{0, 0, 1};

}  // namespace

TEST_CASE("optics: the mirror direction has the angle of incidence", "[optics]") {
  const Vec3 r = mirrored(arriving(30), k_up);
  CHECK(r.x == Approx(0.5));
  CHECK(r.z == Approx(math::cos_deg(30)));
}

TEST_CASE("optics: the direction after refraction obeys Snell's law", "[optics]") {
  for (const double angle : {1.0, 30.0, 60.0, 89.0}) {
    const auto t = refracted(arriving(angle), k_up, 1, 1.5);
    REQUIRE(t);
    CHECK(t->x * 1.5 == Approx(math::sin_deg(angle)).epsilon(1e-14));
    CHECK(t->z < 0);
    CHECK(length(*t) == Approx(1).epsilon(1e-15));
  }
}

TEST_CASE("optics: straight on and between equal indices nothing bends", "[optics]") {
  CHECK(*refracted({0, 0, -1}, k_up, 1, 1.5) == Vec3{0, 0, -1});
  const Vec3 d = arriving(53);
  CHECK(*refracted(d, k_up, 1.7, 1.7) == d);
}

TEST_CASE("optics: beyond the critical angle all light is reflected", "[optics]") {
  const double critical = math::asin_deg(1 / 1.5);  // 41.81 degrees
  CHECK(refracted(arriving(critical - 0.001), k_up, 1.5, 1));
  CHECK_FALSE(refracted(arriving(critical + 0.001), k_up, 1.5, 1));
  CHECK(fresnel(arriving(critical + 0.001), k_up, 1.5, 1) == 1);
}

TEST_CASE("optics: reflectance straight on is the square of (n1 - n2)/(n1 + n2)", "[optics]") {
  CHECK(fresnel({0, 0, -1}, k_up, 1, 1.5) == Approx(0.04).epsilon(1e-14));
  CHECK(fresnel({0, 0, -1}, k_up, 2.4, 1.33) == Approx(math::pow(1.07 / 3.73, 2)).epsilon(1e-13));
  CHECK(fresnel(arriving(70), k_up, 1.5, 1.5) == 0);
}

TEST_CASE("optics: reflectance at 45 degrees from air into glass", "[optics]") {
  // sin t = sin 45 / 1.5, cos t = sqrt(7)/3. rs = (c - 1.5 ct)/(c + 1.5 ct) with c = sqrt(1/2), 1.5 ct =
  // sqrt(7)/2: rs = (sqrt2 - sqrt7)/(sqrt2 + sqrt7) = -0.3033706, rp = rs^2 at 45 degrees (sign aside); F =
  // (rs^2 + rs^4)/2.
  const double rs = (std::sqrt(2.0) - std::sqrt(7.0)) / (std::sqrt(2.0) + std::sqrt(7.0));
  CHECK(fresnel(arriving(45), k_up, 1, 1.5) == Approx((rs * rs + rs * rs * rs * rs) / 2).epsilon(1e-13));
  CHECK(fresnel(arriving(45), k_up, 1, 1.5) == Approx(0.0502399).epsilon(1e-5));
}

TEST_CASE("optics: at Brewster's angle only half of what is polarised across comes back", "[optics]") {
  // tan b = 1.5; rp = 0, rs = (1 - n^2)/(1 + n^2) = -1.25/3.25.
  const double brewster = math::atan_deg(1.5);
  CHECK(fresnel(arriving(brewster), k_up, 1, 1.5) == Approx(1.25 / 3.25 * (1.25 / 3.25) / 2).epsilon(1e-12));
}

TEST_CASE("optics: reflectance is the same both ways", "[optics]") {
  const Vec3 in = arriving(37);
  const Vec3 out = *refracted(in, k_up, 1.2, 1.9);
  CHECK(fresnel(in, k_up, 1.2, 1.9) == Approx(fresnel(-out, -k_up, 1.9, 1.2)).epsilon(1e-13));
}
