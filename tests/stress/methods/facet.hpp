#pragma once
// Ways to meet a facet, from the one in every textbook to the most careful: the candidates that the tracer's
// own is measured against, on the same rays. Each has what it works out once a facet (Prepared), the test
// that is timed, and what follows for the one winning hit.

#include "stress/methods/aim.hpp"
#include "stress/methods/dd3.hpp"

namespace lancer::stress::flat {

struct Triangle {
  Vec3 a, b, c;
};

inline Place plain_place(const Triangle& f, const Aim& ray, const Answer& answer) {
  return {ray.origin + ray.direction * answer.t, normalize(cross(f.b - f.a, f.c - f.a))};
}

/// Determinants and one length for all that is small.
struct NaiveFacet {
  static constexpr const char* k_name = "naive";
  using Prepared = Triangle;
  static Prepared prepare(const Triangle& f) { return f; }
  static Answer test(const Prepared& f, const Aim& ray) {
    constexpr double k_epsilon = 1e-6;
    const Vec3 p = f.a - f.b, q = f.a - f.c, r = f.a - ray.origin, d = ray.direction;
    const double det = dot(p, cross(q, d));
    if (std::fabs(det) < k_epsilon) return {};
    const double beta = dot(r, cross(q, d)) / det;
    const double gamma = dot(p, cross(r, d)) / det;
    const double t = dot(p, cross(q, r)) / det;
    if (t < k_epsilon || beta < 0 || gamma < 0 || beta + gamma > 1) return {};
    return {true, t, 0, 0};
  }
  static Place place(const Prepared& f, const Aim& ray, const Answer& answer) {
    return plain_place(f, ray, answer);
  }
};

/// T. Moeller, B. Trumbore, "Fast, minimum storage ray-triangle intersection" (1997), without its epsilon.
struct MollerTrumbore {
  static constexpr const char* k_name = "moller-trumbore";
  using Prepared = Triangle;
  static Prepared prepare(const Triangle& f) { return f; }
  static Answer test(const Prepared& f, const Aim& ray) {
    const Vec3 e1 = f.b - f.a, e2 = f.c - f.a;
    const Vec3 p = cross(ray.direction, e2);
    const double det = dot(e1, p);
    if (det == 0) return {};
    const double inverse = 1 / det;
    const Vec3 s = ray.origin - f.a;
    const double u = dot(s, p) * inverse;
    if (!(u >= 0 && u <= 1)) return {};
    const Vec3 q = cross(s, e1);
    const double v = dot(ray.direction, q) * inverse;
    if (!(v >= 0 && u + v <= 1)) return {};
    const double t = dot(e2, q) * inverse;
    return {t > 0, t, 0, 0};
  }
  static Place place(const Prepared& f, const Aim& ray, const Answer& answer) {
    return plain_place(f, ray, answer);
  }
};

/// D. Baldwin, M. Weber, "Fast ray-triangle intersections by coordinate transformation" (2016): the map of
/// the facet to the unit triangle, in the world's coordinates.
struct BaldwinWeber {
  static constexpr const char* k_name = "baldwin-weber";
  struct Prepared {
    Triangle f;
    Vec3 row[3];
    double offset[3] = {0, 0, 0};
  };
  static Prepared prepare(const Triangle& f) {
    Prepared out;
    out.f = f;
    const Vec3 e1 = f.b - f.a, e2 = f.c - f.a, n = cross(e1, e2);
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
      if (std::fabs(n[i]) > std::fabs(n[axis])) axis = i;
    }
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    out.row[0][j] = e2[k] / n[axis];
    out.row[0][k] = -e2[j] / n[axis];
    out.row[1][j] = -e1[k] / n[axis];
    out.row[1][k] = e1[j] / n[axis];
    out.row[2] = n / n[axis];
    out.row[2][axis] = 1;
    for (int i = 0; i < 3; ++i) out.offset[i] = -dot(out.row[i], f.a);
    return out;
  }
  static Answer test(const Prepared& f, const Aim& ray) {
    const double slope = dot(f.row[2], ray.direction);
    if (slope == 0) return {};
    const double t = -(dot(f.row[2], ray.origin) + f.offset[2]) / slope;
    if (!(t > 0)) return {};
    const Vec3 p = ray.origin + ray.direction * t;
    const double u = dot(f.row[0], p) + f.offset[0];
    if (!(u >= 0 && u <= 1)) return {};
    const double v = dot(f.row[1], p) + f.offset[1];
    return {v >= 0 && u + v <= 1, t, 0, 0};
  }
  static Place place(const Prepared& f, const Aim& ray, const Answer& answer) {
    return plain_place(f.f, ray, answer);
  }
};

/// Volumes spanned by the ray and each edge; what two facets share, both compute alike only where they go
/// round it in the same way.
struct Plucker {
  static constexpr const char* k_name = "plucker";
  using Prepared = Triangle;
  static Prepared prepare(const Triangle& f) { return f; }
  static Answer test(const Prepared& f, const Aim& ray) {
    const Vec3 a = f.a - ray.origin, b = f.b - ray.origin, c = f.c - ray.origin;
    const double u = dot(cross(c - b, c + b), ray.direction);
    const double v = dot(cross(a - c, a + c), ray.direction);
    const double w = dot(cross(b - a, b + a), ray.direction);
    const bool negative = u < 0 || v < 0 || w<0, positive = u> 0 || v > 0 || w > 0;
    if (negative && positive) return {};
    const Vec3 n = cross(f.b - f.a, f.c - f.a);
    const double slope = dot(n, ray.direction);
    if (slope == 0) return {};
    const double t = dot(n, a) / slope;
    return {t > 0, t, 0, 0};
  }
  static Place place(const Prepared& f, const Aim& ray, const Answer& answer) {
    return plain_place(f, ray, answer);
  }
};

/// a b - c d of exact sign (Kahan).
inline double kahan(double a, double b, double c, double d) {
  const double cd = c * d;
  const double error = std::fma(-c, d, cd);
  return std::fma(a, b, -cd) + error;
}

/// S. Woop, C. Benthin, I. Wald, "Watertight ray/triangle intersection" (2013).
template <bool compensated>
struct Woop {
  static constexpr const char* k_name = compensated ? "woop, kahan" : "woop";
  using Prepared = Triangle;
  static Prepared prepare(const Triangle& f) { return f; }
  static double minus(double a, double b, double c, double d) {
    if constexpr (compensated) return kahan(a, b, c, d);
    return a * b - c * d;
  }
  static Answer test(const Prepared& f, const Aim& ray) {
    const Vec3 a = f.a - ray.origin, b = f.b - ray.origin, c = f.c - ray.origin;
    const auto x = [&](Vec3 v) { return v[ray.kx] - ray.shear_x * v[ray.kz]; };
    const auto y = [&](Vec3 v) { return v[ray.ky] - ray.shear_y * v[ray.kz]; };
    const double ax = x(a), ay = y(a), bx = x(b), by = y(b), cx = x(c), cy = y(c);
    const double u = minus(cx, by, cy, bx), v = minus(ax, cy, ay, cx), w = minus(bx, ay, by, ax);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return {};
    const double det = u + v + w;
    if (det == 0) return {};
    const double t = ray.shear_z * (u * a[ray.kz] + v * b[ray.kz] + w * c[ray.kz]) / det;
    return {t > 0, t, 0, 0};
  }
  static Place place(const Prepared& f, const Aim& ray, const Answer& answer) {
    return plain_place(f, ray, answer);
  }
};

// --- Everything in twice the precision
// ---------------------------------------------------------------------------------------

inline Dd3 cross(const Dd3& a, const Dd3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The unit vector along a, of any length, rounded to doubles.
inline Vec3 normalize(const Dd3& a) {
  const double largest = std::fmax(std::fabs(a.x.hi), std::fmax(std::fabs(a.y.hi), std::fabs(a.z.hi)));
  const double scale = std::scalbn(1.0, -std::ilogb(largest));
  return unit({a.x * scale, a.y * scale, a.z * scale});
}
inline double along(double origin, double direction, const Answer& answer) {
  return (origin + DoubleDouble{answer.t, answer.low} * direction).hi;
}
inline Vec3 along(const Aim& ray, const Answer& answer) {
  return {along(ray.origin.x, ray.direction.x, answer), along(ray.origin.y, ray.direction.y, answer),
          along(ray.origin.z, ray.direction.z, answer)};
}

struct DoubleDoubleFacet {
  static constexpr const char* k_name = "double-double";
  using Prepared = Triangle;
  static Prepared prepare(const Triangle& f) { return f; }
  static Answer test(const Prepared& f, const Aim& ray) {
    const Dd3 a = difference(f.a, ray.origin), b = difference(f.b, ray.origin),
              c = difference(f.c, ray.origin);
    const double u = dot(ray.direction, cross(c, b)).hi, v = dot(ray.direction, cross(a, c)).hi,
                 w = dot(ray.direction, cross(b, a)).hi;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return {};
    const Dd3 n = cross(difference(f.b, f.a), difference(f.c, f.a));
    const DoubleDouble slope = dot(ray.direction, n);
    if (slope.hi == 0) return {};
    const DoubleDouble t = dot(n, a) / slope;
    return {t.hi > 0, t.hi, t.lo, 0};
  }
  static Place place(const Prepared& f, const Aim& ray, const Answer& answer) {
    return {along(ray, answer), normalize(cross(difference(f.b, f.a), difference(f.c, f.a)))};
  }
};

}  // namespace lancer::stress::flat
