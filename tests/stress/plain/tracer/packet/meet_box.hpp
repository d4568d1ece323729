#pragma once
// In place of the tracer's own: the plain slab test, four rays at a time.

#include "tracer/packet/meet.hpp"

namespace lancer::tracer::LANCER_TARGET {

/// The crossing of one side.
struct BoxRoots {
  Lanes t, error;
  Mask loose, face;  // see with_face()
};

/// The last side on the way in and the first on the way out.
struct BoxClip {
  BoxRoots in{lanes(-k_infinity), lanes(0.0), masks(0), masks(0)};
  BoxRoots out{lanes(k_infinity), lanes(0.0), masks(0), masks(0)};

  LANCER_INLINE BoxClip(const BoxPrimitive& box, const Probes& p) {
    Vectors o = p.origin, d = p.direction, inverse = p.inverse;
    if (!box.aligned) {
      const auto apply = [&](const Vectors& v) {
        const Rows& m = box.to_own;
        return Vectors{dot(vectors(m[0]), v), dot(vectors(m[1]), v), dot(vectors(m[2]), v)};
      };
      o = apply(o - vectors(box.center));
      d = apply(d);
      const Lanes one = lanes(1.0);
      inverse = {one / d.x, one / d.y, one / d.z};
    }
    const auto face = [](int axis, Mask upper) { return masks(axis) << 33 | (upper & masks(1LL << 32)); };
    for (int axis = 0; axis < 3; ++axis) {
      const Lanes lower = (lanes(box.lo[axis]) - o[axis]) * inverse[axis];
      const Lanes upper = (lanes(box.hi[axis]) - o[axis]) * inverse[axis];
      const Mask up = mask(d[axis] > lanes(0.0));
      const Lanes enter = lesser(lower, upper), leave = greater(lower, upper);
      const Mask later = mask(enter > in.t), sooner = mask(leave < out.t);
      in.t = select(later, enter, in.t);
      in.face = select(later, face(axis, ~up), in.face);
      out.t = select(sooner, leave, out.t);
      out.face = select(sooner, face(axis, up), out.face);
    }
  }
};

LANCER_INLINE bool meet(const BoxPrimitive& box, const Probes& p, Mask asked, Crossings& out) {
  const BoxClip clip(box, p);
  if (!cross(asked & mask(clip.in.t <= clip.out.t), clip.in.t, clip.out.t, out)) return false;
  out.face = select(out.entering, clip.in.face, clip.out.face);
  return true;
}

struct BoxExits {
  BoxRoots root;
  Mask known;
};
LANCER_INLINE BoxExits exit(const BoxPrimitive& box, const Probes& p) {
  return {BoxClip(box, p).out, masks(-1)};
}

}  // namespace lancer::tracer::LANCER_TARGET
