#include "tracer/shapes/facet.hpp"

#include "tracer/shapes/careful.hpp"
#include "tracer/shapes/linear_form.hpp"
#include "tracer/shapes/newton.hpp"

namespace lancer::tracer {
namespace {

/// A corner as seen from the ray's start, sheared so that the ray runs along +z; `size` bounds its
/// coordinates before and after.
struct Sheared {
  double x, y;
  double size;
};

Sheared shear(Vec3 corner, const Probe& probe) {
  const Vec3 v = corner - probe.origin;
  const double z = v[probe.kz];
  return {v[probe.kx] - probe.shear_x * z, v[probe.ky] - probe.shear_y * z, sum_abs(v)};
}

/// Far more than what the products of coordinates may lose by underflow.
constexpr double k_underflow = 0x1p-1000;

/// Is the ray on the same side of the three edges, each off by `doubt` at most? No: by more than `rim`, too.
Answer same_side(double u, double v, double w, double doubt, double rim = 0) {
  const double least = std::min(u, std::min(v, w)), most = std::max(u, std::max(v, w));
  if (least < -doubt - rim && most > doubt + rim) return Answer::no;
  return least > doubt || most < -doubt ? Answer::yes : Answer::unknown;
}

struct Verdict {
  Answer hits = Answer::unknown;
  double determinant = 0;  // its sign: > 0 where the ray meets the front
};

Verdict quick_test(const FacetPrimitive& f, const Probe& probe) {
  const Sheared a = shear(f.a, probe), b = shear(f.b, probe), c = shear(f.c, probe);
  const double u = c.x * b.y - c.y * b.x;
  const double v = a.x * c.y - a.y * c.x;
  const double w = b.x * a.y - b.y * a.x;
  // Each sheared coordinate is off by 5 u size at most, and no larger than 2 size.
  const double spread =
      std::fabs(a.x) + std::fabs(a.y) + std::fabs(b.x) + std::fabs(b.y) + std::fabs(c.x) + std::fabs(c.y);
  const double off = 5 * k_u * std::max(a.size, std::max(b.size, c.size));
  // Where the edge functions overflow, spread^2 does, too.
  const double doubt = off * spread + 2 * k_u * (spread * spread) + 2 * off * off + k_underflow;
  return {same_side(u, v, w, doubt, 4 * f.slack * spread), u + v + w};
}

DoubleDouble dot(const Triple2& a, Vec3 b) { return a[0] * b.x + a[1] * b.y + a[2] * b.z; }
Triple2 cross(const Triple2& a, const Triple2& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The same in twice the precision, by triple products.
[[gnu::noinline, gnu::cold]] Verdict long_test(const FacetPrimitive& f, const Probe& probe) {
  const Triple2 a = exact_difference(f.a, probe.origin), b = exact_difference(f.b, probe.origin),
                c = exact_difference(f.c, probe.origin);
  const double size = std::max(sum_abs(rounded(a)), std::max(sum_abs(rounded(b)), sum_abs(rounded(c))));
  if (!(size > 0x1p-400 && size < 0x1p400)) return {};  // Products in twice the precision want room.
  const double u = -dot(cross(b, c), probe.direction).hi;
  const double v = -dot(cross(c, a), probe.direction).hi;
  const double w = -dot(cross(a, b), probe.direction).hi;
  return {same_side(u, v, w, 256 * k_u * k_u * size * size), u + v + w};
}

/// How far the plane may be off where the ray starts, and its slope, for the rounding of the corners.
double depth_slack(const FacetPrimitive& f, Vec3 origin) {
  return 2 * (f.slack + 3 * k_u * sum_abs(origin - f.a));
}
constexpr double k_slope_slack = 6 * k_u;

/// Where the ray meets the facet's plane, in plain arithmetic.
Root plane_crossing(const FacetPrimitive& f, const Probe& probe, bool entering) {
  const Vec3 n = f.normal, w = f.a - probe.origin;
  const double depth = lancer::dot(n, w), slope = lancer::dot(n, probe.direction);
  return crossing({depth, 8 * k_u * sum_abs(w) + depth_slack(f, probe.origin)},
                  {slope, 8 * k_u + k_slope_slack}, entering);
}

void set_slack(const FacetPrimitive& f, Vec3 origin, Vec3 direction, Landing& landing) {
  set_bounds(depth_slack(f, origin), lancer::dot(f.normal, direction), k_slope_slack, landing);
}

[[gnu::noinline, gnu::cold]] Landings careful_landings(const FacetPrimitive& f, Vec3 origin, Vec3 direction,
                                                       Detail detail) {
  Landings found = careful(f, origin, direction, detail);
  set_slack(f, origin, direction, found.at[0]);
  return found;
}

}  // namespace

Roots roots(const FacetPrimitive& facet, const Probe& probe) {
  Verdict verdict = quick_test(facet, probe);
  if (verdict.hits == Answer::no) return {};
  if (verdict.hits == Answer::unknown) verdict = long_test(facet, probe);
  const bool entering = (verdict.determinant > 0) != facet.flipped;
  const Root root = plane_crossing(facet, probe, entering);
  if (verdict.hits == Answer::no) return {0, {root, {}}, std::isfinite(root.t)};
  if (verdict.hits == Answer::yes && std::fabs(root.t) > root.error) return {1, {root, {}}};
  const Landings exactly = careful_landings(facet, probe.origin, probe.direction, Detail::distances);
  if (exactly.count == 0) return {0, {root, {}}, std::isfinite(root.t)};
  Roots found = exactly.roots();
  found.root[0].rim = verdict.hits == Answer::unknown;
  return found;
}

bool touches(const FacetPrimitive& f, Vec3 p, double tolerance) {
  const Vec3 corner[3] = {f.a, f.b, f.c};
  const Vec3 n = f.flipped ? -f.normal : f.normal;
  if (std::fabs(lancer::dot(n, p - f.a)) > tolerance + 4 * k_u * sum_abs(p - f.a)) return false;
  for (int i = 0; i < 3; ++i) {
    const Vec3 edge = corner[(i + 1) % 3] - corner[i], offset = p - corner[i];
    const double inwards = lancer::dot(lancer::cross(n, edge), offset);
    if (inwards < -(tolerance + 4 * k_u * sum_abs(offset)) * length(edge)) return false;
  }
  return true;
}

Landing land(const FacetPrimitive& facet, Vec3 origin, Vec3 direction, const Root& root) {
  Landing landing{root, 0, 0, {}, facet.normal};
  const Planar plane{facet.normal, 0, facet.a};
  if (land_quickly(facet, origin, direction, landing)) {
    snap(plane, landing.point);
    set_slack(facet, origin, direction, landing);
    return landing;
  }
  if (take(careful_landings(facet, origin, direction, Detail::places), root.entering, landing)) {
    snap(plane, landing.point);
    return landing;
  }
  landing.root = root;
  set_slack(facet, origin, direction, landing);
  landing.point = project(facet, origin + direction * root.t);
  return landing;
}

Vec3 normal_of_corners(const FacetPrimitive& facet) {
  const Triple2 e1 = near_one(exact_difference(facet.b, facet.a));
  const Triple2 e2 = near_one(exact_difference(facet.c, facet.a));
  const Triple2 n = cross(e1, e2);
  const bool certain = max_abs(rounded(n)) > 0x1p-90;
  if (!certain && !careful_has_area(facet)) return {};
  const Vec3 outward = unit(n);
  return facet.flipped ? -outward : outward;
}

Vec3 project(const FacetPrimitive& facet, Vec3 p) {
  return p + facet.normal * lancer::dot(facet.normal, facet.a - p);
}

Barycentric barycentric(const FacetPrimitive& facet, Vec3 p) {
  const Vec3 n = lancer::cross(facet.b - facet.a, facet.c - facet.a);
  const Vec3 size = abs(n);
  const int drop = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int i = (drop + 1) % 3, j = (drop + 2) % 3;
  const Vec3 a = facet.a - p, b = facet.b - p, c = facet.c - p;
  const double sign = n[drop] < 0 ? -1 : 1;
  const double u = std::max(0.0, sign * difference_of_products(b[i], c[j], b[j], c[i]));
  const double v = std::max(0.0, sign * difference_of_products(c[i], a[j], c[j], a[i]));
  const double w = std::max(0.0, sign * difference_of_products(a[i], b[j], a[j], b[i]));
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

}  // namespace lancer::tracer
