#include "catch.hpp"
#include "stress/random.hpp"
#include "stress/stress.hpp"
#include "stress/truth/first_hit.hpp"
#include "stress/truth/ulp.hpp"

namespace lancer::stress {
namespace {

tracer::SpherePrimitive sphere(Vec3 center, double radius) {
  tracer::SpherePrimitive out;
  out.center = center;
  out.radius = radius;
  return out;
}

tracer::PlanePrimitive plane(Vec3 point, Vec3 normal, double level) {
  tracer::PlanePrimitive out;
  out.point = point;
  out.normal = normal;
  out.level = level;
  return out;
}

double above_one(int ulps) { return 1 + ulps * 0x1p-52; }

}  // namespace

TEST_CASE("truth: a sphere is met where it is first reached, and from inside where it is left", "[stress]") {
  // Offset by 3 of the radius 5: the half chord is 4.
  const Truth entry = first_hit(sphere({10, 0, 0}, 5), {{0, 3, 0}, {1, 0, 0}, false});
  CHECK(entry.hit);
  CHECK(entry.entering);
  CHECK(ulps(6, entry.t) == 0);
  CHECK(to_vec3(entry.point) == Vec3{6, 3, 0});
  CHECK(to_double(entry.normal.x) == -0.8);
  const Truth exit = first_hit(sphere({10, 0, 0}, 5), {{10, 3, 0}, {1, 0, 0}, false});
  CHECK(exit.hit);
  CHECK_FALSE(exit.entering);
  CHECK(ulps(4, exit.t) == 0);
  CHECK_FALSE(first_hit(sphere({10, 0, 0}, 5), {{20, 3, 0}, {1, 0, 0}, false}).hit);
}

TEST_CASE("truth: a line that touches hits, one that is an ulp further out misses, both within the band",
          "[stress]") {
  const Truth touch = first_hit(sphere({}, 1), {{-3, 1, 0}, {1, 0, 0}, false});
  CHECK(touch.hit);
  CHECK(ulps(3, touch.t) == 0);
  CHECK(touch.in_band);
  const Truth past = first_hit(sphere({}, 1), {{-3, above_one(1), 0}, {1, 0, 0}, false});
  CHECK_FALSE(past.hit);
  CHECK(past.in_band);
  // 4 ulp of the offset, and 4 of the radius below 1: 8 make it touch, 20 are out of reach.
  CHECK(first_hit(sphere({}, 1), {{-3, above_one(7), 0}, {1, 0, 0}, false}).in_band);
  CHECK_FALSE(first_hit(sphere({}, 1), {{-3, above_one(20), 0}, {1, 0, 0}, false}).in_band);
}

TEST_CASE("truth: next to nothing across an exactly touching ray decides", "[stress]") {
  // The line turns away from the sphere, or towards it, by the least angle that a double can hold.
  CHECK_FALSE(first_hit(sphere({}, 1), {{-3, 1, 0}, {1, 0x1p-1074, 0}, false}).hit);
  CHECK(first_hit(sphere({}, 1), {{-3, 1, 0}, {1, -0x1p-1074, 0}, false}).hit);
}

TEST_CASE("truth: a ray that leaves a sphere outwards misses it, inwards it meets the far side", "[stress]") {
  CHECK_FALSE(first_hit(sphere({}, 1), {{1, 0, 0}, {1, 0, 0}, true}).hit);
  const Truth through = first_hit(sphere({}, 1), {{1, 0, 0}, {-1, 0, 0}, true});
  CHECK(through.hit);
  CHECK_FALSE(through.entering);
  CHECK(ulps(2, through.t) == 0);
}

TEST_CASE("truth: an ellipsoid is a sphere in its own space", "[stress]") {
  // Half axes 2, 1, 4 around (1, 0, 0).
  tracer::EllipsoidPrimitive e;
  e.center = {1, 0, 0};
  e.to_own = {Vec3{0.5, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 0.25}};
  const Truth hit = first_hit(e, {{-9, 0, 0}, {1, 0, 0}, false});
  CHECK(hit.hit);
  CHECK(ulps(8, hit.t) == 0);
  CHECK(to_vec3(hit.normal) == Vec3{-1, 0, 0});
  CHECK_FALSE(first_hit(e, {{-9, 1.001, 0}, {1, 0, 0}, false}).hit);
}

TEST_CASE("truth: what it says of a sphere solves the equation of the sphere", "[stress]") {
  int hits = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    Random random(1, "residual", i);
    const Vec3 center = random.in_cube(1e6), away = random.direction();
    const auto s = sphere(center, random.over_scales(1e-3, 1e3));
    const Vec3 origin = s.center + away * (s.radius * random.over_scales(0.1, 1e6));
    const Vec3 aim = s.center + random.in_ball() * s.radius;
    const Truth truth = first_hit(s, {origin, normalize(aim - origin), false});
    if (!truth.hit) continue;
    ++hits;
    const Real3 from_center = truth.point - real(s.center);
    CHECK(to_double(abs(length(from_center) / Real(s.radius) - 1)) < 1e-150);
    CHECK(to_double(abs(length(truth.normal) - 1)) < 1e-150);
    CHECK(truth.entering == (to_double(dot(truth.normal, truth.point - real(origin))) < 0));
  }
  CHECK(hits > 150);
}

TEST_CASE("truth: a plane is met ahead, but not by rays in it", "[stress]") {
  // y = 1 + 2.
  const auto p = plane({5, 1, 5}, {0, 1, 0}, 2);
  const Truth down = first_hit(p, {{0, 7, 0}, {0.6, -0.8, 0}, false});
  CHECK(down.hit);
  CHECK(down.entering);
  CHECK(ulps(5, down.t) <= 0.5);  // 4 / 0.8, but for the rounding of 0.8
  CHECK_FALSE(first_hit(p, {{0, 7, 0}, {0.6, 0.8, 0}, false}).hit);
  CHECK_FALSE(first_hit(p, {{0, 3, 0}, {1, 0, 0}, false}).hit);
  CHECK_FALSE(first_hit(p, {{0, 7, 0}, {1, -0x1p-1074, 0}, false}).hit);  // beyond all doubles
  CHECK_FALSE(first_hit(p, {{0, 3, 0}, {0.6, -0.8, 0}, true}).hit);
}

TEST_CASE("ulps: of distances and of the worst component of points", "[stress]") {
  CHECK(ulps(above_one(3), Real(1)) == 3);
  CHECK(ulps(2 - 0x1p-52, Real(2)) == 0.5);  // an ulp of the doubles below is half of one of those above
  CHECK(std::isinf(ulps(std::numeric_limits<double>::quiet_NaN(), Real(1))));
  CHECK(ulps(Vec3{1, above_one(2), 1}, real({1, 1, 1})) == 2);
  // A component that all but cancels: 2^-60 of the largest, off by itself, is 2^-60 / (2^-40 2^-52).
  CHECK(ulps(Vec3{1, 0, 0}, real({1, 0x1p-60, 0})) == 0x1p32);
}

TEST_CASE("errors: the largest, and that of a share of the rays", "[stress]") {
  Errors errors;
  CHECK(std::isnan(errors.largest()));
  for (int i = 1000; i >= 1; --i) errors.add(i);
  CHECK(errors.largest() == 1000);
  CHECK(errors.at(0.999) == 999);
  CHECK(errors.at(0.5) == 500);
}

TEST_CASE("stress: rows are chosen by patterns, and a limit that was not measured is missed", "[stress]") {
  CHECK(matches("sphere.far", "sphere.far"));
  CHECK(matches("sphere.*", "sphere.far"));
  CHECK(matches("*.f?r", "sphere.far"));
  CHECK_FALSE(matches("sphere", "sphere.far"));
  CHECK_FALSE(matches("*.fa", "sphere.far"));
  CHECK(Limit{"distance", 1, 1}.met());
  CHECK_FALSE(Limit{"distance", 1.001, 1}.met());
  CHECK_FALSE(Limit{"distance", Measure().distance_max, 1}.met());
}

}  // namespace lancer::stress
