#include "stress/truth/facet.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "stress/truth/exact_sign.hpp"

namespace lancer::stress::flat {
namespace {

/// The sign of d . (p x q), of offsets p and q from the origin.
int side_of_edge(Vec3 origin, Vec3 d, Vec3 p, Vec3 q) {
  return exact_sign([&]<class Number>(Number) {
    const Triple<Number> o = as<Number>(origin);
    return dot(as<Number>(d), cross(as<Number>(p) - o, as<Number>(q) - o));
  });
}

template <class Number>
Triple<Number> plain_normal(const FacetNumbers& f) {
  const Triple<Number> a = as<Number>(f.a);
  return cross(as<Number>(f.b) - a, as<Number>(f.c) - a);
}

int slope_sign(const FacetNumbers& f, Vec3 d) {
  return exact_sign([&]<class Number>(Number) { return dot(plain_normal<Number>(f), as<Number>(d)); });
}

int depth_sign(const FacetNumbers& f, Vec3 o) {
  return exact_sign(
      [&]<class Number>(Number) { return dot(plain_normal<Number>(f), as<Number>(f.a) - as<Number>(o)); });
}

/// What a value may be: less than 0, more, or either.
struct Doubtful {
  double value = 0, doubt = 0;
  bool negative() const { return value < -doubt; }
  bool positive() const { return value > doubt; }
};

/// sum |v_i| by_i.
double spread(const Real3& v, Vec3 by) {
  const Vec3 d = to_vec3(v);
  return std::fabs(d.x) * by.x + std::fabs(d.y) * by.y + std::fabs(d.z) * by.z;
}

Doubtful doubtful_edge(Vec3 origin, Vec3 direction, Vec3 p, Vec3 q) {
  const Real3 o = real(origin), d = real(direction), from_p = real(p) - o, from_q = real(q) - o;
  const Vec3 at_p = four_ulp(p) + four_ulp(origin), at_q = four_ulp(q) + four_ulp(origin);
  const Real3 across = cross(from_p, from_q);
  return {to_double(dot(d, across)), spread(across, four_ulp(direction)) + spread(cross(from_q, d), at_p) +
                                         spread(cross(d, from_p), at_q)};
}

/// n . v, where v is off by `by`.
Doubtful doubtful_dot(const FacetNumbers& f, const Real3& v, Vec3 by) {
  const Real3 e1 = real(f.b) - real(f.a), e2 = real(f.c) - real(f.a), n = cross(e1, e2);
  const Vec3 by1 = four_ulp(f.b) + four_ulp(f.a), by2 = four_ulp(f.c) + four_ulp(f.a);
  return {to_double(dot(n, v)), spread(n, by) + spread(cross(e2, v), by1) + spread(cross(v, e1), by2)};
}

}  // namespace

Vec3 four_ulp(Vec3 v) {
  Vec3 out;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = std::fabs(v[axis]);
    out[axis] = 4 * (std::nextafter(size, std::numeric_limits<double>::infinity()) - size);
  }
  return out;
}

bool facet_crossed(const FacetNumbers& f, Vec3 origin, Vec3 direction) {
  const int u = side_of_edge(origin, direction, f.c, f.b);
  const int v = side_of_edge(origin, direction, f.a, f.c);
  if (u * v < 0) return false;
  const int w = side_of_edge(origin, direction, f.b, f.a);
  const bool negative = u < 0 || v < 0 || w<0, positive = u> 0 || v > 0 || w > 0;
  return negative != positive;  // all 0: the ray lies in the plane
}

Truth facet_truth(const FacetNumbers& f, Vec3 origin, Vec3 direction) {
  Truth truth;
  if (!facet_crossed(f, origin, direction)) return truth;
  const int slope = slope_sign(f, direction);
  if (slope * depth_sign(f, origin) <= 0) return truth;
  Real3 n = plain_normal<Real>(f);
  truth.hit = true;
  truth.t = dot(n, real(f.a) - real(origin)) / dot(n, real(direction));
  truth.point = real(origin) + real(direction) * truth.t;
  truth.normal = normalized(f.flipped ? n * Real(-1) : n);
  truth.entering = (slope < 0) != f.flipped;
  return truth;
}

bool facet_in_band(const FacetNumbers& f, Vec3 origin, Vec3 direction) {
  const std::array<Doubtful, 3> edges{doubtful_edge(origin, direction, f.c, f.b),
                                      doubtful_edge(origin, direction, f.a, f.c),
                                      doubtful_edge(origin, direction, f.b, f.a)};
  bool negative = false, positive = false, doubt = false;
  for (const Doubtful& edge : edges) {
    negative = negative || edge.negative();
    positive = positive || edge.positive();
    doubt = doubt || !(edge.negative() || edge.positive());
  }
  if (negative && positive) return false;
  const Doubtful slope = doubtful_dot(f, real(direction), four_ulp(direction));
  const Doubtful depth = doubtful_dot(f, real(f.a) - real(origin), four_ulp(f.a) + four_ulp(origin));
  const auto known = [](const Doubtful& d) { return d.negative() || d.positive(); };
  if (known(slope) && known(depth) && slope.positive() != depth.positive()) return false;
  return doubt || !known(slope) || !known(depth);
}

}  // namespace lancer::stress::flat
