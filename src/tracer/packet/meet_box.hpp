#pragma once
// Where four rays meet a box: the quick test of shapes/box.cpp. Compiled in the namespace LANCER_TARGET.

#include "tracer/packet/meet.hpp"

namespace lancer::tracer::LANCER_TARGET {

/// Rays in the frame of a box's test; see Local.
struct BoxRays {
  Vectors origin, direction, inverse;
  Vectors origin_error, direction_error;
};

LANCER_INLINE Vectors apply(const Rows& m, const Vectors& v) {
  return {dot(vectors(m[0]), v), dot(vectors(m[1]), v), dot(vectors(m[2]), v)};
}

LANCER_INLINE BoxRays to_frame(const BoxPrimitive& box, const Probes& p) {
  if (box.aligned) {
    const Vectors none = vectors(Vec3{});
    return {p.origin, p.direction, p.inverse, none, none};
  }
  const Vectors offset = p.origin - vectors(box.center);
  const Vectors origin = apply(box.to_own, offset), direction = apply(box.to_own, p.direction);
  const Lanes one = lanes(1.0);
  return {origin,
          direction,
          {one / direction.x, one / direction.y, one / direction.z},
          vectors(box.reach) * (lanes(6 * k_u) * largest(offset)),
          vectors(box.reach * (4 * k_u))};
}

/// The crossing with one side of each pair, as computed; and across which axis that lies.
struct Sides {
  Lanes t, error;
  Lanes slope, reach;
  Mask axis, up;

  LANCER_INLINE void take(Mask where, const Sides& other) {
    t = select(where, other.t, t);
    error = select(where, other.error, error);
    slope = select(where, other.slope, slope);
    reach = select(where, other.reach, reach);
    axis = select(where, other.axis, axis);
    up = select(where, other.up, up);
  }
};

/// How a ray and a box's sides are: the last side on the way in and the first on the way out.
struct BoxClip {
  Sides in, out;
  Mask misses, hits;  // surely

  LANCER_INLINE BoxClip(const BoxPrimitive& box, const BoxRays& ray) {
    std::array<Sides, 3> ins, outs;
    Mask unknown = masks(0);
    for (int axis = 0; axis < 3; ++axis) {
      const Lanes o = ray.origin[axis], d = ray.direction[axis], inverse = ray.inverse[axis];
      const Lanes lower = (lanes(box.lo[axis]) - o) * inverse, upper = (lanes(box.hi[axis]) - o) * inverse;
      const Lanes sizes = abs(lower) + abs(upper);
      Lanes error = lanes(4 * k_u) * sizes;
      if (box.aligned) {
        unknown |= mask(d == lanes(0.0));
      } else {
        const Lanes moved = ray.origin_error[axis] + sizes * ray.direction_error[axis];
        error = lanes(1.5) * moved * abs(inverse) + error;
        unknown |= mask(abs(d) <= lanes(4.0) * ray.direction_error[axis]);
      }
      const auto i = static_cast<std::size_t>(axis);
      ins[i] = {lesser(lower, upper), error, d, lanes(box.reach[axis]), masks(axis), mask(d > lanes(0.0))};
      outs[i] = ins[i];
      outs[i].t = greater(lower, upper);
    }
    in = ins[0];
    out = outs[0];
    for (std::size_t i = 1; i < 3; ++i) {
      in.take(mask(ins[i].t > in.t), ins[i]);
      out.take(mask(outs[i].t < out.t), outs[i]);
    }
    const Lanes doubt = in.error + out.error;
    misses = ~unknown & mask(in.t > out.t + doubt);
    hits = ~unknown & mask(in.t + doubt < out.t);
    const Lanes near = in.t - in.error, far = out.t + out.error;
    for (std::size_t i = 0; i < 3; ++i) {
      hits &= mask(in.axis == ins[i].axis) | mask(ins[i].t + ins[i].error < near);
      hits &= mask(out.axis == outs[i].axis) | mask(outs[i].t - outs[i].error > far);
    }
  }
};

/// As root_at().
struct BoxRoots {
  Lanes t, error;
  Mask loose, face;
};
LANCER_INLINE BoxRoots root_at(const BoxPrimitive& box, const Sides& side, Mask upper) {
  const Lanes steep = lanes(1.0) / abs(side.slope);
  const Lanes doubt = box.aligned ? lanes(0.0) : lanes(8 * k_u) * side.reach;
  const Lanes slack = (side.reach * lanes(box.slack) + lanes(2.0) * doubt * abs(side.t)) * steep;
  return {side.t, side.error + slack, mask(doubt * steep > lanes(0.5)),
          (side.axis << 33) | (upper & masks(1LL << 32))};
}

LANCER_INLINE bool meet(const BoxPrimitive& box, const Probes& p, Mask asked, Crossings& out) {
  const BoxClip clip(box, to_frame(box, p));
  const Mask may = asked & ~clip.misses;
  if (!any(may)) return false;
  const auto knows_sign = [](const Sides& side) {
    return mask(side.error == lanes(0.0)) | mask(abs(side.t) > side.error);
  };
  const BoxRoots in = root_at(box, clip.in, ~clip.in.up), leave = root_at(box, clip.out, clip.out.up);
  const Mask certain = clip.hits & knows_sign(clip.in) & knows_sign(clip.out) & ~in.loose & ~leave.loose;
  out.entering = mask(in.t > lanes(0.0));
  out.t = select(out.entering, in.t, leave.t);
  out.error = select(out.entering, in.error, leave.error);
  out.face = select(out.entering, in.face, leave.face);
  out.crossed = may & certain;
  out.met = out.crossed & mask(out.t > lanes(0.0));
  out.doubt = may & ~certain;
  out.out_t = leave.t;
  out.out_error = leave.error;
  const auto clear = [](const BoxRoots& root, const Sides& side) {
    return (abs(root.t) - root.error) * (lanes(0.25) * abs(side.slope) / side.reach);
  };
  out.clear = lesser(clear(in, clip.in), clear(leave, clip.out));
  return true;
}

/// As exit(); `known` where the quick test tells.
struct BoxExits {
  BoxRoots root;
  Mask known;
};
LANCER_INLINE BoxExits exit(const BoxPrimitive& box, const Probes& p) {
  const BoxClip clip(box, to_frame(box, p));
  const BoxRoots leave = root_at(box, clip.out, clip.out.up);
  return {leave, clip.hits & mask(leave.t > lanes(0.0)) & ~leave.loose};
}

}  // namespace lancer::tracer::LANCER_TARGET
