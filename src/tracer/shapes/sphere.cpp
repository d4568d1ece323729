#include "tracer/shapes/sphere.hpp"

#include "tracer/shapes/careful.hpp"

namespace lancer::tracer {
namespace {

/// |f|^2 - r^2 as if in twice the precision; off by 2^-100 (|f|^2 + r^2) at most.
double power(const Triple2& f, double r) {
  Accurate sum;
  sum.add_product(-r, r);
  for (const DoubleDouble& x : f) {
    sum.add_product(x.hi, x.hi);
    sum.add_small(2 * x.hi * x.lo);
  }
  return sum.value();
}

/// With the bounds of the sphere's own rounding; `half_chord` is the part of the radius along the ray.
Root banded(const SpherePrimitive& sphere, double t, bool entering, double half_chord) {
  const double error = along_ray(sphere.slack, sphere.radius, half_chord) + 2 * k_u * std::fabs(t);
  return plain_root(t, error, entering);
}

Root banded(const SpherePrimitive& sphere, const Landing& landing, Vec3 direction) {
  const double half_chord = sphere.radius * std::fabs(dot(landing.normal, direction));
  return banded(sphere, landing.root.t, landing.root.entering, half_chord);
}

Landings careful_landings(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction) {
  Landings found = careful(sphere, origin, direction);
  for (Landing& landing : found.at) landing.root = banded(sphere, landing, direction);
  return found;
}

/// One step of Newton's iteration, or two where the start is coarse.
Distance solve(const Triple2& f, Vec3 direction, double r, double t) {
  const double reach = r + sum_abs(rounded(f));
  Distance at{{t, 0}, 0};
  for (int step = 0; step < 3; ++step) {
    const Triple2 v = advance(f, direction, at.t);
    const double half_slope = dot(rounded(v), direction);
    const double correction = -power(v, r) / (2 * half_slope);
    const double bend = correction / half_slope;
    at.t = at.t + correction * (1 - bend / 2);
    const double unknown = 64 * k_u * k_u * r * (reach + std::fabs(at.t.hi)) / std::fabs(half_slope);
    const double left = std::fabs(correction) * (8 * k_u * (1 + r / std::fabs(half_slope)) + bend * bend);
    at.error = unknown + left;
    if (left <= unknown) break;
    if (!(std::fabs(bend) < 0.25)) return {at.t, reach};
  }
  return at;
}

bool land(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction, Landing& landing) {
  const Triple2 f = exact_difference(origin, sphere.center);
  const Distance distance = solve(f, direction, sphere.radius, landing.root.t);
  if (!settles(distance)) return false;
  const Triple2 v = advance(f, direction, distance.t);
  if (!settles(rounded(v), advance_error(rounded(f), direction, distance))) return false;
  const Triple2 start{DoubleDouble{origin.x, 0}, DoubleDouble{origin.y, 0}, DoubleDouble{origin.z, 0}};
  landing.point = rounded(advance(start, direction, distance.t));
  if (!settles(landing.point, advance_error(origin, direction, distance))) return false;
  const DoubleDouble r{sphere.radius, 0};
  landing.normal = {(v[0] / r).hi, (v[1] / r).hi, (v[2] / r).hi};
  landing.root.t = distance.t.hi;
  return true;
}

}  // namespace

double along_ray(double shift, double radius, double half_chord) {
  const double most = std::sqrt(2 * shift * radius);
  return shift + (half_chord > 0 ? std::fmin(shift * radius / half_chord, most) : most);
}

Roots roots(const SpherePrimitive& sphere, const Probe& probe) {
  const double r = sphere.radius;
  const Vec3 f = probe.origin - sphere.center;
  const double b = -dot(f, probe.direction);
  const Vec3 from_axis = f + probe.direction * b;
  const double discriminant = r * r - dot(from_axis, from_axis);
  const double reach = sum_abs(f);
  const double lost = 20 * k_u * reach;  // bounds the error of from_axis
  const double doubt = 2 * lost * (sum_abs(from_axis) + lost) + 4 * k_u * r * r;
  if (discriminant < -doubt) return {};
  const double half_chord = std::sqrt(std::fmax(discriminant, 0));
  const double error = 16 * k_u * (reach + r) + doubt / half_chord;
  const double near = b - half_chord, far = b + half_chord;
  if (discriminant > doubt && std::fabs(near) > error && std::fabs(far) > error) {
    Roots found{2, {banded(sphere, near, true, half_chord), banded(sphere, far, false, half_chord)}};
    for (Root& root : found.root) root.widen(error);
    return found;
  }
  const Landings exactly = careful_landings(sphere, probe.origin, probe.direction);
  return {exactly.count, {exactly.at[0].root, exactly.at[1].root}};
}

Root exit(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction) {
  const Vec3 f = origin - sphere.center;
  const double half_chord = std::fmax(-dot(f, direction), 0);
  Root root = banded(sphere, 2 * half_chord, false, half_chord);
  root.widen(16 * k_u * (sum_abs(f) + sphere.radius));
  return root;
}

Landing land(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction, const Root& root) {
  Landing landing{root, {}, {}};
  if (land(sphere, origin, direction, landing)) {
    landing.root = banded(sphere, landing, direction);
    return landing;
  }
  const Landings exactly = careful_landings(sphere, origin, direction);
  const Landing& found = exactly.at[root.entering ? 0 : 1];
  if (exactly.count == 2 && found.root.t > 0) return found;
  landing.point = project(sphere, origin + direction * root.t);
  landing.normal = normal(sphere, landing.point);
  return landing;
}

Vec3 normal(const SpherePrimitive& sphere, Vec3 p) { return normalize(p - sphere.center); }

Vec3 project(const SpherePrimitive& sphere, Vec3 p) {
  return sphere.center + normalize(p - sphere.center) * sphere.radius;
}

Aabb bounds(const SpherePrimitive& sphere) {
  const Vec3 half{sphere.radius, sphere.radius, sphere.radius};
  return Aabb{sphere.center - half, sphere.center + half}.padded(sphere.slack);
}

double side(const SpherePrimitive& sphere, Vec3 p) {
  const Triple2 f = exact_difference(p, sphere.center);
  const double out = power(f, sphere.radius);
  const double size = dot(rounded(f), rounded(f)) + sphere.radius * sphere.radius;
  return std::fabs(out) > 64 * k_u * k_u * size ? out : careful_side(sphere, p);
}

}  // namespace lancer::tracer
