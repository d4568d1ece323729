#include "tracer/shapes/careful.hpp"

#include <algorithm>
#include <utility>

#include "tracer/exact.hpp"
#include "tracer/expansion.hpp"

namespace lancer::tracer {
namespace {

using ExactVec = Triple<Exact>;
using WideVec = Triple<Wide>;

bool is_finite(Vec3 origin, Vec3 direction) {
  return lancer::is_finite(origin) && lancer::is_finite(direction);
}

Vec3 unit(const WideVec& v) { return rounded(v * (Wide(1) / sqrt(dot(v, v)))); }

/// o + t d. What is 0 but for the rounding of a quotient is 0.
WideVec place(const ExactVec& o, const ExactVec& d, const Wide& t) {
  const auto along = [&](const Exact& from, const Exact& way) {
    const Wide start = from.wide(), moved = way.wide() * t;
    const Wide sum = start + moved;
    return abs(sum) < ldexp(abs(start) + abs(moved), -150) ? Wide(0) : sum;
  };
  return {along(o.x, d.x), along(o.y, d.y), along(o.z, d.z)};
}

Landing bare_landing(double t, double rest, bool entering, Vec3 origin, Vec3 direction, int face = 0) {
  const Root root{t, 0, entering, false, static_cast<std::uint8_t>(face)};
  return {root, rest, 0, origin + direction * t, {}};
}
Landing bare_landing(const Wide& t, bool entering, Vec3 origin, Vec3 direction, int face = 0) {
  const double distance = t.convert_to<double>();
  return bare_landing(distance, Wide(t - distance).convert_to<double>(), entering, origin, direction, face);
}

/// A facet's corners as seen from the start of a ray, and their determinants with its direction.
template <class Number>
struct Corners {
  Triple<Number> a, b, c;
  Triple<Number> bc;  // b x c
  Number u, v, w;

  Corners(const FacetPrimitive& facet, Vec3 origin, Vec3 direction)
      : a(seen(facet.a, origin)), b(seen(facet.b, origin)), c(seen(facet.c, origin)), bc(cross(b, c)) {
    const Triple<Number> d = {direction.x, direction.y, direction.z};
    u = dot(d, bc);
    v = dot(d, cross(c, a));
    w = dot(d, cross(a, b));
  }

  /// Does the ray pass all edges on one side, or meet them?
  bool surround() const {
    const int least = std::min({u.sign(), v.sign(), w.sign()}),
              most = std::max({u.sign(), v.sign(), w.sign()});
    return least >= 0 || most <= 0;
  }

 private:
  static Triple<Number> seen(Vec3 p, Vec3 from) {
    return Triple<Number>{p.x, p.y, p.z} - Triple<Number>{from.x, from.y, from.z};
  }
};

/// As careful(), but for the place, by expansions; false: not in their reach.
bool careful_distance(const FacetPrimitive& facet, Vec3 origin, Vec3 direction, Landings& out) {
  for (const Vec3 v : {facet.a, facet.b, facet.c, origin, direction}) {
    if (!is_expandable(v)) return false;
  }
  const Corners<Expansion> seen(facet, origin, direction);
  const Expansion slope = seen.u + seen.v + seen.w;
  if (!seen.surround() || slope.sign() == 0) return true;
  const Expansion depth = dot(seen.a, seen.bc);
  const DoubleDouble t = depth.sign() == 0 ? DoubleDouble{} : depth.rounded() / slope.rounded();
  const double doubt = std::fabs(t.hi) * 0x1p-96;
  if (t.hi + (t.lo - doubt) != t.hi || t.hi + (t.lo + doubt) != t.hi) return false;
  const bool entering = (slope.sign() < 0) != facet.flipped;
  out = {1, {bare_landing(t.hi, t.lo, entering, origin, direction), {}}};
  return true;
}

/// The roots of a t^2 + 2 b t + c in ascending order, without cancellation; false: none.
bool solve(const Exact& a, const Exact& b, const Exact& c, Wide& near, Wide& far) {
  const Exact discriminant = b * b - a * c;
  if (discriminant.sign() < 0) return false;
  const Wide half_width = sqrt(discriminant.wide());
  const Wide q = b.sign() > 0 ? Wide(-(b.wide() + half_width)) : Wide(half_width - b.wide());
  near = far = 0;
  if (q == 0) return true;
  near = q / a.wide();
  far = c.wide() / q;
  if (far < near) swap(near, far);
  return true;
}

/// The plane n . (x - at) = level.
struct ExactPlane {
  ExactVec n;
  Exact level;
  ExactVec at;

  Exact depth(const ExactVec& p) const { return level - dot(n, p - at); }
};

Landings meet(const ExactPlane& plane, Vec3 origin, Vec3 direction, bool flipped, Detail detail) {
  const ExactVec o = exact(origin), d = exact(direction);
  const Exact slope = dot(plane.n, d);
  if (slope.sign() == 0) return {};
  const bool entering = (slope.sign() < 0) != flipped;
  const Exact depth = plane.depth(o);
  if (depth.sign() == 0) return {1, {bare_landing(0, entering, origin, direction), {}}};
  const Wide t = depth.wide() / slope.wide();
  Landing landing = bare_landing(t, entering, origin, direction);
  if (detail == Detail::places) {
    landing.point = rounded(place(o, d, t));
    const Vec3 n = unit(wide(plane.n));
    landing.normal = flipped ? -n : n;
  }
  return {1, {landing, {}}};
}

/// A side of a box, as a quotient whose denominator is positive.
struct Side {
  Exact depth, slope;
  int face = 0;
  friend bool operator<(const Side& a, const Side& b) { return a.depth * b.slope < b.depth * a.slope; }
};

Vec3 row(const BoxPrimitive& box, int axis) {
  if (!box.aligned) return box.to_own[static_cast<std::size_t>(axis)];
  Vec3 n;
  n[axis] = 1;
  return n;
}

ExactVec from_center(const BoxPrimitive& box, Vec3 p) {
  return box.aligned ? exact(p) : exact(p) - exact(box.center);
}

/// The part of the ray inside the box; false: none.
bool clip(const BoxPrimitive& box, const ExactVec& f, const ExactVec& d, Side& enter, Side& leave) {
  bool any = false;
  for (int axis = 0; axis < 3; ++axis) {
    const ExactVec n = exact(row(box, axis));
    const Exact at = dot(n, f), slope = dot(n, d);
    const Exact to_lo = box.lo[axis] - at, to_hi = box.hi[axis] - at;
    if (slope.sign() == 0) {
      if (to_lo.sign() > 0 || to_hi.sign() < 0) return false;
      continue;
    }
    const bool upwards = slope.sign() > 0;
    const Side in = upwards ? Side{to_lo, slope, 2 * axis} : Side{-to_hi, -slope, 2 * axis + 1};
    const Side out = upwards ? Side{to_hi, slope, 2 * axis + 1} : Side{-to_lo, -slope, 2 * axis};
    if (!any || enter < in) enter = in;
    if (!any || out < leave) leave = out;
    any = true;
  }
  return any && !(leave < enter);
}

int out_of(const Exact& lo, const Exact& value, const Exact& hi) {
  return std::max((lo - value).sign(), (value - hi).sign());
}

}  // namespace

Landings careful(const SpherePrimitive& sphere, Vec3 origin, Vec3 direction, Detail detail) {
  if (!is_finite(origin, direction)) return {};
  const ExactVec d = exact(direction), f = exact(origin) - exact(sphere.center);
  const Exact r = sphere.radius;
  Wide t[2];
  if (!solve(dot(d, d), dot(f, d), dot(f, f) - r * r, t[0], t[1])) return {};
  Landings out{2, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    out.at[i] = bare_landing(t[i], i == 0, origin, direction);
    if (detail == Detail::distances) continue;
    out.at[i].point = rounded(place(exact(origin), d, t[i]));
    out.at[i].normal = rounded(place(f, d, t[i]) * (Wide(1) / r.wide()));
  }
  return out;
}

Landings careful(const EllipsoidPrimitive& e, Vec3 origin, Vec3 direction, Detail detail) {
  if (!is_finite(origin, direction)) return {};
  const ExactVec d = exact(direction), offset = exact(origin) - exact(e.center);
  const ExactVec rows[3] = {exact(e.to_own[0]), exact(e.to_own[1]), exact(e.to_own[2])};
  const auto own = [&rows](const ExactVec& v) -> ExactVec {
    return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)};
  };
  const ExactVec g = own(offset), h = own(d);
  Wide t[2];
  if (!solve(dot(h, h), dot(g, h), dot(g, g) - Exact(1), t[0], t[1])) return {};
  Landings out{2, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    out.at[i] = bare_landing(t[i], i == 0, origin, direction);
    if (detail == Detail::distances) continue;
    const WideVec w = place(g, h, t[i]);
    out.at[i].point = rounded(place(exact(origin), d, t[i]));
    out.at[i].normal = unit(wide(rows[0]) * w.x + wide(rows[1]) * w.y + wide(rows[2]) * w.z);
  }
  return out;
}

Landings careful(const PlanePrimitive& plane, Vec3 origin, Vec3 direction, Detail detail) {
  if (!is_finite(origin, direction)) return {};
  return meet({exact(plane.normal), plane.level, exact(plane.point)}, origin, direction, false, detail);
}

Landings careful(const BoxPrimitive& box, Vec3 origin, Vec3 direction, Detail detail) {
  if (!is_finite(origin, direction)) return {};
  const ExactVec o = exact(origin), d = exact(direction);
  Side side[2];
  if (!clip(box, from_center(box, origin), d, side[0], side[1])) return {};
  Landings out{2, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    const Wide t = side[i].depth.wide() / side[i].slope.wide();
    out.at[i] = bare_landing(t, i == 0, origin, direction, side[i].face);
    if (detail == Detail::distances) continue;
    out.at[i].point = rounded(place(o, d, t));
    const Vec3 n = unit(wide(exact(row(box, side[i].face / 2))));
    out.at[i].normal = side[i].face % 2 == 0 ? -n : n;
  }
  return out;
}

Landings careful(const FacetPrimitive& facet, Vec3 origin, Vec3 direction, Detail detail) {
  if (!is_finite(origin, direction)) return {};
  Landings quick;
  if (detail == Detail::distances && careful_distance(facet, origin, direction, quick)) return quick;
  if (!Corners<Exact>(facet, origin, direction).surround()) return {};
  const ExactVec a = exact(facet.a);
  const ExactVec n = cross(exact(facet.b) - a, exact(facet.c) - a);
  return meet({n, 0.0, a}, origin, direction, facet.flipped, detail);
}

bool careful_has_area(const FacetPrimitive& facet) {
  const ExactVec n = cross(exact(facet.b) - exact(facet.a), exact(facet.c) - exact(facet.a));
  return n.x.sign() != 0 || n.y.sign() != 0 || n.z.sign() != 0;
}

int careful_side(const SpherePrimitive& sphere, Vec3 p) {
  const ExactVec f = exact(p) - exact(sphere.center);
  const Exact r = sphere.radius;
  return (dot(f, f) - r * r).sign();
}

int careful_side(const EllipsoidPrimitive& e, Vec3 p) {
  const ExactVec f = exact(p) - exact(e.center);
  Exact sum = -1.0;
  for (const Vec3 row : e.to_own) {
    const Exact own = dot(exact(row), f);
    sum = sum + own * own;
  }
  return sum.sign();
}

int careful_side(const PlanePrimitive& plane, Vec3 p) {
  return -ExactPlane{exact(plane.normal), plane.level, exact(plane.point)}.depth(exact(p)).sign();
}

int careful_side(const BoxPrimitive& box, Vec3 p) {
  const ExactVec f = from_center(box, p);
  int out = -1;
  for (int axis = 0; axis < 3; ++axis)
    out = std::max(out, out_of(box.lo[axis], dot(exact(row(box, axis)), f), box.hi[axis]));
  return out;
}

}  // namespace lancer::tracer
