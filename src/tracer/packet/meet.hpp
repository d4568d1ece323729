#pragma once
// Where rays meet surfaces: the quick tests of shapes/ for four lanes at a time. Compiled in the namespace
// LANCER_TARGET; see shapes/lanes.hpp.

#include "tracer/packet/surfaces.hpp"

namespace lancer::tracer::LANCER_TARGET {

/// False: no ray meets it.
LANCER_INLINE bool meet(const Spheres& sphere, const Probes& p, Mask asked, Crossings& out) {
  const Lanes r = sphere.radius;
  const Vectors f = p.origin - sphere.center;
  const Lanes b = -dot(f, p.direction);
  const Vectors from_axis = f + p.direction * b;
  const Lanes discriminant = r * r - dot(from_axis, from_axis);
  const Lanes reach = sum_abs(f);
  const Lanes lost = lanes(20 * k_u) * reach;
  const Lanes doubt = lanes(2.0) * lost * (sum_abs(from_axis) + lost) + lanes(4 * k_u) * r * r;
  const Mask may = asked & ~mask(discriminant < -doubt);
  if (!any(may)) return false;
  const Lanes half_chord = square_root(select(mask(discriminant > doubt), discriminant, lanes(1.0)));
  const Lanes near = b - half_chord, far = b + half_chord;
  const Lanes lateral = (sphere.slack * r + doubt) / half_chord;
  const Lanes error = sphere.slack + lateral + lanes(18 * k_u) * (reach + r);
  const Mask certain = mask(discriminant > doubt) & mask(abs(near) > error) & mask(abs(far) > error);
  out.entering = mask(near > lanes(0.0));
  out.t = select(out.entering, near, far);
  out.error = error;
  out.crossed = may & certain;
  out.met = out.crossed & mask(out.t > lanes(0.0));
  out.doubt = may & ~certain;
  out.out_t = far;
  out.out_error = error;
  // What is left of the normal's cosine, half the chord to the radius, whatever the rounding.
  const Lanes cosine =
      select(mask(discriminant > lanes(16.0) * doubt), lanes(0.5) * half_chord / r, lanes(0.0));
  out.clear = (lesser(abs(near), abs(far)) - error) * cosine;
  return true;
}

LANCER_INLINE bool meet(const PlanePrimitive& plane, const Probes& p, Mask asked, Crossings& out) {
  const Vectors offset = p.origin - vectors(plane.point);
  const Lanes distance = sum_abs(offset);
  Mask loose;
  if (plane.across >= 0) {
    const Lanes inverse = p.inverse[plane.across];
    out.t = -offset[plane.across] * inverse;
    const Lanes steep = abs(inverse), far = abs(out.t);
    const Lanes slack = lanes(plane.slack) + lanes(plane.normal_error) * (distance + lanes(2.0) * far);
    out.entering = is_negative(inverse) ^ is_negative(lanes(plane.normal[plane.across]));
    out.error = slack * steep + lanes(4 * k_u) * far;
    loose = mask(lanes(plane.normal_error) * steep > lanes(0.5));
    out.doubt = masks(0);
  } else {
    const Vectors n = vectors(plane.normal);
    const Lanes size = lanes(plane.size), level = lanes(plane.level);
    const Lanes slope = dot(n, p.direction);
    const Lanes depth = level - dot(n, offset);
    const Lanes own_slope_error = lanes(3 * k_u) * size;
    const Lanes own_depth_error = lanes(5 * k_u) * (size * distance + abs(level));
    out.doubt = asked & ~(mask(abs(slope) > own_slope_error) & mask(abs(depth) > own_depth_error));
    const Lanes depth_error =
        own_depth_error + size * (lanes(plane.slack) + lanes(plane.normal_error) * distance);
    const Lanes slope_error = own_slope_error + size * lanes(plane.normal_error);
    const Lanes inverse = lanes(1.0) / slope;
    out.t = depth * inverse;
    const Lanes steep = abs(inverse), far = abs(out.t);
    out.error = (depth_error + lanes(2.0) * far * slope_error) * steep + lanes(4 * k_u) * far;
    out.entering = mask(slope < lanes(0.0));
    loose = mask(slope_error * steep > lanes(0.5));
  }
  const Mask ahead = asked & mask(out.t > lanes(0.0)) & is_finite(out.t) & ~out.doubt;
  out.doubt |= ahead & loose;
  out.met = ahead & ~loose;
  return true;
}

/// A corner as seen from the rays' starts, sheared so that the rays run along +z.
struct Sheared {
  Lanes x, y, size;
};
LANCER_INLINE Sheared shear(const Vectors& corner, const Probes& p) {
  const Vectors v = corner - p.origin;
  const Lanes z = v[p.kz];
  return {v[p.kx] - p.shear_x * z, v[p.ky] - p.shear_y * z, sum_abs(v)};
}

LANCER_INLINE bool meet(const Facets& f, const Probes& p, Mask asked, Crossings& out) {
  if (p.kz < 0) {
    out.met = out.crossed = masks(0);
    out.doubt = asked;
    return true;
  }
  const Sheared a = shear(f.a, p), b = shear(f.b, p), c = shear(f.c, p);
  const Lanes u = c.x * b.y - c.y * b.x;
  const Lanes v = a.x * c.y - a.y * c.x;
  const Lanes w = b.x * a.y - b.y * a.x;
  const Lanes spread = abs(a.x) + abs(a.y) + abs(b.x) + abs(b.y) + abs(c.x) + abs(c.y);
  const Lanes off = lanes(5 * k_u) * greater(a.size, greater(b.size, c.size));
  const Lanes doubt =
      off * spread + lanes(2 * k_u) * (spread * spread) + lanes(2.0) * off * off + lanes(0x1p-1000);
  const Lanes rim = lanes(4.0) * f.slack * spread;
  const Lanes least = lesser(u, lesser(v, w)), most = greater(u, greater(v, w));
  const Mask misses = mask(least < -doubt - rim) & mask(most > doubt + rim);
  const Mask may = asked & ~misses;
  if (!any(may)) return false;
  const Mask hits = mask(least > doubt) | mask(most < -doubt);
  const Mask front = mask(u + v + w > lanes(0.0));
  out.entering = front ^ f.flipped;
  const Vectors& n = f.normal;
  const Vectors way = f.a - p.origin;
  const Lanes depth = dot(n, way), slope = dot(n, p.direction);
  const Lanes reach = sum_abs(way);
  // As depth_slack() has it, of origin - a.
  const Lanes depth_error = lanes(8 * k_u) * reach + lanes(2.0) * (f.slack + lanes(3 * k_u) * reach);
  const Lanes slope_error = lanes(8 * k_u + 6 * k_u);
  const Lanes inverse = lanes(1.0) / slope;
  out.t = depth * inverse;
  const Lanes steep = abs(inverse), far = abs(out.t);
  out.error = (depth_error + lanes(2.0) * far * slope_error) * steep + lanes(4 * k_u) * far;
  const Mask certain = hits & mask(far > out.error) & ~mask(slope_error * steep > lanes(0.5));
  out.crossed = may & certain;
  out.slope = slope;
  out.met = out.crossed & mask(out.t > lanes(0.0));
  out.doubt = may & ~certain;
  return true;
}

/// One by one.
LANCER_INLINE bool meet(const Other& other, const Probes& p, Mask asked, Crossings& out) {
  out.met = out.crossed = out.doubt = out.entering = masks(0);
  out.clear = lanes(0.0);
  for (int i = 0; i < 4; ++i) {
    if (asked[i] == 0) continue;
    const FirstRoot first =
        first_root(other.world, other.primitive, {p.origin.x[i], p.origin.y[i], p.origin.z[i]},
                   {p.direction.x[i], p.direction.y[i], p.direction.z[i]});
    out.met[i] = first.met ? -1 : 0;
    out.crossed[i] = first.crossed ? -1 : 0;
    out.doubt[i] = first.in_doubt ? -1 : 0;
    out.entering[i] = first.entering ? -1 : 0;
    out.t[i] = first.t;
    out.error[i] = first.error;
  }
  return any(out.met | out.crossed | out.doubt);
}

}  // namespace lancer::tracer::LANCER_TARGET
