// Boxes that a ray enters by a side, is continued in by the tracer and leaves by an edge, a corner or next to
// one.

#include <fmt/format.h>
#include <functional>
#include <stdexcept>

#include "stress/contest/line.hpp"
#include "stress/contest/record.hpp"
#include "stress/rows/rows.hpp"
#include "stress/subjects/placement.hpp"
#include "stress/truth/box.hpp"
#include "tracer/build.hpp"

namespace lancer::stress::flat {
namespace {

/// In by a side, at `start`, then towards `target`, both in the space of the box.
struct Passage {
  Vec3 lo, hi, start, target;
  int axis = 0;
};

/// From the lower side to an edge or corner, or `beside` it.
Passage to_rim(Random& random, bool corner, double beside) {
  Passage out;
  for (int i = 0; i < 3; ++i) {
    out.hi[i] = random.between(0.5, 2);
    out.lo[i] = -out.hi[i];
    out.start[i] = out.hi[i] * random.between(-0.9, 0.9);
    out.target[i] = out.hi[i] * random.between(-0.9, 0.9);
  }
  out.axis = random.below(3);
  out.start[out.axis] = out.lo[out.axis];
  out.target[out.axis] = out.hi[out.axis];
  for (int k = 1; k <= (corner ? 2 : 1); ++k) {
    const int next = (out.axis + k) % 3;
    out.target[next] = random.below(2) == 0 ? out.lo[next] : out.hi[next];
  }
  if (beside > 0) {
    for (int i = 0; i < 3; ++i) out.target[i] += random.signed_over_scales(beside * 1e-3, beside);
  }
  return out;
}

/// Along a diagonal, of which two or all three components are equal: several sides are met at the very same
/// distance.
Passage along_diagonal(Random& random, bool corner) {
  Passage out;
  out.axis = random.below(3);
  const double width = 1 + random.below(16) / 8.0;
  Vec3 way;
  for (int i = 0; i < 3; ++i) {
    const bool shared = corner || i == out.axis || i == (out.axis + 1) % 3;
    const double more = i == out.axis ? 0 : 0.5 + random.below(8) / 8.0;
    out.lo[i] = random.below(64) / 8.0 - 4;
    out.hi[i] = out.lo[i] + width + more;
    way[i] = shared ? 1 : random.below(7) / 8.0;
    if (i != out.axis) way[i] *= random.sign();
    const bool back = way[i] < 0;
    out.start[i] = i == out.axis ? out.lo[i] : back ? out.lo[i] + width : out.hi[i] - width;
  }
  out.target = out.start + way * width;
  return out;
}

Outcome exits(const Settings& settings) {
  const std::uint64_t count = settings.full ? 20000 : 600;
  Record record("in use", true);
  Outcome out;
  const auto run = [&](const std::string& set, bool is_turned,
                       const std::function<Passage(Random&)>& passage_of) {
    for (std::uint64_t i = 0; i < count; ++i) {
      Random random(settings.seed, "box.exits/" + set, i);
      const Passage passage = passage_of(random);
      const Affine map = is_turned ? turned(random, random.below(2) == 0 ? 0 : 9) : Affine{};
      scene::Scene scene;
      tracer::test::add_box(scene, passage.lo, passage.hi, {}, map);
      const tracer::World world = tracer::prepare(scene);
      Vec3 ahead;
      ahead[passage.axis] = 1;
      tracer::Ray first;
      first.origin = map.point(passage.start - ahead);
      first.direction = normalize(map.vector(ahead));
      tracer::Stats stats;
      tracer::Hit hit, end;
      if (!closest(world, first, stats, hit)) throw std::runtime_error("a ray misses the box ahead");
      const tracer::Ray ray = ray_from(world, hit, normalize(map.point(passage.target) - hit.point));
      const Truth truth = box_way_out(numbers_of(world.boxes[0]), ray.origin, ray.direction);
      Reported got;
      got.hit = closest(world, ray, stats, end);
      if (got.hit) got = {true, end.root.t, end.point, end.normal, end.root.face, end.root.entering};
      if (!record.add(set, truth, got) && out.note.empty())
        out.note = fmt::format("{}: side {} for {}, lo {} hi {} {}", set, got.face, truth.face,
                               exactly(passage.lo), exactly(passage.hi), told(ray.origin, ray.direction));
    }
  };
  for (const bool is_turned : {false, true}) {
    const std::string way = is_turned ? "turned, " : "aligned, ";
    for (const bool corner : {false, true}) {
      const std::string rim = corner ? "corner" : "edge";
      run(way + "by the " + rim, is_turned, [=](Random& random) { return to_rim(random, corner, 0); });
      for (const double beside : {1e-15, 1e-9})
        run(fmt::format("{}{:.0e} beside the {}", way, beside, rim), is_turned,
            [=](Random& random) { return to_rim(random, corner, beside); });
      run(way + "along a diagonal to the " + rim, is_turned,
          [=](Random& random) { return along_diagonal(random, corner); });
    }
  }
  out.measures.push_back(record.measure());
  add_limits(out, out.measures.back());
  return out;
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_box_exits_rows(Rows& rows) {
  rows.push_back({"box.exits", "in by a side, out by an edge or a corner or next to it, aligned and turned",
                  flat::exits});
}
