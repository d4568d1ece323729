// Boxes, along the axes and turned: one box a world, rays at its silhouettes, front edges and corners, in the
// planes of its sides, from inside and from afar.

#include "stress/rows/box.hpp"

#include <fmt/format.h>

#include "stress/rows/rows.hpp"
#include "stress/subjects/box.hpp"

namespace lancer::stress::flat {
namespace {

template <class Ray>
void add_styles(Sets& sets, const std::string& name, Ray ray) {
  for (const Style style : k_styles) {
    sets.push_back(
        {name.empty() ? name_of(style) : fmt::format("{}, {}", name, name_of(style)), [=](Random& random) {
           const PlacedBox box = any_box(style, random);
           return subject(box, [=](Random& r) { return ray(box, r); });
         }});
  }
}

Sets uniform_sets() {
  Sets sets;
  add_styles(sets, "", [](const PlacedBox& box, Random& r) { return past(box, r); });
  return sets;
}

Sets inside_sets() {
  Sets sets;
  add_styles(sets, "", [](const PlacedBox& box, Random& r) {
    const Vec3 origin = box.point(r.in_cube(0.95));
    return Line{origin, r.below(2) == 0 ? r.direction() : normalize(box.vector(r.direction()))};
  });
  return sets;
}

Sets far_sets() {
  Sets sets;
  for (int k = 1; k <= 9; ++k) {
    add_styles(sets, fmt::format("1e{}", k), [k](const PlacedBox& box, Random& r) {
      return towards(box.point(r.in_cube(1.2)), box.largest() * std::pow(10.0, k), r);
    });
  }
  return sets;
}

Sets rim_sets(Where where) {
  Sets sets;
  for (const int k : k_powers) {
    add_styles(sets, fmt::format("1e-{}", k),
               [=](const PlacedBox& box, Random& r) { return at_rim(box, where, ten_to_minus(k), r); });
  }
  return sets;
}
Sets silhouette_sets() { return rim_sets(Where::silhouette); }
Sets edge_sets() { return rim_sets(Where::front_edge); }
Sets corner_sets() { return rim_sets(Where::corner); }

Sets near_sets() {
  Sets sets;
  for (const int k : k_near_powers) {
    add_styles(sets, fmt::format("1e-{}", k), [k](const PlacedBox& box, Random& r) {
      Vec3 q = r.in_cube(0.95);
      const int axis = r.below(3);
      q[axis] = r.sign() * (1 + ten_to_minus(k));
      return Line{box.point(q), r.direction()};
    });
  }
  return sets;
}

/// Makes sets of boxes of a style.
auto placed_as(Style style) {
  return [style](const std::string& name, double scale, double away) {
    return Set{fmt::format("{}, {}", name, name_of(style)), [=](Random& random) {
                 const PlacedBox box = any_box(style, random, scale, away);
                 return subject(box, [box](Random& r) { return common_ray(box, r); });
               }};
  };
}

Sets scaled_sets() {
  Sets sets;
  for (const Style style : k_styles) {
    add_scaled(sets, placed_as(style));
  }
  return sets;
}

Sets moved_sets() {
  Sets sets;
  for (const Style style : k_styles) {
    add_moved(sets, placed_as(style));
  }
  return sets;
}

/// Rays in the plane of a side, on and beside it.
Sets plane_sets() {
  Sets sets;
  sets.push_back({"aligned", [](Random& random) {
                    const PlacedBox box = any_box(Style::aligned, random);
                    return subject(box, [box](Random& r) {
                      const int axis = r.below(3);
                      Vec3 q = r.in_cube(1.3), d = r.direction();
                      q[axis] = r.sign();
                      d[axis] = 0;
                      d = normalize(d);
                      d[axis] = r.below(2) == 0 ? 0.0 : -0.0;
                      Vec3 origin = box.point(q) - d * box.distance(r);
                      origin[axis] = q[axis] > 0 ? box.hi[axis] : box.lo[axis];
                      return Line{origin, d};
                    });
                  }});
  // Turned by 45 degrees in numbers that need no rounding: the side's plane is x - y = 2 half.
  sets.push_back({"turned", [](Random& random) {
                    PlacedBox box;
                    const double half = std::scalbn(1.0, random.below(5) - 2);
                    box.hi = {half, 1, 1};
                    box.lo = -box.hi;
                    box.map.rows = {Vec3{1, 1, 0}, Vec3{-1, 1, 0}, Vec3{0, 0, 1}};
                    return subject(box, [half](Random& r) {
                      Vec3 d = r.direction();
                      d.x = d.y = std::nearbyint(d.x * 0x1p40) * 0x1p-40;
                      d = normalize(d);
                      d.y = d.x;
                      const double y = std::nearbyint(r.between(-8, 8) * 0x1p20) * 0x1p-20;
                      const double x = y + r.sign() * 2 * half;
                      return Line{{x, y, r.between(-1.2, 1.2)}, d};
                    });
                  }});
  return sets;
}

Sets axis_sets() {
  Sets sets;
  for (const double rest : k_next_to_nothing) {
    add_styles(sets, fmt::format("{:.2g}", rest), [rest](const PlacedBox& box, Random& r) {
      const int axis = r.below(3);
      Vec3 d{rest, rest, rest};
      d[axis] = r.sign();
      Vec3 q = r.in_cube(1.2);
      for (const int share : {2, 4}) {
        const int on = r.below(3);
        const double side = r.sign();
        if (r.below(share) == 0) q[on] = side;
      }
      return Line{box.point(q) - d * box.distance(r), d};
    });
  }
  return sets;
}

/// Two or three sides met at exactly the same distance: the ray runs along a diagonal of the axes.
Sets exact_sets() {
  Sets sets;
  for (const bool corner : {false, true}) {
    sets.push_back({corner ? "a corner" : "an edge", [corner](Random& random) {
                      PlacedBox box;
                      box.hi = {1.0 + random.below(4), 1.0 + random.below(4), 1.0 + random.below(4)};
                      box.lo = -box.hi;
                      return subject(box, [=](Random& r) {
                        const int single = r.below(3);
                        const double away = 1 + r.below(8);
                        Vec3 d, origin;
                        for (int axis = 0; axis < 3; ++axis) {
                          const double sign = r.sign();
                          d[axis] = sign;
                          origin[axis] = sign * (-away - box.hi[axis]);
                          if (corner || axis != single) continue;
                          d[axis] = r.between(-0.1, 0.1);
                          origin[axis] = r.between(-0.5, 0.5) - d[axis] * away;
                        }
                        const double size = length(d);
                        return Line{origin, d / size};
                      });
                    }});
  }
  return sets;
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_box_rows(Rows& rows) {
  using namespace flat;
  add_row<BoxContest>(rows, "box.uniform",
                      "from 2 to 10 sizes, at and past it; along the axes, turned, uneven, in groups",
                      uniform_sets);
  add_row<BoxContest>(rows, "box.inside", "from inside", inside_sets);
  add_row<BoxContest>(rows, "box.far", "from 1e1 to 1e9 sizes", far_sets);
  add_row<BoxContest>(rows, "box.silhouettes", "within 1e-3 to 1e-16 of an edge that they graze",
                      silhouette_sets);
  add_row<BoxContest>(rows, "box.edges", "within 1e-3 to 1e-16 of an edge where they enter", edge_sets);
  add_row<BoxContest>(rows, "box.corners", "within 1e-3 to 1e-16 of a corner", corner_sets);
  add_row<BoxContest>(rows, "box.planes", "exactly in the plane of a side", plane_sets);
  add_row<BoxContest>(rows, "box.axes", "along an axis, the other components 0, -0 and denormal", axis_sets);
  add_row<BoxContest>(rows, "box.near", "from 1e-4 to 1e-12 sizes above a side", near_sets);
  add_row<BoxContest>(rows, "box.scaled", "scaled by 1e-9 to 1e9 and 2^+-100", scaled_sets);
  add_row<BoxContest>(rows, "box.moved", "moved by 1e3 to 1e9 sizes", moved_sets);
  add_row<BoxContest>(rows, "box.exact", "edges and corners met at exactly the same distance", exact_sets);
}
