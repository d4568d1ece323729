// Closed surfaces that no ray may slip through: shared edges and corners, from inside and from outside,
// through the tracer's own tree.

#include <fmt/format.h>
#include <memory>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "stress/contest/clock.hpp"
#include "stress/contest/line.hpp"
#include "stress/methods/facet.hpp"
#include "stress/rows/rows.hpp"
#include "stress/subjects/mesh.hpp"
#include "stress/subjects/placement.hpp"
#include "tracer/build.hpp"

namespace lancer::stress::flat {
namespace {

/// A ray at an edge or corner, and the side that it comes from.
struct Shot {
  Line line;
  bool from_inside = false;
};

/// A closed convex surface in a world of its own.
struct Hull {
  std::string name;
  std::unique_ptr<scene::Scene> scene = std::make_unique<scene::Scene>();
  tracer::World world;
  std::function<Shot(Random&)> shot;
  bool solid = true;  // one shape that encloses something
};

/// At an edge point in three of four cases, else at a corner; both as near as doubles come.
Shot mesh_shot(const scene::Mesh& mesh, const Affine& map, Random& random) {
  const auto& face = mesh.faces[static_cast<std::size_t>(random.below(static_cast<int>(mesh.faces.size())))];
  const auto first = static_cast<std::size_t>(random.below(3));
  const Vec3 a = mesh.points[face[first]], b = mesh.points[face[(first + 1) % 3]];
  const double share = random.below(4) == 0 ? 0 : random.unit();
  const Vec3 from = placed(map, a);
  const Vec3 target = from + (placed(map, b) - from) * share;
  if (random.below(4) != 0) return {line_to(placed(map, random.in_ball() * 0.5), target), true};
  // Where all facets around the target are seen from outside.
  const Vec3 outwards = (a + (b - a) * share) * random.between(1.5, 4);
  const Vec3 own = outwards + random.in_ball() * 0.1;
  return {line_to(placed(map, own), target), false};
}

Hull mesh_hull(const std::string& name, int levels, const Affine& map, bool loose) {
  Hull hull;
  hull.name = name;
  const scene::Mesh mesh = icosphere(levels);
  if (loose) {
    for (const auto& [a, b, c] : mesh.faces)
      tracer::test::add_facet(*hull.scene, mesh.points[a], mesh.points[b], mesh.points[c], {}, map);
  } else {
    tracer::test::add_mesh(*hull.scene, mesh, {}, map);
  }
  hull.solid = !loose;
  hull.world = tracer::prepare(*hull.scene);
  hull.shot = [mesh, map](Random& random) { return mesh_shot(mesh, map, random); };
  return hull;
}

Hull box_hull(const std::string& name, Vec3 half, const Affine& map) {
  Hull hull;
  hull.name = name;
  tracer::test::add_box(*hull.scene, -half, half, {}, map);
  hull.world = tracer::prepare(*hull.scene);
  hull.shot = [half, map](Random& random) {
    const auto point = [&](Vec3 q) { return placed(map, {q.x * half.x, q.y * half.y, q.z * half.z}); };
    Vec3 q{random.sign(), random.sign(), random.sign()};
    const int axis = random.below(3);
    if (random.below(4) != 0) q[axis] = random.between(-1, 1);
    const Vec3 target = point(q);
    if (random.below(4) != 0) return Shot{line_to(point(random.in_cube(0.5)), target), true};
    const Vec3 outwards = q * random.between(1.5, 4);
    return Shot{line_to(point(outwards + random.in_cube(0.1)), target), false};
  };
  return hull;
}

std::vector<Hull> hulls() {
  std::vector<Hull> all;
  const auto mesh = [&](const std::string& name, int levels, const Affine& map) {
    all.push_back(mesh_hull(name, levels, map, false));
  };
  mesh("20 facets", 0, {});
  mesh("1280 facets", 3, {});
  mesh("1280, scaled 1e-9", 3, placement(1, 0, 1e-9));
  mesh("1280, scaled 1e9", 3, placement(1, 0, 1e9));
  mesh("1280, flattened 1e-6", 3, placement(1e-6, 0, 1));
  mesh("1280, flattened 1e-6, moved 1e3, scaled 1e-9", 3, placement(1e-6, 1e3, 1e-9));
  mesh("1280, moved 1e5", 3, placement(1, 1e5, 1));
  mesh("1280, moved 1e9", 3, placement(1, 1e9, 1));
  mesh("1280, mirrored", 3, then(scaling({-1, 1, 1}), rotation(Vec3{1, 2, 3}, 50)));
  mesh("20480 facets", 5, {});
  all.push_back(mesh_hull("320 loose facets", 2, {}, true));
  all.push_back(mesh_hull("320 loose, flattened 1e-6", 2, placement(1e-6, 0, 1), true));
  all.push_back(box_hull("box", {1, 1, 1}, {}));
  all.push_back(box_hull("box, turned", {1, 1, 1}, rotation(Vec3{1, 2, 3}, 40)));
  all.push_back(box_hull("box, turned, 1 : 1e+-4", {1e-4, 1, 1e4}, rotation(Vec3{1, 2, 3}, 40)));
  return all;
}

/// What became of rays [first, last).
struct Count {
  std::uint64_t leaks = 0, wrong = 0;
  std::uint64_t first_bad = ~std::uint64_t{0};

  void bad(std::uint64_t ray) { first_bad = std::min(first_bad, ray); }
  Count operator+(const Count& b) const {
    return {leaks + b.leaks, wrong + b.wrong, std::min(first_bad, b.first_bad)};
  }
};

/// The same however the rays are shared out between threads; without `full` on one.
template <class Work>
Count count_rays(std::uint64_t rays, bool full, Work work) {
  const auto run = [&](std::uint64_t first, std::uint64_t last, Count count) {
    for (std::uint64_t ray = first; ray < last; ++ray) work(ray, count);
    return count;
  };
  if (!full) return run(0, rays, {});
  return tbb::parallel_reduce(
      tbb::blocked_range<std::uint64_t>(0, rays, 1 << 14), Count{},
      [&](const tbb::blocked_range<std::uint64_t>& part, const Count& count) {
        return run(part.begin(), part.end(), count);
      },
      [](const Count& a, const Count& b) { return a + b; });
}

std::string tell(const std::string& set, std::uint64_t ray, const Shot& shot) {
  return fmt::format("{} ray {}: {}, from {}", set, ray, told(shot.line),
                     shot.from_inside ? "inside" : "outside");
}

Measure shoot_in_use(const Settings& settings, const Hull& hull, std::uint64_t rays, std::string& note) {
  const std::uint64_t set = hash_of(hull.name);
  const double start = now_in_nanoseconds();
  const Count count = count_rays(rays, settings.full, [&](std::uint64_t ray, Count& out) {
    Random random(settings.seed, set, ray);
    const Shot shot = hull.shot(random);
    tracer::Ray one;
    one.origin = shot.line.origin;
    one.direction = shot.line.direction;
    if (shot.from_inside && hull.solid) one.open.push_back(0);
    tracer::Stats stats;
    tracer::Hit hit;
    if (!closest(hull.world, one, stats, hit)) {
      ++out.leaks;
      out.bad(ray);
    } else if (hit.root.entering == shot.from_inside) {
      ++out.wrong;
      out.bad(ray);
    }
  });
  Measure measure = measure_in_use("in use");
  measure.set = hull.name;
  measure.rays = rays;
  measure.leaks = count.leaks;
  measure.wrong = count.wrong;
  measure.nanoseconds = (now_in_nanoseconds() - start) / static_cast<double>(rays);
  if (count.first_bad < rays && note.empty()) {
    Random random(settings.seed, set, count.first_bad);
    note = tell(hull.name, count.first_bad, hull.shot(random));
  }
  return measure;
}

/// A candidate on every facet of the hull.
template <class Method>
Measure shoot_candidate(const Settings& settings, const Hull& hull, std::uint64_t rays) {
  std::vector<typename Method::Prepared> facets;
  for (const tracer::FacetPrimitive& f : hull.world.facets)
    facets.push_back(Method::prepare({f.a, f.b, f.c}));
  const std::uint64_t set = hash_of(hull.name);
  const double start = now_in_nanoseconds();
  const Count count = count_rays(rays, settings.full, [&](std::uint64_t ray, Count& out) {
    Random random(settings.seed, set, ray);
    const Shot shot = hull.shot(random);
    const Aim aim(shot.line.origin, shot.line.direction);
    bool any = false;
    for (const auto& facet : facets) any = Method::test(facet, aim).hit || any;
    if (!any) ++out.leaks;
  });
  Measure measure;
  measure.method = Method::k_name;
  measure.set = hull.name;
  measure.rays = rays;
  measure.leaks = count.leaks;
  measure.nanoseconds = (now_in_nanoseconds() - start) / static_cast<double>(rays * facets.size());
  return measure;
}

template <class... Methods>
void shoot_candidates(const Settings& settings, const Hull& hull, std::uint64_t rays, Outcome& outcome) {
  (outcome.measures.push_back(shoot_candidate<Methods>(settings, hull, rays)), ...);
}

void limit_leaks(Outcome& outcome) {
  double leaks = 0, wrong = 0;
  for (const Measure& measure : outcome.measures) {
    if (!measure.in_use) continue;
    leaks += static_cast<double>(measure.leaks);
    wrong += static_cast<double>(measure.wrong);
  }
  outcome.limits.push_back({"leaks", leaks, 0});
  outcome.limits.push_back({"entering for leaving", wrong, 0});
}

Outcome leaks(const Settings& settings) {
  const std::uint64_t total = settings.full ? 1'000'000'000 : 700'000;
  Outcome outcome;
  const std::uint64_t few = settings.full ? 4'000'000 : 20'000;
  for (const Affine& map : {Affine{}, placement(1, 0, 1e-9), placement(1e-6, 0, 1)}) {
    const std::string name = map == Affine{}                ? "80 facets"
                             : map == placement(1e-6, 0, 1) ? "80, flattened 1e-6"
                                                            : "80, scaled 1e-9";
    const Hull small = mesh_hull(name, 1, map, false);
    shoot_candidates<NaiveFacet, MollerTrumbore, BaldwinWeber, Plucker, Woop<false>, Woop<true>>(
        settings, small, few, outcome);
    outcome.measures.push_back(shoot_in_use(settings, small, few, outcome.note));
  }
  const std::vector<Hull> all = hulls();
  for (const Hull& hull : all)
    outcome.measures.push_back(shoot_in_use(settings, hull, total / all.size(), outcome.note));
  limit_leaks(outcome);
  return outcome;
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_mesh_leaks_rows(Rows& rows) {
  rows.push_back({"mesh.leaks",
                  "rays at shared edges and corners of closed meshes and boxes, from both sides",
                  flat::leaks});
}
