#pragma once
// Ways to meet a box: the candidates that the tracer's own is measured against, on the same rays.

#include <algorithm>
#include <limits>
#include <vector>

#include "stress/methods/facet.hpp"
#include "stress/truth/box.hpp"

namespace lancer::stress::flat {

/// The outward unit normal of a side, in plain arithmetic.
inline Vec3 side_normal(const BoxNumbers& box, int face) {
  const double sign = face % 2 == 0 ? -1 : 1;
  if (box.turned) return normalize(box.to_own[static_cast<std::size_t>(face / 2)] * sign);
  Vec3 n;
  n[face / 2] = sign;
  return n;
}

inline Place plain_place(const BoxNumbers& box, const Aim& ray, const Answer& answer) {
  return {ray.origin + ray.direction * answer.t, side_normal(box, answer.face)};
}

/// Two facets a side; where two of them are met equally far, neither is believed.
struct TwelveFacets {
  static constexpr const char* k_name = "naive, 12 facets";
  struct Prepared {
    BoxNumbers box;
    std::vector<Triangle> facets;  // two a side, in the order of the sides
  };
  static Prepared prepare(const BoxNumbers& box) {
    Prepared out{box, {}};
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2, j = (axis + 1) % 3, k = (axis + 2) % 3;
      const auto corner = [&](bool at_j, bool at_k) {
        Vec3 own;
        own[axis] = face % 2 == 0 ? box.lo[axis] : box.hi[axis];
        own[j] = at_j ? box.hi[j] : box.lo[j];
        own[k] = at_k ? box.hi[k] : box.lo[k];
        return in_world(box, own);
      };
      out.facets.push_back({corner(false, false), corner(true, false), corner(true, true)});
      out.facets.push_back({corner(false, false), corner(true, true), corner(false, true)});
    }
    return out;
  }
  static Answer test(const Prepared& box, const Aim& ray) {
    constexpr double k_epsilon = 1e-6;
    Answer best;
    bool tie = false;
    for (std::size_t i = 0; i < box.facets.size(); ++i) {
      Answer one = NaiveFacet::test(box.facets[i], ray);
      if (!one.hit) continue;
      one.face = static_cast<int>(i / 2);
      tie = best.hit && std::fabs(one.t - best.t) < k_epsilon;
      if (!best.hit || one.t < best.t) best = one;
    }
    if (tie) best.hit = false;
    return best;
  }
  static Place place(const Prepared& box, const Aim& ray, const Answer& answer) {
    return plain_place(box.box, ray, answer);
  }

 private:
  static Vec3 in_world(const BoxNumbers& box, Vec3 own) {
    if (!box.turned) return own;
    const auto& m = box.to_own;
    const Vec3 x = cross(m[1], m[2]), y = cross(m[2], m[0]), z = cross(m[0], m[1]);
    return box.center + (x * own.x + y * own.y + z * own.z) / dot(m[0], x);
  }
};

/// (bound - origin) times the reciprocal, smaller and larger, without a thought for 0 times infinity.
struct SlabReciprocal {
  static constexpr const char* k_name = "slab, reciprocal";
  using Prepared = BoxNumbers;
  static Prepared prepare(const BoxNumbers& box) { return box; }
  static Answer test(const Prepared& box, const Aim& ray) {
    Vec3 o = ray.origin, inverse = ray.inverse;
    if (box.turned) {
      o = tracer::apply(box.to_own, o - box.center);
      const Vec3 d = tracer::apply(box.to_own, ray.direction);
      inverse = {1 / d.x, 1 / d.y, 1 / d.z};
    }
    double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
    int in = 0, out = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double t1 = (box.lo[axis] - o[axis]) * inverse[axis];
      const double t2 = (box.hi[axis] - o[axis]) * inverse[axis];
      const double nearer = std::min(t1, t2), farther = std::max(t1, t2);
      if (!(enter >= nearer)) {
        enter = nearer;
        in = 2 * axis + (t1 < t2 ? 0 : 1);
      }
      if (!(leave <= farther)) {
        leave = farther;
        out = 2 * axis + (t1 < t2 ? 1 : 0);
      }
    }
    if (!(enter <= leave && leave > 0)) return {};
    return enter > 0 ? Answer{true, enter, 0, in} : Answer{true, leave, 0, out};
  }
  static Place place(const Prepared& box, const Aim& ray, const Answer& answer) {
    return plain_place(box, ray, answer);
  }
};

/// A ray in the frame of the box, in numbers of one kind.
template <class Number>
struct OwnRay {
  Number origin[3], direction[3];
};
inline double leading(double v) { return v; }
inline double leading(DoubleDouble v) { return v.hi; }
inline double trailing(double) { return 0; }
inline double trailing(DoubleDouble v) { return v.lo; }

/// Divisions, and a branch for rays that keep between two sides.
template <class Number>
Answer slab_by_division(const BoxNumbers& box, const OwnRay<Number>& ray) {
  bool any = false;
  Number enter{}, leave{};
  int in = 0, out = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Number below = box.lo[axis] - ray.origin[axis], above = box.hi[axis] - ray.origin[axis];
    const double d = leading(ray.direction[axis]);
    if (d == 0) {
      if (leading(below) > 0 || leading(above) < 0) return {};
      continue;
    }
    const Number nearer = (d > 0 ? below : above) / ray.direction[axis];
    const Number farther = (d > 0 ? above : below) / ray.direction[axis];
    const bool back = d < 0;
    if (!any || leading(nearer - enter) > 0) {
      enter = nearer;
      in = 2 * axis + (back ? 1 : 0);
    }
    if (!any || leading(farther - leave) < 0) {
      leave = farther;
      out = 2 * axis + (back ? 0 : 1);
    }
    any = true;
  }
  if (leading(enter - leave) > 0 || !(leading(leave) > 0)) return {};
  if (leading(enter) > 0) return {true, leading(enter), trailing(enter), in};
  return {true, leading(leave), trailing(leave), out};
}

struct SlabDivision {
  static constexpr const char* k_name = "slab, division";
  using Prepared = BoxNumbers;
  static Prepared prepare(const BoxNumbers& box) { return box; }
  static Answer test(const Prepared& box, const Aim& ray) {
    const Vec3 o = box.turned ? tracer::apply(box.to_own, ray.origin - box.center) : ray.origin;
    const Vec3 d = box.turned ? tracer::apply(box.to_own, ray.direction) : ray.direction;
    return slab_by_division<double>(box, {{o.x, o.y, o.z}, {d.x, d.y, d.z}});
  }
  static Place place(const Prepared& box, const Aim& ray, const Answer& answer) {
    return plain_place(box, ray, answer);
  }
};

struct DoubleDoubleBox {
  static constexpr const char* k_name = "double-double";
  using Prepared = BoxNumbers;
  static Prepared prepare(const BoxNumbers& box) { return box; }
  static Answer test(const Prepared& box, const Aim& ray) {
    OwnRay<DoubleDouble> own;
    const Dd3 offset = difference(ray.origin, box.center);
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 row = box.to_own[static_cast<std::size_t>(axis)], d = ray.direction;
      own.origin[axis] = box.turned ? dot(row, offset) : DoubleDouble{ray.origin[axis], 0};
      own.direction[axis] = box.turned
                                ? two_product(row.x, d.x) + two_product(row.y, d.y) + two_product(row.z, d.z)
                                : DoubleDouble{d[axis], 0};
    }
    return slab_by_division<DoubleDouble>(box, own);
  }
  static Place place(const Prepared& box, const Aim& ray, const Answer& answer) {
    const Vec3 row = box.to_own[static_cast<std::size_t>(answer.face / 2)];
    const Vec3 plain = side_normal(box, answer.face);
    const double sign = answer.face % 2 == 0 ? -1 : 1;
    return {along(ray, answer), box.turned ? normalize(difference(row * sign, Vec3{})) : plain};
  }
};

}  // namespace lancer::stress::flat
