#pragma once
// Rays and surfaces side by side, as the quick tests take them. Compiled in the namespace LANCER_TARGET; see
// shapes/lanes.hpp.

#include <utility>

#include "tracer/packet/kernels.hpp"
#include "tracer/packet/vectors.hpp"

namespace lancer::tracer::LANCER_TARGET {

LANCER_INLINE Vectors load(const Vec3s& v, std::size_t at) {
  return {load(&v.x[at]), load(&v.y[at]), load(&v.z[at])};
}
LANCER_INLINE void store(Vec3s& to, std::size_t at, const Vectors& v) {
  store(&to.x[at], v.x);
  store(&to.y[at], v.y);
  store(&to.z[at], v.z);
}

/// What intersection tests want to know of four rays; see Probe.
struct Probes {
  Vectors origin, direction, inverse;
  Mask active;
  int kx = 0, ky = 1, kz = 2;  // -1: not the same for all
  Lanes shear_x, shear_y;
};

LANCER_INLINE void set_shear(Probes& p) {
  const Vectors a{abs(p.direction.x), abs(p.direction.y), abs(p.direction.z)};
  const Mask x_over_y = mask(a.x > a.y);
  const Mask is_x = x_over_y & mask(a.x > a.z), is_y = ~x_over_y & mask(a.y > a.z);
  const unsigned all = bits(p.active), x = bits(is_x) & all, y = bits(is_y) & all;
  p.kz = -1;
  if (x == all) p.kz = 0;
  if (y == all) p.kz = 1;
  if (x == 0 && y == 0) p.kz = 2;
  if (p.kz < 0) return;
  const unsigned backwards = bits(mask(p.direction[p.kz] < lanes(0.0))) & all;
  if (backwards != 0 && backwards != all) {
    p.kz = -1;
    return;
  }
  p.kx = (p.kz + 1) % 3;
  p.ky = (p.kx + 1) % 3;
  if (backwards != 0) std::swap(p.kx, p.ky);
  p.shear_x = p.direction[p.kx] / p.direction[p.kz];
  p.shear_y = p.direction[p.ky] / p.direction[p.kz];
}

/// Surfaces side by side: one that four rays are asked for, or four that one ray is.
struct Spheres {
  Vectors center;
  Lanes radius, slack;
};
struct Facets {
  Vectors a, b, c, normal;
  Lanes slack;
  Mask flipped;
};

LANCER_INLINE Spheres four_times(const SpherePrimitive& s) {
  return {vectors(s.center), lanes(s.radius), lanes(s.slack)};
}
LANCER_INLINE Facets four_times(const FacetPrimitive& f) {
  return {vectors(f.a),      vectors(f.b),   vectors(f.c),
          vectors(f.normal), lanes(f.slack), masks(f.flipped ? -1 : 0)};
}

/// Neighbours mostly meet the same surface.
LANCER_INLINE bool are_one(const std::uint32_t* four) {
  return four[0] == four[1] && four[0] == four[2] && four[0] == four[3];
}

/// What get() gives for each of four things.
template <class Get>
LANCER_INLINE Lanes gather(const std::uint32_t* four, Get get) {
  return Lanes{get(four[0]), get(four[1]), get(four[2]), get(four[3])};
}
LANCER_INLINE Vectors side_by_side(const std::array<Vec3, 4>& v) {
  return {Lanes{v[0].x, v[1].x, v[2].x, v[3].x}, Lanes{v[0].y, v[1].y, v[2].y, v[3].y},
          Lanes{v[0].z, v[1].z, v[2].z, v[3].z}};
}
template <class Get>
LANCER_INLINE Vectors gather_vectors(const std::uint32_t* four, Get get) {
  return side_by_side({get(four[0]), get(four[1]), get(four[2]), get(four[3])});
}

LANCER_INLINE Spheres spheres(const Scenery& s, const std::uint32_t* four) {
  const auto of = [&](std::uint32_t p) -> const SpherePrimitive& {
    return s.spheres[s.primitives[p].record];
  };
  if (are_one(four)) return four_times(of(four[0]));
  return {gather_vectors(four, [&](std::uint32_t p) { return of(p).center; }),
          gather(four, [&](std::uint32_t p) { return of(p).radius; }),
          gather(four, [&](std::uint32_t p) { return of(p).slack; })};
}
LANCER_INLINE Facets facets(const Scenery& s, const std::uint32_t* four) {
  const auto of = [&](std::uint32_t p) -> const FacetPrimitive& { return s.facets[s.primitives[p].record]; };
  if (are_one(four)) return four_times(of(four[0]));
  const auto flipped = [&](std::size_t i) -> long long { return of(four[i]).flipped ? -1 : 0; };
  return {gather_vectors(four, [&](std::uint32_t p) { return of(p).a; }),
          gather_vectors(four, [&](std::uint32_t p) { return of(p).b; }),
          gather_vectors(four, [&](std::uint32_t p) { return of(p).c; }),
          gather_vectors(four, [&](std::uint32_t p) { return of(p).normal; }),
          gather(four, [&](std::uint32_t p) { return of(p).slack; }),
          Mask{flipped(0), flipped(1), flipped(2), flipped(3)}};
}

/// As along_ray().
LANCER_INLINE Lanes along_rays(Lanes shift, Lanes radius, Lanes half_chord) {
  const Lanes rise = shift * radius;
  const Mask steep = mask(half_chord > lanes(0.0)) & mask(lanes(2.0) * half_chord * half_chord >= rise);
  return shift + select(steep, rise / half_chord, square_root(lanes(2.0) * rise));
}

/// One of any other kind.
struct Other {
  const World& world;
  std::uint32_t primitive;
};

/// The part of the rays within the box; see interval().
struct Intervals {
  Lanes enter, leave;
};
LANCER_INLINE Intervals interval(const Vectors& lo, const Vectors& hi, const Probes& p) {
  const Lanes widen = lanes(1 + 2 * gamma(3));
  Intervals out{lanes(0.0), lanes(k_infinity)};
  for (int axis = 0; axis < 3; ++axis) {
    const Lanes inverse = p.inverse[axis];
    const Mask backwards = is_negative(inverse);
    const Lanes enter = (select(backwards, hi[axis], lo[axis]) - p.origin[axis]) * inverse;
    const Lanes leave = (select(backwards, lo[axis], hi[axis]) - p.origin[axis]) * inverse * widen;
    out.enter = select(mask(enter > out.enter), enter, out.enter);
    out.leave = select(mask(leave < out.leave), leave, out.leave);
  }
  return out;
}

/// Larger by `margin` and by the rounding of the corners themselves; see Aabb::padded().
LANCER_INLINE void pad(Vectors& lo, Vectors& hi, Lanes margin) {
  const auto wider = [&](Lanes& low, Lanes& high) {
    const Lanes by = margin + lanes(4 * k_u) * greater(abs(low), abs(high));
    low = low - by;
    high = high + by;
  };
  wider(lo.x, hi.x);
  wider(lo.y, hi.y);
  wider(lo.z, hi.z);
}

/// The part of the rays within the surfaces' own bounds.
LANCER_INLINE Intervals own_interval(const Spheres& s, const Probes& p) {
  const Vectors half{s.radius, s.radius, s.radius};
  Vectors lo = s.center - half, hi = s.center + half;
  pad(lo, hi, s.slack);
  return interval(lo, hi, p);
}
LANCER_INLINE Intervals own_interval(const Facets& f, const Probes& p) {
  const Vectors &a = f.a, &b = f.b, &c = f.c;
  Vectors lo{lesser(lesser(a.x, b.x), c.x), lesser(lesser(a.y, b.y), c.y), lesser(lesser(a.z, b.z), c.z)};
  Vectors hi{greater(greater(a.x, b.x), c.x), greater(greater(a.y, b.y), c.y),
             greater(greater(a.z, b.z), c.z)};
  pad(lo, hi, f.slack);
  return interval(lo, hi, p);
}

LANCER_INLINE Intervals own_interval(const PlanePrimitive&, const Probes&) {
  return {lanes(0.0), lanes(k_infinity)};
}
LANCER_INLINE Intervals own_interval(const BoxPrimitive& box, const Probes& p) {
  const Aabb own = bounds(box);
  return interval(vectors(own.lo), vectors(own.hi), p);
}
LANCER_INLINE Intervals own_interval(const Other& other, const Probes& p) {
  double box[6];
  own_bounds(other.world, other.primitive, box);
  return interval({lanes(box[0]), lanes(box[1]), lanes(box[2])},
                  {lanes(box[3]), lanes(box[4]), lanes(box[5])}, p);
}

/// The first crossing ahead of each ray, where a primitive's quick test is certain of it; `doubt` where not.
struct Crossings {
  Mask met, doubt;
  Lanes t, error;
  Mask entering;
  Mask crossed;  // of solids and facets: surely met ahead or behind
  Lanes slope;   // of facets: how steeply the ray meets it
  /// Of convex solids: by how much, at the least, the line's crossings lie beside the surface's tangent plane
  /// at the start.
  Lanes clear;
  Lanes out_t, out_error;  // of convex solids, where entering: of the way out
  Mask face;               // of boxes, in the place where with_face() has it
};

}  // namespace lancer::tracer::LANCER_TARGET
