#include "stress/rows/round.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>
#include <utility>

#include "stress/subjects/axis.hpp"

namespace lancer::stress {
namespace {

using MakeShot = std::function<Shot(Random&, const Placed&, const tracer::World&)>;

/// In the space of the unit ball.
struct Flight {
  Vec3 start, toward;
};

Shot shot_of(const Placed& placed, const Flight& flight) {
  Shot shot;
  shot.ray.origin = placed.to_world.point(flight.start);
  shot.ray.direction = normalize(placed.to_world.vector(flight.toward));
  return shot;
}

/// Somewhere between `from` and `to` sizes from the centre.
Vec3 start_at(Random& random, const Placed& placed, double from, double to) {
  const Vec3 direction = random.direction();
  return placed.to_ball.vector(direction * (placed.size * random.over_scales(from, to)));
}

/// Comes as near to the centre as `distance` and no nearer.
Flight passing(Random& random, Vec3 start, double distance) {
  const double length_of_start = length(start);
  const Vec3 back = start / length_of_start;
  const double sine = distance / length_of_start;
  const Vec3 aside = random.across(back);
  const Vec3 nearest = (aside * std::sqrt(1 - sine * sine) + back * sine) * distance;
  return {start, nearest - start};
}

Flight uniform(Random& random, Vec3 start) { return passing(random, start, 1.5 * std::sqrt(random.unit())); }

Flight grazing(Random& random, Vec3 start) {
  const double gap = random.over_scales(1e-16, 0.1);
  return passing(random, start, 1 + random.sign() * gap);
}

Flight inside(Random& random) {
  const Vec3 start = random.in_ball();
  return {start, random.direction()};
}

Flight above(Random& random, double height) {
  const Vec3 start = random.direction() * (1 + height);
  return {start, random.direction()};
}

/// A bit of everything.
Shot any_shot(Random& random, const Placed& placed, double from, double to) {
  const Vec3 start = start_at(random, placed, from, to);
  switch (random.below(8)) {
    case 0: return shot_of(placed, inside(random));
    case 1: return shot_of(placed, above(random, random.signed_over_scales(1e-12, 1e-3)));
    case 2:
    case 3:
    case 4: return shot_of(placed, grazing(random, start));
    default: return shot_of(placed, uniform(random, start));
  }
}

RaySet ray_set(std::string name, const RoundKind& kind, const Placing& placing, MakeShot make_shot) {
  const auto make = [kind, placing, make_shot = std::move(make_shot)](Random& random, int shots) {
    Batch batch;
    batch.scene = std::make_unique<scene::Scene>();
    const Placed placed = kind.add(random, *batch.scene, placing);
    batch.world = tracer::prepare(*batch.scene);
    for (int i = 0; i < shots; ++i) batch.shots.push_back(make_shot(random, placed, batch.world));
    return batch;
  };
  return {std::move(name), make};
}

MakeShot any_between(double from, double to) {
  return [from, to](Random& random, const Placed& placed, const tracer::World&) {
    return any_shot(random, placed, from, to);
  };
}

std::vector<RaySet> uniform_sets(const RoundKind& kind) {
  return {ray_set("2 to 10 sizes", kind, {0.25, 4, 0, false},
                  [](Random& random, const Placed& placed, const tracer::World&) {
                    return shot_of(placed, uniform(random, start_at(random, placed, 2, 10)));
                  })};
}

std::vector<RaySet> inside_sets(const RoundKind& kind) {
  return {ray_set("inside", kind, {0.25, 4, 0, false},
                  [](Random& random, const Placed& placed, const tracer::World&) {
                    return shot_of(placed, inside(random));
                  })};
}

std::vector<RaySet> grazing_sets(const RoundKind& kind) {
  std::vector<RaySet> sets;
  for (const double gap : {1e-3, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-15, 1e-16}) {
    for (const double side : {1.0, -1.0}) {
      sets.push_back(ray_set(fmt::format("{:.0e} {}", gap, side > 0 ? "outside" : "inside"), kind,
                             {0.25, 4, 0, false},
                             [=](Random& random, const Placed& placed, const tracer::World&) {
                               const Vec3 start = start_at(random, placed, 2, 10);
                               return shot_of(placed, passing(random, start, 1 + side * gap));
                             }));
    }
  }
  return sets;
}

std::vector<RaySet> far_sets(const RoundKind& kind) {
  std::vector<RaySet> sets;
  for (const double distance : {1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9}) {
    sets.push_back(ray_set(fmt::format("{:.0e} sizes", distance), kind, {0.25, 4, 0, false},
                           any_between(distance, 2 * distance)));
  }
  return sets;
}

std::vector<RaySet> scaled_sets(const RoundKind& kind) {
  std::vector<RaySet> sets;
  for (const double size : {1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9}) {
    sets.push_back(
        ray_set(fmt::format("size {:.0e}", size), kind, {size, 2 * size, 0, false}, any_between(2, 10)));
  }
  for (const int k : {-100, -50, 50, 100}) {
    const double size = std::ldexp(1.0, k);
    sets.push_back(
        ray_set(fmt::format("size 2^{}", k), kind, {size, 2 * size, 0, false}, any_between(2, 10)));
  }
  return sets;
}

std::vector<RaySet> moved_sets(const RoundKind& kind) {
  std::vector<RaySet> sets;
  for (const double moved : {1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9}) {
    sets.push_back(
        ray_set(fmt::format("by {:.0e} sizes", moved), kind, {0.25, 4, moved, false}, any_between(2, 10)));
  }
  return sets;
}

std::vector<RaySet> near_sets(const RoundKind& kind) {
  std::vector<RaySet> sets;
  for (const double height : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16}) {
    for (const double side : {1.0, -1.0}) {
      sets.push_back(ray_set(fmt::format("{:.0e} {}", height, side > 0 ? "above" : "below"), kind,
                             {0.25, 4, 0, false},
                             [=](Random& random, const Placed& placed, const tracer::World&) {
                               return shot_of(placed, above(random, side * height));
                             }));
    }
  }
  return sets;
}

/// A hit of some ray that comes from outside, or sometimes from inside.
tracer::Hit some_hit(Random& random, const Placed& placed, const tracer::World& world) {
  constexpr int k_tries = 1000;
  for (int i = 0; i < k_tries; ++i) {
    const Shot shot = random.below(4) == 0
                          ? shot_of(placed, inside(random))
                          : shot_of(placed, uniform(random, start_at(random, placed, 2, 10)));
    tracer::Stats stats;
    tracer::Hit hit;
    if (tracer::closest(world, shot.ray, stats, hit)) return hit;
  }
  throw std::runtime_error("no ray hits a solid that it is aimed at");
}

Shot leaving(const tracer::World& world, const tracer::Hit& hit, Vec3 direction) {
  return {tracer::ray_from(world, hit, direction), true};
}

std::vector<RaySet> surface_sets(const RoundKind& kind) {
  std::vector<RaySet> sets;
  for (const double side : {1.0, -1.0}) {
    sets.push_back(ray_set(side > 0 ? "outward" : "inward", kind, {0.25, 4, 0, false},
                           [=](Random& random, const Placed& placed, const tracer::World& world) {
                             const tracer::Hit hit = some_hit(random, placed, world);
                             const Vec3 v = random.direction();
                             return leaving(world, hit, dot(v, hit.normal) * side > 0 ? v : -v);
                           }));
    sets.push_back(ray_set(side > 0 ? "tangent, outward" : "tangent, inward", kind, {0.25, 4, 0, false},
                           [=](Random& random, const Placed& placed, const tracer::World& world) {
                             const tracer::Hit hit = some_hit(random, placed, world);
                             const double slope = side * random.over_scales(1e-17, 0.1);
                             return leaving(world, hit,
                                            normalize(random.across(hit.normal) + hit.normal * slope));
                           }));
  }
  return sets;
}

/// Offset from the centre by a half axis, or by that and an ulp more or less.
Shot touching(Random& random, const Placed& placed) {
  const int axis = random.below(3), across = (axis + 1 + random.below(2)) % 3;
  Shot shot;
  shot.ray.direction = along_axis(random, axis);
  for (int i = 0; i < 3; ++i) {
    if (i != axis) shot.ray.direction[i] = random.sign() * 0.0;
  }
  const Vec3 c = placed.to_world.translation;
  shot.ray.origin = c;
  shot.ray.origin[axis] -= shot.ray.direction[axis] * 4 * placed.size;
  double rim = c[across] + random.sign() * length(placed.to_world.rows[static_cast<std::size_t>(across)]);
  const int step = random.below(3) - 1;
  if (step != 0) rim = std::nextafter(rim, step * std::numeric_limits<double>::infinity());
  shot.ray.origin[across] = rim;
  return shot;
}

std::vector<RaySet> axis_sets(const RoundKind& kind) {
  return {ray_set("along an axis", kind, {0.25, 4, 0, false},
                  [](Random& random, const Placed& placed, const tracer::World&) {
                    const int axis = random.below(3);
                    Shot shot;
                    shot.ray.direction = along_axis(random, axis);
                    const Vec3 target = placed.to_world.point(random.in_ball() * 1.3);
                    shot.ray.origin = target;
                    shot.ray.origin[axis] -=
                        shot.ray.direction[axis] * placed.size * random.over_scales(2, 10);
                    return shot;
                  }),
          ray_set("touching, within an ulp", kind, {1, 8, 0, true},
                  [](Random& random, const Placed& placed, const tracer::World&) {
                    return touching(random, placed);
                  })};
}

std::vector<RaySet> direction_sets(const RoundKind& kind) {
  std::vector<RaySet> sets;
  for (const auto& [least, most] : {std::pair{1e-160, 1e-150}, {1e-100, 1e100}, {1e150, 1e160}}) {
    sets.push_back(
        ray_set(fmt::format("{:.0e} to {:.0e}", least, most), kind, {0.25, 4, 0, false},
                [least = least, most = most](Random& random, const Placed& placed, const tracer::World&) {
                  Shot shot = any_shot(random, placed, 2, 10);
                  shot.ray.direction = normalize(shot.ray.direction * random.over_scales(least, most));
                  return shot;
                }));
  }
  return sets;
}

std::vector<RaySet> mixed_sets(const RoundKind& kind) {
  std::vector<RaySet> sets;
  for (const double moved : {0.0, 1e3, 1e6, 1e9}) {
    sets.push_back(ray_set(moved == 0 ? "near the origin" : fmt::format("moved by {:.0e} sizes", moved), kind,
                           {1e-9, 1e9, moved, false}, any_between(2, 1e9)));
  }
  return sets;
}

}  // namespace

void add_round_rows(Rows& rows, const RoundKind& kind, const std::vector<Method>& methods,
                    const Oracle& oracle) {
  const auto add = [&](const std::string& what, std::string about, std::vector<RaySet> sets) {
    const std::string name = kind.name + '.' + what;
    rows.push_back({name, std::move(about), [=](const Settings& settings) {
                      return measure(settings, name, sets, methods, oracle);
                    }});
  };
  add("uniform", "rays all over it, from 2 to 10 sizes away", uniform_sets(kind));
  add("inside", "rays from inside", inside_sets(kind));
  add("grazing", "rays within 1e-3 to 1e-16 sizes of tangency, on both sides", grazing_sets(kind));
  add("far", "from 10 to 1e9 sizes away", far_sets(kind));
  add("scaled", "of sizes 1e-9 to 1e9 and 2^-100 to 2^100", scaled_sets(kind));
  add("moved", "1e3 to 1e9 sizes from the origin", moved_sets(kind));
  add("near_surface", "rays that start 1e-4 to 1e-16 sizes above or below the surface", near_sets(kind));
  add("on_surface", "rays that leave the surface, tangent ones too", surface_sets(kind));
  add("axis_parallel", "directions with components of 0, -0 and next to nothing", axis_sets(kind));
  add("directions", "directions that were 1e-160 to 1e160 long", direction_sets(kind));
  add("mixed", "every size, place and distance together", mixed_sets(kind));
}

}  // namespace lancer::stress
