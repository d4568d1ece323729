#include "stress/methods/ellipsoid.hpp"

#include "stress/methods/sphere.hpp"

namespace lancer::stress {
namespace {

using tracer::EllipsoidPrimitive;

Vec3 to_own(const EllipsoidPrimitive& e, Vec3 v) { return tracer::apply(e.to_own, v); }
Vec3 transposed(const EllipsoidPrimitive& e, Vec3 v) { return tracer::apply_transposed(e.to_own, v); }

/// As with a matrix of four rows: the origin of the world is where the numbers are small.
Found naive(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction) {
  const Vec3 own = to_own(e, origin) - to_own(e, e.center);
  return naive_quadratic(own, to_own(e, direction), 1, k_epsilon);
}

Found naive_without_epsilon(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction) {
  return naive_quadratic(to_own(e, origin - e.center), to_own(e, direction), 1, 0);
}

Found gems(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction) {
  return gems_quadratic(to_own(e, origin - e.center), to_own(e, direction), 1);
}

Dd3 to_own(const EllipsoidPrimitive& e, const Dd3& v) {
  return {dot(e.to_own[0], v), dot(e.to_own[1], v), dot(e.to_own[2], v)};
}

DdFound in_double_double(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction) {
  return dd_quadratic(to_own(e, difference(origin, e.center)), to_own(e, dd(direction)), 1);
}

struct Ellipsoid {
  using Primitive = tracer::EllipsoidPrimitive;
  static const Primitive& of(const tracer::World& world) { return world.ellipsoids[0]; }
  static Vec3 normal(const Primitive& e, Vec3 point) {
    return normalize(transposed(e, to_own(e, point - e.center)));
  }
  static Vec3 normal(const Primitive& e, Vec3 origin, const Dd3& way) {
    const Dd3 own = to_own(e, difference(origin, e.center) + way);
    return unit(dd(e.to_own[0]) * own.x + dd(e.to_own[1]) * own.y + dd(e.to_own[2]) * own.z);
  }
};

}  // namespace

std::vector<Method> ellipsoid_methods() {
  return {plain_method<Ellipsoid, naive>("naive"),
          plain_method<Ellipsoid, naive_without_epsilon>("naive, no epsilon"),
          plain_method<Ellipsoid, gems>("Ray Tracing Gems 7"),
          double_double_method<Ellipsoid, in_double_double>()};
}

}  // namespace lancer::stress
