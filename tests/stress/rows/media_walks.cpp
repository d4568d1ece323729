// Straight ways through blocks of glass that touch: a block cut into eight, as boxes or closed meshes, turned
// and carried anywhere; along the cuts, through the edges where four of them meet and the corner where all
// do.

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>

#include "stress/contest/judgement.hpp"
#include "stress/contest/line.hpp"
#include "stress/rows/rows.hpp"
#include "stress/subjects/placement.hpp"
#include "tracer/build.hpp"
#include "tracer/media.hpp"

namespace lancer::stress::flat {
namespace {

constexpr int k_pieces = 8;

/// The block [-1, 1]^3, cut at `cut`; piece i lies above the cut of an axis where that bit of i is set.
struct Blocks {
  Affine map;
  double away = 0;
  Vec3 cut;
  scene::Scene scene;
  tracer::World world;

  Vec3 low(int piece) const {
    return {piece & 1 ? cut.x : -1, piece & 2 ? cut.y : -1, piece & 4 ? cut.z : -1};
  }
  Vec3 high(int piece) const { return {piece & 1 ? 1 : cut.x, piece & 2 ? 1 : cut.y, piece & 4 ? 1 : cut.z}; }

  Blocks(const Affine& placed, double how_far, Vec3 cut_at) : map(placed), away(how_far), cut(cut_at) {
    for (int piece = 0; piece < k_pieces; ++piece)
      tracer::test::add_box(scene, low(piece), high(piece), tracer::test::clear(0.5, 1), map);
    world = tracer::prepare(scene);
  }

  /// The piece around a point of the block's own space, -1 where there is none; -2 where it is too near a
  /// side for rounding to tell.
  int piece_at(Vec3 p, double doubt) const {
    int piece = 0;
    bool outside = false;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double wall : {-1.0, cut[axis], 1.0}) {
        if (std::fabs(p[axis] - wall) <= doubt) return -2;
      }
      outside = outside || std::fabs(p[axis]) > 1;
      if (p[axis] > cut[axis]) piece |= 1 << axis;
    }
    return outside ? -1 : piece;
  }
};

/// In the block's own space, from outside towards `to`.
struct Aim {
  Vec3 from, to;
};

Vec3 outside(Random& random) { return random.direction() * random.between(2, 6); }

Aim anywhere(const Blocks&, Random& random) {
  const Vec3 from = outside(random);
  return {from, random.in_cube(1)};
}

/// Within the rounding of the corner of all, or of an edge between four.
Aim at_the_middle(const Blocks& blocks, Random& random) {
  Aim aim{outside(random), blocks.cut};
  if (random.below(2) == 0) aim.to[random.below(3)] = random.between(-1, 1);
  return aim;
}

/// All but in a cut, or a side, by an angle of 1e-1 down to the last digits of places, perhaps in
/// two.
Aim along_a_cut(const Blocks& blocks, Random& random) {
  for (;;) {
    Aim aim{outside(random), random.in_cube(1)};
    for (int count = 1 + random.below(2); count > 0; --count) {
      const int axis = random.below(3);
      const double wall = random.below(4) == 0 ? random.sign() : blocks.cut[axis];
      aim.to[axis] = wall;
      aim.from[axis] = wall + random.signed_over_scales(1e-15 * (1 + blocks.away), 1e-1);
    }
    if (max_abs(aim.from) > 1.2) return aim;
  }
}

/// Goes on to the end, and checks each way: a surface leads into a solid that is not open or out of one that
/// is, and those that are open are those around the middle of the way.
void walk(Judgement& judgement, const char* set, const Blocks& blocks, const Aim& aim, double doubt) {
  const Affine back = *inverse(blocks.map);
  tracer::Ray ray;
  ray.origin = blocks.map.point(aim.from);
  ray.direction = normalize(blocks.map.point(aim.to) - ray.origin);
  const auto text = [&, first = ray] { return told(first.origin, first.direction); };
  tracer::Stats stats;
  tracer::Hit hit;
  int count = 0;
  for (; count < 64 && closest(blocks.world, ray, stats, hit); ++count) {
    const int around = blocks.piece_at(back.point(ray.origin + (hit.point - ray.origin) * 0.5), doubt);
    if (around != -2) {
      const bool fits = around == -1 ? ray.open.empty()
                                     : ray.open.size() == 1 && ray.open[0] == static_cast<unsigned>(around);
      if (!judgement.check(fits, set, text)) return;
    }
    const bool open = std::find(ray.open.begin(), ray.open.end(), hit.shape) != ray.open.end();
    if (!judgement.check(open != hit.root.entering, set, text)) return;
    tracer::OpenSolids beyond = ray.open;
    cross(blocks.world, beyond, hit.shape, hit.root.entering);
    ray = ray_from(blocks.world, hit, ray.direction);
    ray.open = beyond;
  }
  judgement.check(count < 64 && ray.open.empty(), set, text);
}

Outcome walks(const Settings& settings) {
  const std::uint64_t worlds = settings.full ? 4000 : 60, rays = settings.full ? 100 : 50;
  Judgement judgement;
  struct Sort {
    const char* name;
    Aim (*make)(const Blocks&, Random&);
  };
  for (const Sort& sort :
       {Sort{"anywhere", anywhere}, Sort{"at the middle", at_the_middle}, Sort{"along a cut", along_a_cut}}) {
    for (std::uint64_t i = 0; i < worlds; ++i) {
      Random random(settings.seed, std::string("media.walks/") + sort.name, i);
      const double away = i % 3 == 0 ? 0 : i % 3 == 1 ? 9 : 1e4;
      const Affine map = i % 6 == 0 ? Affine{} : turned(random, away);
      const Vec3 cut = random.in_cube(0.8);
      const Blocks blocks(map, away, cut);
      for (std::uint64_t ray = 0; ray < rays; ++ray) {
        walk(judgement, sort.name, blocks, sort.make(blocks, random), 1e-12 * (1 + away));
      }
    }
  }
  return judgement.outcome();
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_media_walks_rows(Rows& rows) {
  rows.push_back(
      {"media.walks", "straight ways through a block cut into eight that touch: what is open", flat::walks});
}
