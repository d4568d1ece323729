#pragma once
// Methods that are made of a test of a ray against the one primitive of a world.
//
// The Kind of primitive has Primitive, of(world), and normal() twice: of a primitive and the point of the hit
// in plain arithmetic; and of a primitive, the start of the ray and the way from there to the hit in
// double-double.

#include <vector>

#include "stress/contest/harness.hpp"
#include "stress/methods/dd3.hpp"

namespace lancer::stress {

/// What a test took for the first hit.
struct Found {
  bool hit = false;
  bool entering = true;
  double t = 0;
};

/// The roots t0 <= t1 as the first one beyond `least`.
inline Found first_beyond(double t0, double t1, double least) {
  if (t0 > least) return {true, true, t0};
  if (t1 > least) return {true, false, t1};
  return {};
}

/// The smallest distance that counts as a hit, where a program has such a thing.
inline constexpr double k_epsilon = 1e-6;

template <class Kind, class Test>
double time_of(const std::vector<Timed>& rays, Test test) {
  return best_nanoseconds(rays, [test](const Timed& timed) {
    return test(Kind::of(*timed.world), timed.probe.origin, timed.probe.direction);
  });
}

/// The point and the normal as most programs make them.
template <class Kind, Found (*test)(const typename Kind::Primitive&, Vec3, Vec3)>
Method plain_method(const char* name) {
  const auto answer = [](const tracer::World& world, const tracer::Ray& ray) -> Answer {
    const auto& primitive = Kind::of(world);
    const Found found = test(primitive, ray.origin, ray.direction);
    if (!found.hit) return {};
    const Vec3 point = ray.origin + ray.direction * found.t;
    return {true, found.entering, found.t, point, Kind::normal(primitive, point)};
  };
  return {name, false, answer, [](const std::vector<Timed>& rays) {
            return time_of<Kind>(rays, [](const auto& p, Vec3 o, Vec3 d) { return test(p, o, d).t; });
          }};
}

/// All of it in twice the precision.
template <class Kind, DdFound (*test)(const typename Kind::Primitive&, Vec3, Vec3)>
Method double_double_method() {
  const auto answer = [](const tracer::World& world, const tracer::Ray& ray) -> Answer {
    const auto& primitive = Kind::of(world);
    const DdFound found = test(primitive, ray.origin, ray.direction);
    if (!found.hit) return {};
    const Dd3 way = dd(ray.direction) * found.t;
    return {true, found.entering, found.t.hi, rounded(dd(ray.origin) + way),
            Kind::normal(primitive, ray.origin, way)};
  };
  return {"double-double", false, answer, [](const std::vector<Timed>& rays) {
            return time_of<Kind>(rays, [](const auto& p, Vec3 o, Vec3 d) { return test(p, o, d).t.hi; });
          }};
}

}  // namespace lancer::stress
