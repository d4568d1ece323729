#include "stress/methods/plane.hpp"

#include <cmath>

#include "stress/methods/found.hpp"

namespace lancer::stress {
namespace {

using tracer::PlanePrimitive;

Found at(double depth, double slope) {
  const double t = depth / slope;
  if (!(t > 0) || !std::isfinite(t)) return {};
  return {true, slope < 0, t};
}

/// With the plane as n . x = constant, and a slope and a distance that count as nothing.
Found naive(const PlanePrimitive& plane, Vec3 origin, Vec3 direction) {
  const double constant = plane.level + dot(plane.normal, plane.point);
  const double slope = dot(plane.normal, direction);
  if (std::fabs(slope) < k_epsilon) return {};
  const Found found = at(constant - dot(plane.normal, origin), slope);
  return found.t > k_epsilon ? found : Found{};
}

Found plain(const PlanePrimitive& plane, Vec3 origin, Vec3 direction) {
  return at(plane.level - dot(plane.normal, origin - plane.point), dot(plane.normal, direction));
}

/// n . v + w, rounded as if from twice the precision (Ogita, Rump, Oishi 2005: Dot2).
double compensated_dot(Vec3 n, Vec3 v, double w) {
  double sum = w, rest = 0;
  for (int i = 0; i < 3; ++i) {
    const DoubleDouble product = two_product(n[i], v[i]);
    const DoubleDouble next = two_sum(sum, product.hi);
    sum = next.hi;
    rest += next.lo + product.lo;
  }
  return sum + rest;
}

/// The same, where v = a - b is rounded too.
double compensated_dot(Vec3 n, Vec3 a, Vec3 b, double w) {
  double sum = w, rest = 0;
  for (int i = 0; i < 3; ++i) {
    const DoubleDouble v = two_sum(a[i], -b[i]);
    const DoubleDouble product = two_product(n[i], v.hi);
    const DoubleDouble next = two_sum(sum, product.hi);
    sum = next.hi;
    rest += next.lo + (product.lo + n[i] * v.lo);
  }
  return sum + rest;
}

Found compensated(const PlanePrimitive& plane, Vec3 origin, Vec3 direction) {
  return at(-compensated_dot(plane.normal, origin, plane.point, -plane.level),
            compensated_dot(plane.normal, direction, 0));
}

DdFound in_double_double(const PlanePrimitive& plane, Vec3 origin, Vec3 direction) {
  const DoubleDouble slope = dot(plane.normal, dd(direction));
  if (slope.hi == 0) return {};
  const DoubleDouble depth = plane.level - dot(plane.normal, difference(origin, plane.point));
  const DoubleDouble t = depth / slope;
  if (!(t.hi > 0) || !std::isfinite(t.hi)) return {};
  return {true, slope.hi < 0, t};
}

struct Plane {
  using Primitive = tracer::PlanePrimitive;
  static const Primitive& of(const tracer::World& world) { return world.planes[0]; }
  static Vec3 normal(const Primitive& plane, Vec3) { return normalize(plane.normal); }
  static Vec3 normal(const Primitive& plane, Vec3, const Dd3&) { return unit(dd(plane.normal)); }
};

}  // namespace

std::vector<Method> plane_methods() {
  return {plain_method<Plane, naive>("naive"), plain_method<Plane, plain>("plain"),
          plain_method<Plane, compensated>("compensated"), double_double_method<Plane, in_double_double>()};
}

}  // namespace lancer::stress
