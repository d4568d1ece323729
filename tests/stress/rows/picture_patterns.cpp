// Faces in the boundaries of a pattern's cells, which must have one colour.

#include <fmt/format.h>

#include "stress/contest/judgement.hpp"
#include "stress/contest/line.hpp"
#include "stress/rows/rows.hpp"
#include "stress/subjects/placement.hpp"
#include "tracer/build.hpp"
#include "tracer/surface.hpp"

namespace lancer::stress::flat {
namespace {

scene::Material patterned(scene::Scene& scene, scene::Pattern::Kind kind, double size, Vec3 axis) {
  scene::Pattern pattern;
  pattern.kind = kind;
  pattern.a = grey(0.9);
  pattern.b = grey(0.3);
  pattern.size = size;
  pattern.axis = axis;
  scene.patterns.push_back(pattern);
  scene::Material material = tracer::test::black();
  material.ambient.pattern = static_cast<scene::Index>(scene.patterns.size() - 1);
  return material;
}

/// The colour at the point that a ray meets is that of an even or odd cell.
void check_color(Judgement& judgement, const char* set, const tracer::World& world, Vec3 target, Vec3 from,
                 bool odd) {
  tracer::Ray ray;
  ray.origin = from;
  ray.direction = normalize(target - from);
  tracer::Stats stats;
  tracer::Hit hit;
  const bool right = closest(world, ray, stats, hit) &&
                     surface_at(world, {}, ray, hit, true, stats).ambient == grey(odd ? 0.3 : 0.9);
  judgement.check(right, set, [&] { return told(ray.origin, ray.direction); });
}

/// Scaled, in most cases turned, and moved.
Affine anywhere(Random& random) {
  const double scale = random.over_scales(1e-3, 1e3);
  const double away = random.below(2) == 0 ? 0 : 9;
  const Affine map = random.below(4) == 0 ? Affine{} : turned(random, away);
  return then(then(scaling({scale, scale, scale}), map), translation(random.in_cube(1)));
}

/// A box whose sides all lie in boundaries of cells.
void checkered_box(Judgement& judgement, Random& random) {
  constexpr int k_cells = 3;
  const double size = random.below(2) == 0 ? 1 : random.between(0.05, 2);
  const Affine map = random.below(4) == 0 ? Affine{} : anywhere(random);
  scene::Scene scene;
  const scene::Material material = patterned(scene, scene::Pattern::Kind::checker, size, {});
  int first[3];
  Vec3 lo, hi;
  for (int i = 0; i < 3; ++i) {
    first[i] = random.below(9) - 5;
    lo[i] = first[i] * size;
    hi[i] = (first[i] + k_cells) * size;
  }
  tracer::test::add_box(scene, lo, hi, material, map);
  const tracer::World world = tracer::prepare(scene);
  for (int ray = 0; ray < 32; ++ray) {
    const int face = random.below(6), axis = face / 2;
    Vec3 target;
    int sum = 0;
    for (int i = 0; i < 3; ++i) {
      const int cell = first[i] + (i != axis ? random.below(k_cells) : face % 2 == 0 ? 0 : k_cells);
      target[i] = (cell + (i == axis ? 0 : random.between(0.05, 0.95))) * size;
      sum += cell;
    }
    Vec3 from = target + random.in_cube(2) * size;
    from[axis] = target[axis] + (face % 2 == 0 ? -1 : 1) * random.between(0.5, 3) * size;
    check_color(judgement, "box", world, map.point(target), map.point(from), sum % 2 != 0);
  }
}

/// A plane in a boundary: of cells, or of stripes along its own normal.
void patterned_plane(Judgement& judgement, Random& random, bool striped) {
  const double size = random.below(2) == 0 ? 1 : random.between(0.05, 2);
  const int level = random.below(13) - 6;
  const Vec3 normal = !striped               ? Vec3{0, 1, 0}
                      : random.below(2) == 0 ? Vec3{0.28, 0.96, 0}
                                             : random.direction();
  const Affine map = random.below(3) == 0 ? Affine{} : anywhere(random);
  scene::Scene scene;
  using Kind = scene::Pattern::Kind;
  const scene::Material material = patterned(scene, striped ? Kind::stripes : Kind::checker, size, normal);
  tracer::test::add_shape(scene, scene::ShapeKind::plane, scene.planes, {{}, normal, level * size}, material,
                          map);
  const tracer::World world = tracer::prepare(scene);
  for (int ray = 0; ray < 32; ++ray) {
    const int column = random.below(21) - 10, row = random.below(21) - 10;
    const double x = (column + random.between(0.05, 0.95)) * size;
    const double z = (row + random.between(0.05, 0.95)) * size;
    Vec3 target = Vec3{x, 0, z};
    if (striped) target = target - normal * dot(target, normal);
    target = target + normal * (level * size);
    const double side = random.sign(), height = side * random.between(0.1, 5) * size;
    const Vec3 from = target + random.across(normal) * size + normal * height;
    const int sum = striped ? level : column + level + row;
    check_color(judgement, striped ? "stripes along the normal" : "plane", world, map.point(target),
                map.point(from), sum % 2 != 0);
  }
}

Outcome patterns(const Settings& settings) {
  const std::uint64_t worlds = settings.full ? 30000 : 600;
  Judgement judgement;
  for (std::uint64_t i = 0; i < worlds; ++i) {
    Random random(settings.seed, "picture.patterns", i);
    if (i % 2 == 0) checkered_box(judgement, random);
    if (i % 2 == 1) patterned_plane(judgement, random, i % 4 == 1);
  }
  return judgement.outcome();
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_picture_patterns_rows(Rows& rows) {
  rows.push_back(
      {"picture.patterns", "faces in the boundaries of a pattern's cells: one colour", flat::patterns});
}
