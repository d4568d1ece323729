#include "tracer/shapes/ellipsoid.hpp"

#include "tracer/shapes/careful.hpp"
#include "tracer/shapes/newton.hpp"
#include "tracer/shapes/sphere.hpp"

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

void set_slack(const EllipsoidPrimitive& e, double half_chord, double speed, Landing& landing) {
  landing.spread(along_ray(own_slack(e), 1, half_chord) / speed + 2 * k_u * std::fabs(landing.root.t));
}

Landings careful_landings(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction) {
  Landings found = careful(e, origin, direction);
  const Vec3 own_direction = apply(e.to_own, direction);
  const double speed = std::sqrt(dot(own_direction, own_direction));
  for (Landing& landing : found.at) {
    const Vec3 w = apply(e.to_own, landing.point - e.center);
    set_slack(e, std::fabs(dot(w, own_direction)) / speed, speed, landing);
  }
  return found;
}

template <class P>
LANCER_INLINE DoubleDouble dot_by(Vec3 a, const Triple2& b) {
  Total<P> sum;
  for (std::size_t i = 0; i < 3; ++i) {
    sum.add_product(a[static_cast<int>(i)], b[i].hi);
    sum.low += a[static_cast<int>(i)] * b[i].lo;
  }
  return two_sum(sum.high, sum.low);
}

template <class P>
LANCER_INLINE Triple2 apply_by(const Rows& m, const Triple2& v) {
  return {dot_by<P>(m[0], v), dot_by<P>(m[1], v), dot_by<P>(m[2], v)};
}

LANCER_INLINE Rows transposed(const Rows& m) {
  return {Vec3{m[0].x, m[1].x, m[2].x}, Vec3{m[0].y, m[1].y, m[2].y}, Vec3{m[0].z, m[1].z, m[2].z}};
}

/// |w|^2 - 1.
template <class P>
LANCER_INLINE double power(const Triple2& w) {
  Total<P> sum{-1, 0};
  for (const DoubleDouble& x : w) sum.add_square(x);
  return sum.value();
}

template <class P>
LANCER_INLINE bool land_by(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction, Landing& landing) {
  const Triple2 f = exact_difference(origin, e.center);
  const Vec3 h = apply(e.to_own, direction);
  const double square = dot(h, h), speed = std::sqrt(square);
  const double h_error = 4 * k_u * sum_abs(apply_abs(e.to_own, direction));
  Triple2 w;  // the crossing in the unit sphere's space
  Distance at{{landing.root.t, 0}, 0};
  double half_slope = 0;
  for (int step = 0; step < 3; ++step) {
    w = apply_by<P>(e.to_own, advance<P>(f, direction, at.t));
    half_slope = dot(rounded(w), h);
    const double inverse = 1 / half_slope;
    const double correction = -0.5 * power<P>(w) * inverse;
    const double bend = square * correction * inverse;
    at.t = two_sum(at.t.hi, at.t.lo + (correction - 0.5 * correction * bend));
    const double steep = std::fabs(inverse);
    const Vec3 way = abs(rounded(f)) + abs(direction) * std::fabs(at.t.hi);
    const double unknown = 64 * k_u * k_u * (sum_abs(apply_abs(e.to_own, way)) + 1) * steep;
    const double left = std::fabs(correction) * ((h_error * 2 + 8 * k_u * speed) * steep + bend * bend);
    at.error = unknown + left;
    if (left <= 16 * unknown) break;
    if (!(std::fabs(bend) < 0.25)) return false;
  }
  if (!settles(at.t.hi, at.error)) return false;
  const Triple2 start{DoubleDouble{origin.x, 0}, DoubleDouble{origin.y, 0}, DoubleDouble{origin.z, 0}};
  landing.point = rounded(advance<P>(start, direction, at.t));
  if (!settles(landing.point, advance_error(origin, direction, at))) return false;

  const Rows back = transposed(e.to_own);
  const Triple2 n = apply_by<P>(back, apply_by<P>(e.to_own, advance<P>(f, direction, at.t)));
  const Vec3 w_error = apply_abs(e.to_own, advance_error(rounded(f), direction, at) * 2);
  if (!settles(rounded(n), apply_abs(back, w_error))) return false;
  landing.normal = unit(n);
  landing.root.t = at.t.hi;
  set_slack(e, std::fabs(half_slope) / speed, speed, landing);
  return true;
}

LANCER_FUSED bool land_fused(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction, Landing& landing) {
  return land_by<Fused>(e, origin, direction, landing);
}
bool land_split(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction, Landing& landing) {
  return land_by<Split>(e, origin, direction, landing);
}

}  // namespace

Roots roots(const EllipsoidPrimitive& e, const Probe& probe) {
  const OwnRay ray(e, probe.origin, probe.direction);
  const double b = -dot(ray.origin, ray.direction) / (ray.speed * ray.speed);
  const Vec3 from_axis = ray.origin + ray.direction * b;
  const double discriminant = 1 - dot(from_axis, from_axis);
  const double turn = ray.direction_error / ray.speed;
  const double lost = 2 * ray.origin_error + sum_abs(ray.origin) * (20 * k_u + 5 * turn);
  const double doubt = 2 * lost * (sum_abs(from_axis) + lost) + 8 * k_u;
  if (discriminant < -doubt) return {};
  if (discriminant > doubt && turn < 0x1p-20) {
    const double half_chord = std::sqrt(discriminant);
    const double half = half_chord / ray.speed;
    const double shift = own_slack(e);
    const double error = (2 * lost + shift + (shift + doubt) / half_chord) / ray.speed +
                         (8 * k_u + 3 * turn) * (std::fabs(b) + half);
    const double near = b - half, far = b + half;
    if (std::fabs(near) > error && std::fabs(far) > error) {
      return {2, {Root{near, error, true}, Root{far, error, false}}};
    }
  }
  return careful_landings(e, probe.origin, probe.direction).roots();
}

Root exit(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction) {
  const OwnRay ray(e, origin, direction);
  const double half_chord = std::fmax(-dot(ray.origin, ray.direction) / ray.speed, 0);
  const double lost =
      4 * ray.origin_error + sum_abs(ray.origin) * (16 * k_u + 4 * ray.direction_error / ray.speed);
  return {2 * half_chord / ray.speed, (along_ray(own_slack(e), 1, half_chord) + lost) / ray.speed, false};
}

Landing land(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction, const Root& root) {
  Landing landing{root, 0, 0, {}, {}};
  if (k_has_fused ? land_fused(e, origin, direction, landing) : land_split(e, origin, direction, landing)) {
    return landing;
  }
  const Landings exactly = careful_landings(e, origin, direction);
  const Landing& found = exactly.at[root.entering ? 0 : 1];
  if (exactly.count == 2 && found.root.t > 0) return found;
  landing.root = root;
  landing.spread(root.error);
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
  const double out = power<Split>(apply_by<Split>(e.to_own, f));
  const double terms = 1 + sum_abs(apply_abs(e.to_own, rounded(f)));
  return std::fabs(out) > 64 * k_u * k_u * terms * terms ? out : careful_side(e, p);
}

}  // namespace lancer::tracer
