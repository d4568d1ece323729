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
    origin_error = 6 * k_u * e.reach * largest(offset);
    direction_error = 4 * k_u * e.reach;
  }
};

void set_slack(const EllipsoidPrimitive& e, Vec3 direction, Landing& landing) {
  const Vec3 w = apply(e.to_own, landing.point - e.center), own_direction = apply(e.to_own, direction);
  const double speed = std::sqrt(dot(own_direction, own_direction));
  const double half_chord = std::fabs(dot(w, own_direction)) / speed;
  landing.root.error = along_ray(e.own_slack, 1, half_chord) / speed + 2 * k_u * std::fabs(landing.root.t);
}

[[gnu::noinline, gnu::cold]] Landings careful_landings(const EllipsoidPrimitive& e, Vec3 origin,
                                                       Vec3 direction, Detail detail) {
  Landings found = careful(e, origin, direction, detail);
  for (Landing& landing : found.at) set_slack(e, direction, landing);
  return found;
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
    const double shift = e.own_slack;
    const double error = (2 * lost + shift + (shift + doubt) / half_chord) / ray.speed +
                         (8 * k_u + 3 * turn) * (std::fabs(b) + half);
    const double near = b - half, far = b + half;
    if (std::fabs(near) > error && std::fabs(far) > error) {
      return {2, {Root{near, error, true}, Root{far, error, false}}};
    }
  }
  return careful_landings(e, probe.origin, probe.direction, Detail::distances).roots();
}

Root exit(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction) {
  const OwnRay ray(e, origin, direction);
  const double half_chord = std::max(-dot(ray.origin, ray.direction) / ray.speed, 0.0);
  const double lost =
      4 * ray.origin_error + sum_abs(ray.origin) * (16 * k_u + 4 * ray.direction_error / ray.speed);
  return {2 * half_chord / ray.speed, (along_ray(e.own_slack, 1, half_chord) + lost) / ray.speed, false};
}

Landing land(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction, const Root& root) {
  Landing landing{root, 0, 0, {}, {}};
  if (land_quickly(e, origin, direction, landing)) {
    set_slack(e, direction, landing);
    return landing;
  }
  if (take(careful_landings(e, origin, direction, Detail::places), root.entering, landing)) return landing;
  landing.root = root;
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
  const Vec3 f = p - e.center;
  const Vec3 own = apply(e.to_own, f);
  const double out = dot(own, own) - 1;
  const double terms = 1 + sum_abs(apply_abs(e.to_own, f));
  return std::fabs(out) > 16 * k_u * terms * terms ? out : careful_side(e, p);
}

}  // namespace lancer::tracer
