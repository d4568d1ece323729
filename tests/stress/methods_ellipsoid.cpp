#include "stress/methods_ellipsoid.hpp"

#include "stress/dd3.hpp"
#include "stress/methods_sphere.hpp"

namespace lancer::stress {
namespace {

using tracer::EllipsoidPrimitive;

Vec3 to_own(const EllipsoidPrimitive& e, Vec3 v) {
  return {dot(e.to_own[0], v), dot(e.to_own[1], v), dot(e.to_own[2], v)};
}
Vec3 transposed(const EllipsoidPrimitive& e, Vec3 v) {
  return e.to_own[0] * v.x + e.to_own[1] * v.y + e.to_own[2] * v.z;
}

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

template <Found (*test)(const EllipsoidPrimitive&, Vec3, Vec3)>
Answer plain_answer(const tracer::World& world, const tracer::Ray& ray) {
  const EllipsoidPrimitive& e = world.ellipsoids[0];
  const Found found = test(e, ray.origin, ray.direction);
  if (!found.hit) return {};
  const Vec3 point = ray.origin + ray.direction * found.t;
  return {true, found.entering, found.t, point, normalize(transposed(e, to_own(e, point - e.center)))};
}

template <Found (*test)(const EllipsoidPrimitive&, Vec3, Vec3)>
Method plain_method(const char* name) {
  return {name, false, plain_answer<test>, [](const std::vector<Timed>& rays) {
            return best_nanoseconds(rays, [](const Timed& timed) {
              return test(timed.world->ellipsoids[0], timed.probe.origin, timed.probe.direction).t;
            });
          }};
}

Answer double_double_answer(const tracer::World& world, const tracer::Ray& ray) {
  const EllipsoidPrimitive& e = world.ellipsoids[0];
  const DdFound found = in_double_double(e, ray.origin, ray.direction);
  if (!found.hit) return {};
  const Dd3 way = dd(ray.direction) * found.t;
  const Dd3 own = to_own(e, difference(ray.origin, e.center) + way);
  const Dd3 normal = dd(e.to_own[0]) * own.x + dd(e.to_own[1]) * own.y + dd(e.to_own[2]) * own.z;
  return {true, found.entering, found.t.hi, rounded(dd(ray.origin) + way), unit(normal)};
}

double double_double_time(const std::vector<Timed>& rays) {
  return best_nanoseconds(rays, [](const Timed& timed) {
    return in_double_double(timed.world->ellipsoids[0], timed.probe.origin, timed.probe.direction).t.hi;
  });
}

}  // namespace

std::vector<Method> ellipsoid_methods() {
  return {plain_method<naive>("naive"), plain_method<naive_without_epsilon>("naive, no epsilon"),
          plain_method<gems>("Ray Tracing Gems 7"),
          Method{"double-double", false, double_double_answer, double_double_time}};
}

}  // namespace lancer::stress
