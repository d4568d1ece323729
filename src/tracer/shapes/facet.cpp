#include "tracer/shapes/facet.hpp"

#include "base/math.hpp"
#include "tracer/shapes/linear_form.hpp"

namespace lancer::tracer {
namespace {

/// A corner as seen from the ray's start, sheared so that the ray runs along +z.
struct Sheared {
  double x, y;
};

Sheared shear(Vec3 corner, const Probe& probe) {
  const Vec3 v = corner - probe.origin;
  const double z = v[probe.kz];
  return {v[probe.kx] - probe.shear_x * z, v[probe.ky] - probe.shear_y * z};
}

/// Whether the plain difference of two products has the sign of the exact one.
bool certain(double difference, double a, double b) {
  return std::fabs(difference) > 4 * k_u * (std::fabs(a) + std::fabs(b));
}

struct Edges {
  double u = 0, v = 0, w = 0;
  bool outside(bool certain_u, bool certain_v, bool certain_w) const {
    const bool negative = (certain_u && u < 0) || (certain_v && v < 0) || (certain_w && w < 0);
    const bool positive = (certain_u && u > 0) || (certain_v && v > 0) || (certain_w && w > 0);
    return negative && positive;
  }
};

/// Most facets are missed for certain in plain arithmetic, which spares them three exact products.
bool surely_missed(const Sheared& a, const Sheared& b, const Sheared& c) {
  const double u1 = c.x * b.y, u2 = c.y * b.x;
  const double v1 = a.x * c.y, v2 = a.y * c.x;
  const double w1 = b.x * a.y, w2 = b.y * a.x;
  const Edges plain{u1 - u2, v1 - v2, w1 - w2};
  return plain.outside(certain(plain.u, u1, u2), certain(plain.v, v1, v2), certain(plain.w, w1, w2));
}

/// Where the ray meets the facet's plane, from the corner nearest to its start. The normal is off by 2 ulp at
/// most, which the distance from that corner multiplies.
Root plane_crossing(const FacetPrimitive& f, const Probe& probe) {
  const Vec3 n = accurate_cross(f.b - f.a, f.c - f.a);
  Vec3 nearest = f.a;
  for (const Vec3 corner : {f.b, f.c}) {
    if (sum_abs(corner - probe.origin) < sum_abs(nearest - probe.origin)) nearest = corner;
  }
  const double size = sum_abs(n);
  Bounded depth = bounded_depth(0, n, probe.origin, nearest);
  depth.error += size * (f.slack + 3 * k_u * sum_abs(probe.origin - nearest));
  return crossing(depth, bounded_dot(n, probe.direction), size * 3 * k_u, true);
}

}  // namespace

Roots roots(const FacetPrimitive& facet, const Probe& probe) {
  const Sheared a = shear(facet.a, probe), b = shear(facet.b, probe), c = shear(facet.c, probe);
  if (surely_missed(a, b, c)) return {};
  const Edges e{difference_of_products(c.x, b.y, c.y, b.x), difference_of_products(a.x, c.y, a.y, c.x),
                difference_of_products(b.x, a.y, b.y, a.x)};
  if (e.outside(true, true, true)) return {};
  const double determinant = e.u + e.v + e.w;
  if (determinant == 0) return {};
  Root root = plane_crossing(facet, probe);
  if (!std::isfinite(root.t)) return {};
  root.entering = (determinant > 0) != facet.flipped;
  return {1, {root, {}}};
}

Vec3 normal(const FacetPrimitive& facet) {
  const Vec3 n = normalize(accurate_cross(facet.b - facet.a, facet.c - facet.a));
  return facet.flipped ? -n : n;
}

Vec3 project(const FacetPrimitive& facet, Vec3 p) {
  const Vec3 n = normal(facet);
  return p + n * dot(n, facet.a - p);
}

Barycentric barycentric(const FacetPrimitive& facet, Vec3 p) {
  const Vec3 n = cross(facet.b - facet.a, facet.c - facet.a);
  const Vec3 size = abs(n);
  const int drop = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int i = (drop + 1) % 3, j = (drop + 2) % 3;
  const Vec3 a = facet.a - p, b = facet.b - p, c = facet.c - p;
  const double sign = n[drop] < 0 ? -1 : 1;
  const double u = std::fmax(0, sign * difference_of_products(b[i], c[j], b[j], c[i]));
  const double v = std::fmax(0, sign * difference_of_products(c[i], a[j], c[j], a[i]));
  const double w = std::fmax(0, sign * difference_of_products(a[i], b[j], a[j], b[i]));
  const double sum = u + v + w;
  if (!(sum > 0)) return {1, 0, 0};
  return {u / sum, v / sum, w / sum};
}

Aabb bounds(const FacetPrimitive& facet) {
  Aabb box;
  box.add(facet.a);
  box.add(facet.b);
  box.add(facet.c);
  return box.padded(facet.slack);
}

double winding(const FacetPrimitive& facet, Vec3 p) {
  const auto unit = [p](Vec3 corner) { return normalize(corner - p); };
  const Vec3 a = unit(facet.a), b = unit(facet.b), c = unit(facet.c);
  const double numerator = dot(a, cross(b, c));
  const double denominator = 1 + dot(a, b) + dot(b, c) + dot(c, a);
  const double turns = math::atan2_deg(numerator, denominator) / 360;
  return facet.flipped ? -turns : turns;
}

}  // namespace lancer::tracer
