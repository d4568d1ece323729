#include "tracer/shapes/sphere.hpp"

#include "tracer/shapes/careful.hpp"
#include "tracer/shapes/newton.hpp"

namespace lancer::tracer {
namespace {

void set_slack(const SpherePrimitive& sphere, double half_chord, Landing& landing) {
  landing.spread(along_ray(sphere.slack, sphere.radius, half_chord) + 2 * k_u * std::fabs(landing.root.t));
}

Landings careful_landings(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction) {
  Landings found = careful(sphere, origin, direction);
  for (Landing& landing : found.at)
    set_slack(sphere, sphere.radius * std::fabs(dot(landing.normal, direction)), landing);
  return found;
}

template <class P>
LANCER_INLINE bool land_by(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction, Landing& landing) {
  const double r = sphere.radius;
  const Triple2 f = exact_difference(origin, sphere.center);
  const double reach = r + sum_abs(rounded(f));
  Triple2 v;  // from the centre to the crossing
  Distance at{{landing.root.t, 0}, 0};
  double half_chord = 0;
  for (int step = 0; step < 3; ++step) {
    v = advance<P>(f, direction, at.t);
    Total<P> power;
    power.add_product(-r, r);
    for (const DoubleDouble& x : v) power.add_square(x);
    const double half_slope = dot(rounded(v), direction);
    const double inverse = 1 / half_slope;
    const double correction = -0.5 * power.value() * inverse;
    const double bend = correction * inverse;
    const double moved = correction - 0.5 * correction * bend;
    at.t = two_sum(at.t.hi, at.t.lo + moved);
    for (std::size_t i = 0; i < 3; ++i)
      v[i] = two_sum(v[i].hi, v[i].lo + moved * direction[static_cast<int>(i)]);
    const double steep = std::fabs(inverse);
    const double unknown = 64 * k_u * k_u * r * (reach + std::fabs(at.t.hi)) * steep;
    const double left = std::fabs(correction) * (8 * k_u * (1 + r * steep) + bend * bend);
    at.error = unknown + left;
    half_chord = std::fabs(half_slope);
    if (left <= 16 * unknown) break;
    if (!(std::fabs(bend) < 0.25)) return false;
  }
  if (!settles(at.t.hi, at.error)) return false;
  const Vec3 error = advance_error(rounded(f), direction, at);
  if (!settles(rounded(v), error)) return false;
  landing.root.t = at.t.hi;
  const double one_over_r = 1 / r;
  for (int i = 0; i < 3; ++i) {
    const DoubleDouble& x = v[static_cast<std::size_t>(i)];
    const DoubleDouble sum = two_sum(sphere.center[i], x.hi);
    landing.point[i] = sum.hi + (sum.lo + x.lo);
    landing.normal[i] = quotient<P>(x, r, one_over_r);
  }
  if (!settles(landing.point, error)) return false;
  set_slack(sphere, half_chord, landing);
  return true;
}

LANCER_FUSED bool land_fused(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction, Landing& landing) {
  return land_by<Fused>(sphere, origin, direction, landing);
}
bool land_split(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction, Landing& landing) {
  return land_by<Split>(sphere, origin, direction, landing);
}

}  // namespace

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
  if (discriminant > doubt) {
    const double half_chord = std::sqrt(discriminant);
    const double near = b - half_chord, far = b + half_chord;
    const double lateral = (sphere.slack * r + doubt) / half_chord;
    const double error = sphere.slack + lateral + 18 * k_u * (reach + r);
    if (std::fabs(near) > error && std::fabs(far) > error) {
      return {2, {Root{near, error, true}, Root{far, error, false}}};
    }
  }
  return careful_landings(sphere, probe.origin, probe.direction).roots();
}

Root exit(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction) {
  const Vec3 f = origin - sphere.center;
  const double half_chord = std::fmax(-dot(f, direction), 0);
  const double error = along_ray(sphere.slack, sphere.radius, half_chord);
  return {2 * half_chord, error + 16 * k_u * (sum_abs(f) + sphere.radius), false};
}

Landing land(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction, const Root& root) {
  Landing landing{root, 0, 0, {}, {}};
  if (k_has_fused ? land_fused(sphere, origin, direction, landing)
                  : land_split(sphere, origin, direction, landing)) {
    return landing;
  }
  const Landings exactly = careful_landings(sphere, origin, direction);
  const Landing& found = exactly.at[root.entering ? 0 : 1];
  if (exactly.count == 2 && found.root.t > 0) return found;
  landing.root = root;
  landing.spread(root.error);
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
  Total<Split> power;
  power.add_product(-sphere.radius, sphere.radius);
  for (const DoubleDouble& x : f) power.add_square(x);
  const double size = dot(rounded(f), rounded(f)) + sphere.radius * sphere.radius;
  const double out = power.value();
  return std::fabs(out) > 64 * k_u * k_u * size ? out : careful_side(sphere, p);
}

}  // namespace lancer::tracer
