#include "stress/subjects/facet.hpp"

#include <cmath>
#include <utility>

#include "tracer/build.hpp"

namespace lancer::stress::flat {

FacetNumbers any_facet(Random& random) {
  for (;;) {
    FacetNumbers f;
    f.a = random.in_cube(0.5);
    f.b = random.in_cube(0.5);
    f.c = random.in_cube(0.5);
    if (length(cross(f.b - f.a, f.c - f.a)) > 0.2) return f;
  }
}

Vec3 at(const FacetNumbers& f, double a, double b, double c) { return f.a * a + f.b * b + f.c * c; }
Vec3 inside(const FacetNumbers& f, Random& random) {
  const double a = random.between(0.05, 1), b = random.between(0.05, 1), c = random.between(0.05, 1);
  const double sum = a + b + c;
  return at(f, a / sum, b / sum, c / sum);
}
Vec3 near(const FacetNumbers& f, Random& random) {
  const double a = random.between(-0.3, 1), b = random.between(-0.3, 1);
  return at(f, a, b, 1 - a - b);
}
double size_of(const FacetNumbers& f) {
  return std::fmax(max_abs(f.b - f.a), std::fmax(max_abs(f.c - f.a), max_abs(f.c - f.b)));
}
Vec3 plane_normal(const FacetNumbers& f) { return normalize(cross(f.b - f.a, f.c - f.a)); }

Rim rim(const FacetNumbers& f, int edge, double share) {
  const Vec3 p = edge == 0 ? f.a : edge == 1 ? f.b : f.c, q = edge == 0 ? f.b : edge == 1 ? f.c : f.a;
  return {p + (q - p) * share, normalize(cross(q - p, plane_normal(f)))};
}

Rim any_rim(const FacetNumbers& f, Random& random) {
  const int edge = random.below(3);
  return rim(f, edge, random.unit());
}

Subject subject(const FacetNumbers& f, std::function<Line(Random&)> ray) {
  Subject out;
  tracer::test::add_facet(*out.scene, f.a, f.b, f.c);
  out.ray = std::move(ray);
  return out;
}

}  // namespace lancer::stress::flat
