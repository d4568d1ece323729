#include "stress/methods/walks.hpp"

#include <bit>
#include <limits>

#include "stress/methods/box.hpp"

namespace lancer::stress::flat {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// Two distances in order, infinite where there are none, and the sides of a box.
struct Pair {
  double t[2] = {k_infinity, k_infinity};
  int face[2] = {0, 0};
};

/// Of |f + t d| = r, without cancellation between the roots.
Pair round_roots(Vec3 f, Vec3 d, double r) {
  const double a = dot(d, d), b = -dot(f, d);
  const Vec3 from_axis = f + d * (b / a);
  const double inside = r * r - dot(from_axis, from_axis);
  if (!(inside >= 0)) return {};
  const double root = std::sqrt(inside * a), q = b < 0 ? b - root : b + root;
  const double c = dot(f, f) - r * r;
  Pair out;
  out.t[0] = std::fmin(q / a, c / q);
  out.t[1] = std::fmax(q / a, c / q);
  return out;
}

Pair box_roots(const tracer::BoxPrimitive& b, Vec3 origin, Vec3 direction) {
  const BoxNumbers box = numbers_of(b);
  const Vec3 o = box.turned ? tracer::apply(box.to_own, origin - box.center) : origin;
  const Vec3 d = box.turned ? tracer::apply(box.to_own, direction) : direction;
  Pair out;
  out.t[0] = -k_infinity;
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0) continue;
    const bool back = d[axis] < 0;
    const double in = ((back ? box.hi : box.lo)[axis] - o[axis]) / d[axis];
    const double leave = ((back ? box.lo : box.hi)[axis] - o[axis]) / d[axis];
    if (in > out.t[0]) {
      out.t[0] = in;
      out.face[0] = 2 * axis + (back ? 1 : 0);
    }
    if (leave < out.t[1]) {
      out.t[1] = leave;
      out.face[1] = 2 * axis + (back ? 0 : 1);
    }
  }
  return out.t[0] <= out.t[1] ? out : Pair{};
}

Pair plain_roots(const tracer::World& world, const tracer::Primitive& p, Vec3 o, Vec3 d) {
  Pair out;
  switch (p.kind) {
    case tracer::Kind::sphere: {
      const tracer::SpherePrimitive& s = world.spheres[p.record];
      return round_roots(o - s.center, d, s.radius);
    }
    case tracer::Kind::ellipsoid: {
      const tracer::EllipsoidPrimitive& e = world.ellipsoids[p.record];
      return round_roots(tracer::apply(e.to_own, o - e.center), tracer::apply(e.to_own, d), 1);
    }
    case tracer::Kind::plane: {
      const tracer::PlanePrimitive& plane = world.planes[p.record];
      const double slope = dot(plane.normal, d);
      if (slope != 0) out.t[0] = (plane.level - dot(plane.normal, o - plane.point)) / slope;
      return out;
    }
    case tracer::Kind::box: return box_roots(world.boxes[p.record], o, d);
    case tracer::Kind::facet: {
      const tracer::FacetPrimitive& f = world.facets[p.record];
      const Answer answer = MollerTrumbore::test({f.a, f.b, f.c}, Aim(o, d));
      if (answer.hit) out.t[0] = answer.t;
      return out;
    }
  }
  return out;
}

Vec3 plain_normal(const tracer::World& world, const tracer::Primitive& p, Vec3 at, int face) {
  switch (p.kind) {
    case tracer::Kind::sphere: return normalize(at - world.spheres[p.record].center);
    case tracer::Kind::ellipsoid: {
      const tracer::EllipsoidPrimitive& e = world.ellipsoids[p.record];
      const Vec3 own = tracer::apply(e.to_own, at - e.center);
      return normalize(tracer::apply_transposed(e.to_own, own));
    }
    case tracer::Kind::plane: return normalize(world.planes[p.record].normal);
    case tracer::Kind::box: return side_normal(numbers_of(world.boxes[p.record]), face);
    case tracer::Kind::facet: {
      const tracer::FacetPrimitive& f = world.facets[p.record];
      return normalize(cross(f.b - f.a, f.c - f.a));
    }
  }
  return {};
}

bool plain_first(const tracer::World& world, Vec3 o, Vec3 d, double least, RuleWalk::Place& to) {
  to.distance = k_infinity;
  int face = 0;
  for (std::uint32_t i = 0; i < world.primitives.size(); ++i) {
    const Pair pair = plain_roots(world, world.primitives[i], o, d);
    const int which = pair.t[0] > least ? 0 : 1;
    if (!(pair.t[which] > least && pair.t[which] < to.distance)) continue;
    to.distance = pair.t[which];
    to.of_primitive = i;
    face = pair.face[which];
  }
  if (!(to.distance < k_infinity)) return false;
  const tracer::Primitive& p = world.primitives[to.of_primitive];
  to.of_shape = p.shape;
  to.at = o + d * to.distance;
  to.outward = plain_normal(world, p, to.at, face);
  to.enters = dot(to.outward, d) < 0;
  return true;
}

/// p, 256 ulp further along n, or by 2^-16 of n where p is near 0.
double ulp_offset(double p, double n) {
  const auto steps = static_cast<std::int64_t>(256 * n);
  const auto bits = std::bit_cast<std::int64_t>(p) + (p < 0 ? -steps : steps);
  return std::fabs(p) < 1.0 / 32 ? p + n / 65536 : std::bit_cast<double>(bits);
}

}  // namespace

bool OwnWalk::start(const tracer::World& world, const Line& line, Place& to) const {
  tracer::Ray ray;
  ray.origin = line.origin;
  ray.direction = line.direction;
  tracer::Stats stats;
  to.open.clear();
  return closest(world, ray, stats, to.hit);
}

bool OwnWalk::go(const tracer::World& world, const Place& from, Vec3 direction, Place& to) const {
  tracer::Ray ray = ray_from(world, from.hit, direction);
  ray.open = from.open;
  const bool inwards = dot(from.hit.normal, direction) < 0;
  if (inwards == from.hit.root.entering) cross(world, ray.open, from.hit.shape, inwards);
  tracer::Stats stats;
  to.open = ray.open;
  return closest(world, ray, stats, to.hit);
}

bool RuleWalk::start(const tracer::World& world, const Line& line, Place& to) const {
  return plain_first(world, line.origin, line.direction, 0, to);
}

Vec3 RuleWalk::from(const Place& place, Vec3 direction) const {
  const Vec3 n = dot(place.outward, direction) < 0 ? -place.outward : place.outward;
  if (rule_.in_ulp)
    return {ulp_offset(place.at.x, n.x), ulp_offset(place.at.y, n.y), ulp_offset(place.at.z, n.z)};
  return place.at + n * rule_.offset;
}

bool RuleWalk::go(const tracer::World& world, const Place& place, Vec3 direction, Place& to) const {
  return plain_first(world, from(place, direction), direction, rule_.least, to);
}

}  // namespace lancer::stress::flat
