#include "tracer/shapes/ellipsoid.hpp"

#include "tracer/shapes/careful.hpp"

namespace lancer::tracer {
namespace {

/// A ray in the unit sphere's space; its direction is of any length there.
struct OwnRay {
  Vec3 origin, direction;
  double speed = 1;  // that length
  double origin_error = 0, direction_error = 0;

  OwnRay(const EllipsoidPrimitive& e, Vec3 from, Vec3 towards) {
    const Vec3 offset = from - e.center;
    origin = apply(e.to_own, offset);
    direction = apply(e.to_own, towards);
    speed = std::sqrt(dot(direction, direction));
    origin_error = 6 * k_u * sum_abs(apply_abs(e.to_own, offset));
    direction_error = 4 * k_u * sum_abs(apply_abs(e.to_own, towards));
  }
};

/// How far the surface's own rounding may move it in the unit sphere's space.
double own_slack(const EllipsoidPrimitive& e) {
  return std::fmax(sum_abs(e.to_own[0]), std::fmax(sum_abs(e.to_own[1]), sum_abs(e.to_own[2]))) * e.slack;
}

Root banded(const EllipsoidPrimitive& e, double t, bool entering, double half_chord, double speed) {
  return plain_root(t, along_ray(own_slack(e), 1, half_chord) / speed + 2 * k_u * std::fabs(t), entering);
}

Root banded(const EllipsoidPrimitive& e, const Landing& landing, Vec3 direction) {
  const Vec3 own_normal = normalize(apply(e.to_own, landing.point - e.center));
  const Vec3 own_direction = apply(e.to_own, direction);
  return banded(e, landing.root.t, landing.root.entering,
                std::fabs(dot(own_normal, normalize(own_direction))), length(own_direction));
}

Landings careful_landings(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction) {
  Landings found = careful(e, origin, direction);
  for (int i = 0; i < found.count; ++i) {
    Landing& landing = found.at[static_cast<std::size_t>(i)];
    landing.root = banded(e, landing, direction);
  }
  return found;
}

DoubleDouble accurate_dot(Vec3 a, const Triple2& b) {
  Accurate sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const double weight = a[static_cast<int>(i)];
    sum.add_product(weight, b[i].hi);
    sum.add_small(weight * b[i].lo);
  }
  return sum.sum();
}

Triple2 to_own(const EllipsoidPrimitive& e, const Triple2& offset) {
  return {accurate_dot(e.to_own[0], offset), accurate_dot(e.to_own[1], offset),
          accurate_dot(e.to_own[2], offset)};
}

Rows transposed(const Rows& m) {
  return {Vec3{m[0].x, m[1].x, m[2].x}, Vec3{m[0].y, m[1].y, m[2].y}, Vec3{m[0].z, m[1].z, m[2].z}};
}

/// |w|^2 - 1.
double power(const Triple2& w) {
  Accurate sum;
  sum.add(-1);
  for (const DoubleDouble& x : w) {
    sum.add_product(x.hi, x.hi);
    sum.add_small(2 * x.hi * x.lo);
  }
  return sum.value();
}

/// The distance near t at which |own|^2 is 1, as for spheres.
Distance solve(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction, double t) {
  const OwnRay ray(e, origin, direction);
  const Triple2 f = exact_difference(origin, e.center);
  const double square = ray.speed * ray.speed;
  Distance at{{t, 0}, 0};
  for (int step = 0; step < 3; ++step) {
    const Triple2 w = to_own(e, advance(f, direction, at.t));
    const double half_slope = dot(rounded(w), ray.direction);
    const double correction = -power(w) / (2 * half_slope);
    const double bend = square * correction / half_slope;
    at.t = at.t + correction * (1 - bend / 2);
    const Vec3 terms = apply_abs(e.to_own, abs(rounded(f)) + abs(direction) * std::fabs(at.t.hi));
    const double unknown = 64 * k_u * k_u * (sum_abs(terms) + 1) / std::fabs(half_slope);
    const double doubt = (ray.direction_error * 2 + 8 * k_u * ray.speed) / std::fabs(half_slope);
    const double left = std::fabs(correction) * (doubt + bend * bend);
    at.error = unknown + left;
    if (left <= unknown) break;
    if (!(std::fabs(bend) < 0.25)) return {at.t, std::fabs(t)};
  }
  return at;
}

bool land(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction, Landing& landing) {
  const Distance distance = solve(e, origin, direction, landing.root.t);
  if (!settles(distance)) return false;
  const Triple2 start{DoubleDouble{origin.x, 0}, DoubleDouble{origin.y, 0}, DoubleDouble{origin.z, 0}};
  landing.point = rounded(advance(start, direction, distance.t));
  if (!settles(landing.point, advance_error(origin, direction, distance))) return false;

  const Triple2 f = exact_difference(origin, e.center);
  const Triple2 w = to_own(e, advance(f, direction, distance.t));
  const Vec3 way = abs(rounded(f)) + abs(direction) * std::fabs(distance.t.hi);
  const Vec3 w_error = apply_abs(e.to_own, way * (16 * k_u * k_u) + abs(direction) * distance.error);
  const Rows back = transposed(e.to_own);
  const Triple2 n{accurate_dot(back[0], w), accurate_dot(back[1], w), accurate_dot(back[2], w)};
  if (!settles(rounded(n), apply_abs(back, w_error))) return false;
  landing.normal = unit(n);
  landing.root.t = distance.t.hi;
  return true;
}

}  // namespace

Roots roots(const EllipsoidPrimitive& e, const Probe& probe) {
  const OwnRay ray(e, probe.origin, probe.direction);
  const double b = -dot(ray.origin, ray.direction) / (ray.speed * ray.speed);
  const Vec3 from_axis = ray.origin + ray.direction * b;
  const double discriminant = 1 - dot(from_axis, from_axis);
  const double reach = sum_abs(ray.origin);
  const double turn = ray.direction_error / ray.speed;
  const double lost = 2 * ray.origin_error + reach * (20 * k_u + 5 * turn);
  const double doubt = 2 * lost * (sum_abs(from_axis) + lost) + 8 * k_u;
  if (discriminant < -doubt) return {};
  const double half_chord = std::sqrt(std::fmax(discriminant, 0));
  const double half = half_chord / ray.speed;
  const double error =
      (2 * lost + doubt / half_chord) / ray.speed + (8 * k_u + 3 * turn) * (std::fabs(b) + half);
  const double near = b - half, far = b + half;
  if (discriminant > doubt && turn < 0x1p-20 && std::fabs(near) > error && std::fabs(far) > error) {
    Roots found{2,
                {banded(e, near, true, half_chord, ray.speed), banded(e, far, false, half_chord, ray.speed)}};
    for (Root& root : found.root) root.widen(error);
    return found;
  }
  const Landings exactly = careful_landings(e, probe.origin, probe.direction);
  return {exactly.count, {exactly.at[0].root, exactly.at[1].root}};
}

Root exit(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction) {
  const OwnRay ray(e, origin, direction);
  const double half_chord = std::fmax(-dot(ray.origin, ray.direction) / ray.speed, 0);
  Root root = banded(e, 2 * half_chord / ray.speed, false, half_chord, ray.speed);
  root.widen((4 * ray.origin_error + sum_abs(ray.origin) * (16 * k_u + 4 * ray.direction_error / ray.speed)) /
             ray.speed);
  return root;
}

Landing land(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction, const Root& root) {
  Landing landing{root, {}, {}};
  if (land(e, origin, direction, landing)) {
    landing.root = banded(e, landing, direction);
    return landing;
  }
  const Landings exactly = careful_landings(e, origin, direction);
  const Landing& found = exactly.at[root.entering ? 0 : 1];
  if (exactly.count == 2 && found.root.t > 0) return found;
  landing.point = project(e, origin + direction * root.t);
  landing.normal = normal(e, landing.point);
  return landing;
}

Vec3 normal(const EllipsoidPrimitive& e, Vec3 p) {
  return normalize(apply_transposed(e.to_own, normalize(apply(e.to_own, p - e.center))));
}

Vec3 project(const EllipsoidPrimitive& e, Vec3 p) {
  return e.center + apply(e.to_world, normalize(apply(e.to_own, p - e.center)));
}

Aabb bounds(const EllipsoidPrimitive& e) {
  const Vec3 half{length(e.to_world[0]), length(e.to_world[1]), length(e.to_world[2])};
  return Aabb{e.center - half, e.center + half}.padded(e.slack + 8 * k_u * max_abs(half));
}

double side(const EllipsoidPrimitive& e, Vec3 p) {
  const Triple2 f = exact_difference(p, e.center);
  const Triple2 w = to_own(e, f);
  const double out = power(w);
  const double terms = sum_abs(apply_abs(e.to_own, rounded(f)));
  return std::fabs(out) > 64 * k_u * k_u * (terms + 1) * (terms + 1) ? out : careful_side(e, p);
}

}  // namespace lancer::tracer
