#include "stress/methods/sphere.hpp"

#include <cmath>

namespace lancer::stress {
namespace {

using tracer::SpherePrimitive;

Found naive(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction) {
  return naive_quadratic(origin - sphere.center, direction, sphere.radius, k_epsilon);
}

Found naive_without_epsilon(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction) {
  return naive_quadratic(origin - sphere.center, direction, sphere.radius, 0);
}

Found gems(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction) {
  return gems_quadratic(origin - sphere.center, direction, sphere.radius);
}

/// Hearn and Baker's way in the 64 bit significand that some processors have.
Found in_long_double(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction) {
  long double f[3], d[3], a = 0, b = 0, c = -static_cast<long double>(sphere.radius) * sphere.radius;
  for (int i = 0; i < 3; ++i) {
    f[i] = static_cast<long double>(origin[i]) - sphere.center[i];
    d[i] = direction[i];
    a += d[i] * d[i];
    b -= f[i] * d[i];
    c += f[i] * f[i];
  }
  long double inside = static_cast<long double>(sphere.radius) * sphere.radius;
  for (int i = 0; i < 3; ++i) {
    const long double from_axis = f[i] + d[i] * (b / a);
    inside -= from_axis * from_axis;
  }
  if (!(inside >= 0)) return {};
  const long double root = std::sqrt(inside * a);
  const long double q = b < 0 ? b - root : b + root;
  const long double one = q / a, other = c / q;
  const auto near = static_cast<double>(b < 0 ? one : other);
  return first_beyond(near, static_cast<double>(b < 0 ? other : one), 0);
}

DdFound in_double_double(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction) {
  return dd_quadratic(difference(origin, sphere.center), dd(direction), sphere.radius);
}

/// Hearn and Baker's way where its error is within some 64 ulp of the distance, else double-double.
Found filtered(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction) {
  constexpr double k_share = 0x1p-5;  // what may be lost to cancellation of some ulp of the terms
  const Vec3 f = origin - sphere.center;
  const double a = dot(direction, direction), b = -dot(f, direction);
  const Vec3 from_axis = f + direction * (b / a);
  const double r2 = sphere.radius * sphere.radius, f2 = dot(f, f);
  const double inside = r2 - dot(from_axis, from_axis), c = f2 - r2;
  const double terms = std::sqrt(f2) * sphere.radius + r2;
  if (inside < -k_share * terms) return {};
  if (inside > k_share * terms && std::fabs(c) > k_share * (f2 + r2)) {
    const double q = b + std::copysign(std::sqrt(a * inside), b);
    const double one = q / a, other = c / q;
    return b < 0 ? first_beyond(one, other, 0) : first_beyond(other, one, 0);
  }
  const DdFound found = in_double_double(sphere, origin, direction);
  return {found.hit, found.entering, found.t.hi};
}

struct Sphere {
  using Primitive = tracer::SpherePrimitive;
  static const Primitive& of(const tracer::World& world) { return world.spheres[0]; }
  static Vec3 normal(const Primitive& sphere, Vec3 point) { return (point - sphere.center) / sphere.radius; }
  static Vec3 normal(const Primitive& sphere, Vec3 origin, const Dd3& way) {
    return unit(difference(origin, sphere.center) + way);
  }
};

}  // namespace

Found naive_quadratic(Vec3 f, Vec3 d, double radius, double least) {
  const double a = dot(d, d), b = 2 * dot(f, d), c = dot(f, f) - radius * radius;
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return {};
  const double root = std::sqrt(discriminant);
  return first_beyond((-b - root) / (2 * a), (-b + root) / (2 * a), least);
}

Found gems_quadratic(Vec3 f, Vec3 d, double radius) {
  const double a = dot(d, d), b = -dot(f, d);
  const Vec3 from_axis = f + d * (b / a);
  const double inside = radius * radius - dot(from_axis, from_axis);
  if (inside < 0) return {};
  const double q = b + std::copysign(std::sqrt(a * inside), b);
  const double c = dot(f, f) - radius * radius;
  const double one = q / a, other = c / q;
  return b < 0 ? first_beyond(one, other, 0) : first_beyond(other, one, 0);
}

std::vector<Method> sphere_methods() {
  return {plain_method<Sphere, naive>("naive"),
          plain_method<Sphere, naive_without_epsilon>("naive, no epsilon"),
          plain_method<Sphere, gems>("Ray Tracing Gems 7"),
          plain_method<Sphere, in_long_double>("long double"),
          plain_method<Sphere, filtered>("filtered"),
          double_double_method<Sphere, in_double_double>()};
}

}  // namespace lancer::stress
