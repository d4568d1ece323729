// Rays exactly through the edges and corners of facets, and exactly in their planes.

#include <cmath>

#include "stress/rows/facet.hpp"
#include "stress/rows/rows.hpp"

namespace lancer::stress::flat {
namespace {

/// Rays that go exactly through: the direction is a multiple of 2^-50 and so is everything in reach of it.
Vec3 short_direction(Random& random) {
  const Vec3 d = random.direction();
  const auto cut = [](double v) { return std::nearbyint(v * 0x1p50) * 0x1p-50; };
  return {cut(d.x), cut(d.y), cut(d.z)};
}
Vec3 short_vector(Random& random) {
  const auto cut = [](double v) { return std::nearbyint(v * 0x1p20) * 0x1p-20; };
  const Vec3 v = random.in_cube(1);
  return {cut(v.x), cut(v.y), cut(v.z)};
}
Vec3 whole_vector(Random& random, int limit) {
  const auto one = [&] { return static_cast<double>(random.below(2 * limit + 1) - limit); };
  const double x = one(), y = one(), z = one();
  return {x, y, z};
}
bool has_area(const FacetNumbers& f) { return max_abs(cross(f.b - f.a, f.c - f.a)) > 1e-3; }

Sets exact_sets() {
  Sets sets;
  sets.push_back({"whole numbers, along an axis", [](Random& random) {
                    FacetNumbers f;
                    do {
                      f.a = whole_vector(random, 8);
                      f.b = f.a + whole_vector(random, 4) * 2;
                      f.c = f.a + whole_vector(random, 4) * 2;
                    } while (!has_area(f));
                    return subject(f, [f](Random& r) {
                      const Vec3 p = r.below(2) == 0 ? f.b : f.c;
                      const Vec3 target = r.below(2) == 0 ? f.a + (p - f.a) * 0.5 : p;
                      Vec3 d;
                      const int axis = r.below(3);
                      d[axis] = r.sign();
                      return Line{target - d * 16, d};
                    });
                  }});
  for (const bool corner : {false, true}) {
    sets.push_back(
        {corner ? "through a corner" : "through an edge", [corner](Random& random) {
           const Vec3 d = short_direction(random), e = short_vector(random);
           FacetNumbers f;
           do {
             f.a = corner ? d * 4 : d * 4 + e;
             f.b = corner ? d * 4 + e : d * 4 - e;
             f.c = short_vector(random) + Vec3{1, 1, 1};
           } while (!has_area(f));
           return subject(f, [d](Random& r) { return Line{d * -std::scalbn(1.0, r.below(7)), d}; });
         }});
  }
  sets.push_back({"in the plane", [](Random& random) {
                    const int axis = random.below(3);
                    const double level = random.between(-1, 1);
                    FacetNumbers f;
                    do {
                      f = any_facet(random);
                      for (Vec3* corner : {&f.a, &f.b, &f.c}) (*corner)[axis] = level;
                    } while (!has_area(f));
                    return subject(f, [=](Random& r) {
                      Vec3 d = r.direction();
                      d[axis] = r.below(2) == 0 ? 0.0 : -0.0;
                      d = normalize(d);
                      const double distance = r.between(2, 10);
                      Vec3 origin = inside(f, r) - d * distance;
                      origin[axis] = level;
                      return Line{origin, d};
                    });
                  }});
  return sets;
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_facet_exact_rows(Rows& rows) {
  using namespace flat;
  add_row<FacetContest>(rows, "facet.exact", "exactly through edges and corners, exactly in its plane",
                        exact_sets);
}
