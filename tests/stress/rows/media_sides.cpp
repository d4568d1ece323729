// Points on surfaces and next to them, in, on or out; and eyes that stand there.

#include <fmt/format.h>
#include <limits>

#include "stress/contest/judgement.hpp"
#include "stress/contest/line.hpp"
#include "stress/rows/rows.hpp"
#include "stress/subjects/cancelling.hpp"
#include "stress/subjects/placement.hpp"
#include "stress/truth/exact_sign.hpp"
#include "stress/truth/side.hpp"
#include "tracer/build.hpp"
#include "tracer/media.hpp"

namespace lancer::stress::flat {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

int sign_of(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

constexpr const char* k_solids[] = {"sphere", "ellipsoid", "plane", "turned box", "box"};

void add_solid(scene::Scene& scene, int kind, Random& random) {
  using namespace tracer::test;
  const Vec3 center = random.in_cube(2), sizes = Vec3{1.1, 1.1, 1.1} + random.in_cube(0.9);
  const Affine map = then(scaling(sizes), turned(random, 9));
  switch (kind) {
    case 0: add_sphere(scene, center, random.between(0.1, 3)); break;
    case 1: add_sphere(scene, {}, 1, {}, map); break;
    case 2: add_plane(scene, center, random.direction()); break;
    case 3: add_box(scene, {-1, -1, -1}, {1, 1, 1}, {}, map); break;
    default: add_box(scene, center - sizes, center + sizes); break;
  }
}

void check_side(Judgement& judgement, const char* set, const tracer::World& world, Vec3 p) {
  const int truth = true_side(world, p);
  const auto text = [&] { return fmt::format("at {}, in truth {}", exactly(p), truth); };
  judgement.check(sign_of(side(world, 0, p)) == truth, set, text);
  const std::vector<tracer::Surrounding> around = solids_around(world, p);
  const bool listed = truth > 0 ? around.empty() : around.size() == 1 && around[0].touched == (truth == 0);
  judgement.check(listed, set, text);
}

/// Points within a few steps of the doubles of a surface.
void next_to_surfaces(Judgement& judgement, const Settings& settings) {
  const std::uint64_t worlds = settings.full ? 20000 : 500;
  for (std::uint64_t i = 0; i < worlds; ++i) {
    Random random(settings.seed, "media.sides", i);
    const int kind = static_cast<int>(i % 5);
    scene::Scene scene;
    add_solid(scene, kind, random);
    const tracer::World world = tracer::prepare(scene);
    for (int k = 0; k < 10; ++k) {
      const double distance = random.between(1, 20);
      const int face = random.below(6);
      Vec3 p = project(world, 0, random.direction() * distance, face);
      for (int axis = 0; axis < 3; ++axis) {
        for (int steps = random.below(4); steps > 0; --steps)
          p[axis] = std::nextafter(p[axis], random.sign() * k_infinity);
      }
      check_side(judgement, k_solids[kind], world, p);
    }
  }
}

/// Off by less than twice the precision shows.
void beyond_twice_the_precision(Judgement& judgement, const Settings& settings) {
  for (std::uint64_t i = 0; i < 100; ++i) {
    Random random(settings.seed, "media.sides/beyond", i);
    scene::Scene with_plane, with_sphere;
    const Across across = all_but_orthogonal(random, random.below(5) - 2);
    tracer::test::add_plane(with_plane, {}, across.n);
    check_side(judgement, "plane, beyond", tracer::prepare(with_plane), across.d * random.sign());
    // (3 + 4 e)^2 + (4 - 3 e)^2 = 25 + 25 e^2.
    const double e = std::scalbn(1.0, -50 - random.below(350)), x = random.sign(), y = random.sign();
    tracer::test::add_sphere(with_sphere, Vec3{-4 * x, 3 * y, 0} * e, 5);
    check_side(judgement, "sphere, beyond", tracer::prepare(with_sphere), {3 * x, 4 * y, 0});
  }
}

/// An eye exactly on a solid is in it where it looks into it.
void eyes_on_surfaces(Judgement& judgement, const Settings& settings) {
  struct Place {
    const char* name;
    Vec3 at;
    std::vector<Vec3> normals;  // of all surfaces there
  };
  const std::vector<std::pair<int, Place>> places = {
      {0, {"eye on a sphere", {1, 2, 2}, {{1, 2, 2}}}},
      {0, {"eye on a sphere", {-3, 0, 0}, {{-1, 0, 0}}}},
      {1, {"eye on a side", {0.25, 1, 0.125}, {{0, 1, 0}}}},
      {1, {"eye on an edge", {-1, 1, 0.125}, {{0, 1, 0}, {-1, 0, 0}}}},
      {1, {"eye on a corner", {-1, 1, 1}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}},
      {2, {"eye on a plane", {3, -1, 0}, {{1, 2, 2}}}}};
  for (const auto& [kind, place] : places) {
    scene::Scene scene;
    if (kind == 0) tracer::test::add_sphere(scene, {}, 3);
    if (kind == 1) tracer::test::add_box(scene, {-1, -1, -1}, {1, 1, 1});
    if (kind == 2) tracer::test::add_plane(scene, {1, 0, 0}, {1, 2, 2});
    const tracer::World world = tracer::prepare(scene);
    const Vec3 at = place.at;
    const std::vector<tracer::Surrounding> around = solids_around(world, at);
    for (std::uint64_t i = 0; i < 400; ++i) {
      Random random(settings.seed, std::string("media.sides/") + place.name, i);
      const Vec3 d = random.direction();
      bool inside = true;
      for (const Vec3 n : place.normals) {
        inside =
            inside && exact_sign([&]<class Number>(Number) { return dot(as<Number>(n), as<Number>(d)); }) < 0;
      }
      tracer::Stats stats;
      const bool opened = open_at(world, around, at, d, stats).size() == 1;
      judgement.check(opened == inside, place.name, [&] { return told(at, d); });
    }
  }
}

/// Of two solids around the eye, that which is left last is the outer one, however near they are.
void nested_eyes(Judgement& judgement, const Settings& settings) {
  for (const bool larger : {false, true}) {
    scene::Scene scene;
    tracer::test::add_sphere(scene, {}, 1);
    tracer::test::add_sphere(scene, {}, larger ? 1 + 1e-14 : 1 - 1e-14);
    const tracer::World world = tracer::prepare(scene);
    for (std::uint64_t i = 0; i < (settings.full ? 100000U : 4000U); ++i) {
      Random random(settings.seed, "media.sides/nested", i);
      const double from_middle = random.between(0, 0.95);
      const Vec3 origin = random.direction() * from_middle, d = random.direction();
      tracer::Stats stats;
      const tracer::OpenSolids open = open_at(world, solids_around(world, origin), origin, d, stats);
      const bool right = open.size() == 2 && open[0] == (larger ? 1U : 0U);
      judgement.check(right, "spheres 1e-14 apart", [&] { return told(origin, d); });
    }
  }
}

/// Points on the axes of an octahedron and beside them: no ray along an axis tells in from out there.
void within_octahedron(Judgement& judgement) {
  scene::Scene scene;
  scene::Mesh mesh;
  mesh.solid = true;
  mesh.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  tracer::test::add_mesh(scene, mesh);
  const tracer::World world = tracer::prepare(scene);
  for (int eighth = -12; eighth <= 12; ++eighth) {
    for (const Vec3 beside : {Vec3{0, 0, 0}, Vec3{0, 0.25, 0}, Vec3{0, 0, 0.25}}) {
      const Vec3 p = beside + Vec3{eighth / 8.0, 0, 0};
      const double size = std::fabs(p.x) + p.y + p.z;
      if (size == 1) continue;
      judgement.check((side(world, 0, p) < 0) == (size < 1), "octahedron", [&] { return exactly(p); });
    }
  }
}

Outcome sides(const Settings& settings) {
  Judgement judgement;
  next_to_surfaces(judgement, settings);
  beyond_twice_the_precision(judgement, settings);
  eyes_on_surfaces(judgement, settings);
  nested_eyes(judgement, settings);
  within_octahedron(judgement);
  return judgement.outcome();
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_media_sides_rows(Rows& rows) {
  rows.push_back(
      {"media.sides", "points on surfaces and next to them: in, on or out, and eyes there", flat::sides});
}
