// Facets: one facet a world, rays at its edges, corners and plane.

#include "stress/rows/facet.hpp"

#include <fmt/format.h>

#include "stress/rows/rows.hpp"
#include "tracer/build.hpp"

namespace lancer::stress::flat {
namespace {

/// +-10^-k, k from 0 to 16.
double signed_power(Random& random) {
  const double sign = random.sign();
  return sign * ten_to_minus(random.below(17));
}

/// A mixture that every placement of a facet is tried with.
Line common_ray(const FacetNumbers& f, Random& random) {
  const double size = size_of(f), distance = size * random.between(2, 10);
  const int what = random.below(4);
  if (what == 0) return towards(near(f, random), distance, random);
  if (what == 1) return towards(inside(f, random), distance, random);
  if (what == 2) {
    const Rim r = any_rim(f, random);
    const double offset = size * signed_power(random);
    return towards(r.point + r.away * offset, distance, random);
  }
  const Vec3 along = normalize(f.b - f.a);
  const Vec3 target = inside(f, random);
  const Vec3 d = normalize(along + plane_normal(f) * signed_power(random));
  return {target - d * distance, d};
}

Set placed(std::string name, double scale, double away) {
  return {std::move(name), [scale, away](Random& random) {
            FacetNumbers f = any_facet(random);
            const Vec3 offset = random.direction() * away;
            for (Vec3* corner : {&f.a, &f.b, &f.c}) *corner = (*corner + offset) * scale;
            return subject(f, [f](Random& r) { return common_ray(f, r); });
          }};
}

Sets uniform_sets() {
  return {{"2..10", [](Random& random) {
             const FacetNumbers f = any_facet(random);
             return subject(f, [f](Random& r) { return towards(near(f, r), r); });
           }}};
}

Sets far_sets() {
  Sets sets;
  for (int k = 1; k <= 9; ++k) {
    sets.push_back({fmt::format("1e{}", k), [k](Random& random) {
                      const FacetNumbers f = any_facet(random);
                      const double distance = std::pow(10.0, k);
                      return subject(f, [=](Random& r) { return towards(near(f, r), distance, r); });
                    }});
  }
  return sets;
}

Sets grazing_sets() {
  Sets sets;
  for (const int k : k_powers) {
    sets.push_back({fmt::format("1e-{}", k), [k](Random& random) {
                      const FacetNumbers f = any_facet(random);
                      return subject(f, [=](Random& r) {
                        const Vec3 n = plane_normal(f) * (r.sign() * ten_to_minus(k));
                        const Vec3 d = normalize(r.across(plane_normal(f)) + n);
                        const Vec3 target = inside(f, r);
                        return Line{target - d * r.between(2, 10), d};
                      });
                    }});
  }
  return sets;
}

Sets rim_sets(bool corners) {
  Sets sets;
  for (const int k : k_powers) {
    for (const double side : {1.0, -1.0}) {
      sets.push_back({fmt::format("1e-{} {}", k, side > 0 ? "outside" : "inside"), [=](Random& random) {
                        const FacetNumbers f = any_facet(random);
                        return subject(f, [=](Random& r) {
                          const Rim near_to = corners ? rim(f, r.below(3), 0) : any_rim(f, r);
                          // At a corner, away from the facet's middle.
                          const Vec3 away = corners
                                                ? normalize(near_to.point - at(f, 1 / 3.0, 1 / 3.0, 1 / 3.0))
                                                : near_to.away;
                          const Vec3 target = near_to.point + away * (side * ten_to_minus(k));
                          return towards(target, r);
                        });
                      }});
    }
  }
  return sets;
}

Sets needle_sets() {
  Sets sets;
  for (int k = 3; k <= 9; ++k) {
    sets.push_back({fmt::format("1 : 1e{}", k), [k](Random& random) {
                      FacetNumbers f;
                      f.a = random.in_cube(0.5);
                      const Vec3 along = random.direction();
                      f.b = f.a + along;
                      const double share = random.unit();
                      f.c = f.a + along * share + random.across(along) * ten_to_minus(k);
                      return subject(f, [f](Random& r) {
                        const double distance = r.between(2, 10);
                        if (r.below(2) == 0) return towards(near(f, r), distance, r);
                        return towards(inside(f, r), distance, r);
                      });
                    }});
  }
  return sets;
}

Sets scaled_sets() {
  Sets sets;
  add_scaled(sets, placed);
  return sets;
}

Sets moved_sets() {
  Sets sets;
  add_moved(sets, placed);
  return sets;
}

/// In groups in groups, each turned, scaled and moved, half of them mirrored.
Sets group_sets() {
  Sets sets;
  for (const bool mirrored : {false, true}) {
    sets.push_back({mirrored ? "mirrored" : "not mirrored", [mirrored](Random& random) {
                      const FacetNumbers own = any_facet(random);
                      Affine map = scaling({mirrored ? -1.0 : 1.0, 1, 1});
                      for (int level = 0; level < 3; ++level) {
                        map = then(map, scaling({random.between(0.5, 2), random.between(0.5, 2), 1}));
                        const double angle = random.between(-180, 180);
                        map = then(map, rotation(random.direction(), angle));
                        map = then(map, translation(random.in_cube(2)));
                      }
                      Subject out;
                      tracer::test::add_facet(*out.scene, own.a, own.b, own.c, {}, map);
                      FacetNumbers f;
                      f.a = map.point(own.a);
                      f.b = map.point(own.b);
                      f.c = map.point(own.c);
                      out.ray = [f](Random& r) { return common_ray(f, r); };
                      return out;
                    }});
  }
  return sets;
}

Sets near_sets() {
  Sets sets;
  for (const int k : k_near_powers) {
    sets.push_back({fmt::format("1e-{}", k), [k](Random& random) {
                      const FacetNumbers f = any_facet(random);
                      return subject(f, [=](Random& r) {
                        const Vec3 n = plane_normal(f) * r.sign();
                        const Vec3 origin = inside(f, r) + n * ten_to_minus(k);
                        return Line{origin, r.direction()};
                      });
                    }});
  }
  return sets;
}

Sets axis_sets() {
  Sets sets;
  for (const double rest : k_next_to_nothing) {
    sets.push_back({fmt::format("{:.2g}", rest), [rest](Random& random) {
                      const FacetNumbers f = any_facet(random);
                      return subject(f, [=](Random& r) {
                        const int axis = r.below(3);
                        Vec3 d{rest, rest, rest};
                        d[axis] = r.sign();
                        const Rim edge = any_rim(f, r);
                        // A half of the targets are corners and edge points, as exact as they come.
                        const Vec3 target = r.below(2) == 0 ? near(f, r) : edge.point;
                        return Line{target - d * 4, d};
                      });
                    }});
  }
  return sets;
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_facet_rows(Rows& rows) {
  using namespace flat;
  add_row<FacetContest>(rows, "facet.uniform", "from 2 to 10 sizes, on and around it", uniform_sets);
  add_row<FacetContest>(rows, "facet.far", "from 1e1 to 1e9 sizes", far_sets);
  add_row<FacetContest>(rows, "facet.grazing", "nearly in its plane: n . d from 1e-3 to 1e-16", grazing_sets);
  add_row<FacetContest>(rows, "facet.edges", "within 1e-3 to 1e-16 of an edge, on both sides",
                        [] { return rim_sets(false); });
  add_row<FacetContest>(rows, "facet.corners", "within 1e-3 to 1e-16 of a corner, on both sides",
                        [] { return rim_sets(true); });
  add_row<FacetContest>(rows, "facet.needles", "facets of aspect 1e3 to 1e9", needle_sets);
  add_row<FacetContest>(rows, "facet.scaled", "scaled by 1e-9 to 1e9 and 2^+-100", scaled_sets);
  add_row<FacetContest>(rows, "facet.moved", "moved by 1e3 to 1e9 sizes", moved_sets);
  add_row<FacetContest>(rows, "facet.groups", "in groups in groups, mirrored or not", group_sets);
  add_row<FacetContest>(rows, "facet.near", "from 1e-4 to 1e-12 sizes above it", near_sets);
  add_row<FacetContest>(rows, "facet.axes", "along an axis, the other components 0, -0 and denormal",
                        axis_sets);
}
