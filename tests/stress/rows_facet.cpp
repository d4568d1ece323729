// Facets: one facet a world, rays at its edges, corners and plane.

#include <fmt/format.h>

#include "stress/contest.hpp"
#include "stress/methods_facet.hpp"
#include "tracer/build.hpp"

namespace lancer::stress::flat {
namespace {

struct FacetKind {
  using Numbers = FacetNumbers;
  static FacetNumbers numbers(const tracer::World& world) {
    const tracer::FacetPrimitive& f = world.facets.at(0);
    return {f.a, f.b, f.c, f.flipped};
  }
  static Triangle plain(const FacetNumbers& f) {
    return f.flipped ? Triangle{f.a, f.c, f.b} : Triangle{f.a, f.b, f.c};
  }
  static Truth truth(const FacetNumbers& f, Vec3 o, Vec3 d) { return facet_truth(f, o, d); }
  static bool in_band(const FacetNumbers& f, Vec3 o, Vec3 d) { return facet_in_band(f, o, d); }
  static int face(const tracer::Root&) { return 0; }
  static std::string tell(const FacetNumbers& f) {
    return fmt::format("facet {} {} {}{}", exactly(f.a), exactly(f.b), exactly(f.c),
                       f.flipped ? " flipped" : "");
  }
};

using FacetContest = Contest<FacetKind, NaiveFacet, MollerTrumbore, BaldwinWeber, Plucker, Woop<false>,
                             Woop<true>, DoubleDoubleFacet>;

constexpr int k_powers[] = {3, 6, 8, 10, 12, 14, 15, 16};
double ten_to_minus(int k) { return 1 / std::pow(10.0, k); }

Vec3 at(const FacetNumbers& f, double a, double b, double c) { return f.a * a + f.b * b + f.c * c; }
Vec3 inside(const FacetNumbers& f, Random& random) {
  const double a = random.between(0.05, 1), b = random.between(0.05, 1), c = random.between(0.05, 1);
  const double sum = a + b + c;
  return at(f, a / sum, b / sum, c / sum);
}
/// Anywhere near the facet, on it in about half of the cases.
Vec3 near(const FacetNumbers& f, Random& random) {
  const double a = random.between(-0.3, 1), b = random.between(-0.3, 1);
  return at(f, a, b, 1 - a - b);
}
double size_of(const FacetNumbers& f) {
  return std::fmax(max_abs(f.b - f.a), std::fmax(max_abs(f.c - f.a), max_abs(f.c - f.b)));
}
Vec3 plane_normal(const FacetNumbers& f) { return normalize(cross(f.b - f.a, f.c - f.a)); }

/// About one unit across, neither thin nor small.
FacetNumbers any_facet(Random& random) {
  for (;;) {
    FacetNumbers f;
    f.a = random.in_cube(0.5);
    f.b = random.in_cube(0.5);
    f.c = random.in_cube(0.5);
    if (length(cross(f.b - f.a, f.c - f.a)) > 0.2) return f;
  }
}

Subject subject(const FacetNumbers& f, std::function<Line(Random&)> ray) {
  Subject out;
  tracer::test::add_facet(*out.scene, f.a, f.b, f.c);
  out.ray = std::move(ray);
  return out;
}

/// From `distance` away, out of any direction.
Line towards(Vec3 target, double distance, Random& random) {
  const Vec3 origin = target + random.direction() * distance;
  return {origin, normalize(target - origin)};
}

/// From 2 to 10 away.
Line towards(Vec3 target, Random& random) {
  const double distance = random.between(2, 10);
  return towards(target, distance, random);
}

/// The point of an edge, corner 0 to 2, and the direction in the facet's plane away from the facet.
struct Rim {
  Vec3 point, away;
};
Rim rim(const FacetNumbers& f, int edge, double share) {
  const Vec3 p = edge == 0 ? f.a : edge == 1 ? f.b : f.c, q = edge == 0 ? f.b : edge == 1 ? f.c : f.a;
  return {p + (q - p) * share, normalize(cross(q - p, plane_normal(f)))};
}

Rim any_rim(const FacetNumbers& f, Random& random) {
  const int edge = random.below(3);
  return rim(f, edge, random.unit());
}

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
  for (const int k : {-9, -6, -3, 3, 6, 9})
    sets.push_back(placed(fmt::format("1e{}", k), std::pow(10.0, k), 0));
  for (const int k : {-100, 100}) sets.push_back(placed(fmt::format("2^{}", k), std::scalbn(1.0, k), 0));
  return sets;
}

Sets moved_sets() {
  Sets sets;
  for (int k = 3; k <= 9; ++k) sets.push_back(placed(fmt::format("1e{}", k), 1, std::pow(10.0, k)));
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
  for (const int k : {4, 6, 8, 10, 12}) {
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
  for (const double rest : {0.0, -0.0, 0x1p-1074, -0x1p-1074, 0x1p-1040, -1e-300}) {
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

void add(Rows& rows, const std::string& name, const std::string& about, Sets (*sets)()) {
  rows.push_back({name, about, [name, sets](const Settings& settings) {
                    return FacetContest(settings, name).run(sets());
                  }});
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_facet_rows(Rows& rows) {
  using namespace flat;
  add(rows, "facet.uniform", "from 2 to 10 sizes, on and around it", uniform_sets);
  add(rows, "facet.far", "from 1e1 to 1e9 sizes", far_sets);
  add(rows, "facet.grazing", "nearly in its plane: n . d from 1e-3 to 1e-16", grazing_sets);
  add(rows, "facet.edges", "within 1e-3 to 1e-16 of an edge, on both sides", [] { return rim_sets(false); });
  add(rows, "facet.corners", "within 1e-3 to 1e-16 of a corner, on both sides",
      [] { return rim_sets(true); });
  add(rows, "facet.needles", "facets of aspect 1e3 to 1e9", needle_sets);
  add(rows, "facet.scaled", "scaled by 1e-9 to 1e9 and 2^+-100", scaled_sets);
  add(rows, "facet.moved", "moved by 1e3 to 1e9 sizes", moved_sets);
  add(rows, "facet.groups", "in groups in groups, mirrored or not", group_sets);
  add(rows, "facet.near", "from 1e-4 to 1e-12 sizes above it", near_sets);
  add(rows, "facet.axes", "along an axis, the other components 0, -0 and denormal", axis_sets);
  add(rows, "facet.exact", "exactly through edges and corners, exactly in its plane", exact_sets);
}
