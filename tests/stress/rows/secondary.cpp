// Rays that start on surfaces: they neither meet the surface that they leave where they leave it nor miss the
// far side of the solid that they enter, nor a neighbour, however near.

#include <fmt/format.h>
#include <memory>
#include <type_traits>

#include "stress/methods/walks.hpp"
#include "stress/rows/rows.hpp"
#include "stress/subjects/body.hpp"
#include "stress/truth/facet.hpp"
#include "stress/truth/first_hit.hpp"
#include "stress/truth/ulp.hpp"
#include "stress/truth/way_out.hpp"

namespace lancer::stress::flat {
namespace {

/// Might what is met by a ray that leaves a surface, off it, be due to where rounding put its start? On
/// curved surfaces that turns the normal; beside an edge the ray may pass below the edge.
template <class Place>
bool hangs_on_start(const tracer::World& world, const Place& from, Vec3 o, Vec3 d, double t) {
  const tracer::Primitive& p = world.primitives[from.primitive()];
  if (p.kind == tracer::Kind::sphere) return first_hit(world.spheres[p.record], Sight{o, d, true}).in_band;
  if (p.kind == tracer::Kind::ellipsoid)
    return first_hit(world.ellipsoids[p.record], Sight{o, d, true}).in_band;
  const Vec3 by = four_ulp(o);
  return p.kind == tracer::Kind::facet && t * std::fabs(dot(from.normal(), d)) <= by.x + by.y + by.z;
}

/// What a way of going on did.
struct Count {
  Measure measure;
  Errors distances;
  std::string note;

  void bad(const std::string& what, const Cell& cell, Vec3 from, Vec3 direction) {
    if (note.empty())
      note =
          fmt::format("{}: {}: from {} direction {}", what, cell.name(), exactly(from), exactly(direction));
  }
};

template <class Walk>
class Walker {
 public:
  using Place = typename Walk::Place;
  Walker(Walk walk, Count& count) : walk_(std::move(walk)), count_(count) {}

  /// A body alone: nothing is met outwards, the far side inwards, from outside and from within.
  void alone(const Cell& cell, const tracer::World& world, Random& random) {
    Place first;
    if (!walk_.start(world, arriving(cell, random), first)) return;
    nothing(cell, world, first, leaving(first.normal(), 1, random));
    const Vec3 in = leaving(first.normal(), -1, random);
    if (cell.body == Body::plane) {
      nothing(cell, world, first, in);
      return;
    }
    Place far;
    if (!far_side(cell, world, first, in, far)) return;
    nothing(cell, world, far, leaving(far.normal(), 1, random));
    Place next;
    far_side(cell, world, far, leaving(far.normal(), -1, random), next);
  }

  /// Two of them, one within the other, so near that the gap is next to nothing.
  void neighbours(const Cell& cell, const tracer::World& world, Random& random) {
    constexpr std::uint32_t k_inner = 0, k_outer = 1;
    Place outer, inner, again, far;
    if (!walk_.start(world, arriving(cell, random), outer) || outer.shape() != k_outer) return;
    const Vec3 in = inwards(cell, outer.point(), outer.normal(), random);
    if (!meets(cell, world, outer, in, k_inner, true, inner)) return;
    const Vec3 back = normalize(inner.normal() + random.in_ball() * 0.9);
    meets(cell, world, inner, back, k_outer, false, again);
    if (cell.body == Body::plane) return;
    const Vec3 through = inwards(cell, inner.point(), inner.normal(), random);
    if (meets(cell, world, inner, through, k_inner, false, far))
      meets(cell, world, far, through, k_outer, false, again);
  }

  /// Two in the very same place: both are met, the one that was added first before the other.
  void coincident(const Cell& cell, const tracer::World& world, Random& random) {
    Place first, second, far, last;
    const Line line = arriving(cell, random);
    if (!walk_.start(world, line, first)) return;
    if (first.shape() != 0) missed("the second before the first", cell, first, line.direction);
    nothing(cell, world, first, leaving(first.normal(), 1, random));
    const Vec3 in = inwards(cell, first.point(), first.normal(), random);
    if (!meets(cell, world, first, in, 1, true, second)) return;
    if (cell.body == Body::plane) {
      nothing(cell, world, second, in);
      return;
    }
    ++count_.measure.rays;
    if (!walk_.go(world, second, in, far) || far.entering()) {
      missed("the far sides", cell, second, in);
      return;
    }
    if (meets(cell, world, far, in, 1 - far.shape(), false, last)) nothing(cell, world, last, in);
  }

 private:
  void nothing(const Cell& cell, const tracer::World& world, const Place& from, Vec3 d) {
    ++count_.measure.rays;
    Place to;
    if (!walk_.go(world, from, d, to)) return;
    ++count_.measure.self_hits;
    if (hangs_on_start(world, from, walk_.from(from, d), d, to.t())) ++count_.measure.in_band;
    count_.bad(fmt::format("shape {} is met at {:.3g}, {}, by a ray that leaves shape {}", to.shape(), to.t(),
                           to.entering() ? "entering" : "leaving", from.shape()),
               cell, walk_.from(from, d), d);
  }

  bool far_side(const Cell& cell, const tracer::World& world, const Place& from, Vec3 d, Place& to) {
    ++count_.measure.rays;
    const bool found = walk_.go(world, from, d, to);
    const Vec3 start = walk_.from(from, d);
    WayOut truth;
    // Of a mesh, the facet that was found is the truth, unless there is none or it is met at once.
    if (found && cell.body == Body::mesh && to.t() > 1e-6 * cell.scale) {
      const tracer::FacetPrimitive& f = world.facets[world.primitives[to.primitive()].record];
      const Truth one = facet_truth(numbers_of(f), start, d);
      truth = {one.hit, one.t};
    } else {
      truth = way_out(world, from.primitive(), start, d);
    }
    if (!truth.judged) return false;
    if (!found) {
      ++count_.measure.leaks;
      count_.bad("the far side is missed", cell, start, d);
    } else if (Real(to.t()) < truth.t / 2 || to.entering()) {
      ++count_.measure.self_hits;
      count_.bad(fmt::format("the far side is met at {:.3g}, {}, for {:.3g}", to.t(),
                             to.entering() ? "entering" : "leaving", to_double(truth.t)),
                 cell, start, d);
    } else {
      const double error = ulps(to.t(), truth.t);
      count_.distances.add(error);
      if (error > 1) count_.bad(fmt::format("the far side is {:.3g} ulp off", error), cell, start, d);
      return true;
    }
    return false;
  }

  bool meets(const Cell& cell, const tracer::World& world, const Place& from, Vec3 d, std::uint32_t shape,
             bool entering, Place& to) {
    ++count_.measure.rays;
    if (walk_.go(world, from, d, to) && to.shape() == shape && to.entering() == entering) return true;
    missed(fmt::format("shape {} is not met {}", shape, entering ? "entering" : "leaving"), cell, from, d);
    return false;
  }

  void missed(const std::string& what, const Cell& cell, const Place& from, Vec3 d) {
    ++count_.measure.wrong;
    count_.bad(what, cell, walk_.from(from, d), d);
  }

  Walk walk_;
  Count& count_;
};

/// The worlds of a cell: the body alone, with neighbours, and twice in the same place.
struct Stage {
  std::vector<std::unique_ptr<scene::Scene>> scenes;
  std::vector<tracer::World> worlds;

  Stage(const Cell& cell, const std::vector<std::vector<double>>& bodies) {
    for (const std::vector<double>& grown : bodies) {
      scenes.push_back(std::make_unique<scene::Scene>());
      for (const double one : grown) add_body(*scenes.back(), cell, one);
      worlds.push_back(tracer::prepare(*scenes.back()));
    }
  }
};

template <class Walk>
void walk_cell(const Settings& settings, const std::string& row, const Cell& cell, const Stage& stage,
               Walk walk, Count& count) {
  // Each round is up to some 25 rays.
  const std::uint64_t rounds = settings.full ? 8000 : 24;
  const auto wrong = [&] { return count.measure.self_hits + count.measure.leaks + count.measure.wrong; };
  const std::uint64_t before = wrong();
  Walker<Walk> walker(std::move(walk), count);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    Random random(settings.seed, row + cell.name(), round);
    for (int i = 0; i < 3; ++i) walker.alone(cell, stage.worlds[0], random);
    walker.neighbours(cell, stage.worlds[1], random);
    walker.neighbours(cell, stage.worlds[2], random);
    if constexpr (std::is_same_v<Walk, OwnWalk>) walker.coincident(cell, stage.worlds[3], random);
  }
  if (wrong() > before) count.measure.set = cell.name();
}

std::vector<Rule> rules() {
  return {{"t > 1e-6", 1e-6, 0, false},
          {"t > 1e-4 (POV-Ray)", 1e-4, 0, false},
          {"t > 1e-9 (Tachyon)", 1e-9, 0, false},
          {"offset 1e-6 n", 0, 1e-6, false},
          {"256 ulp (Waechter-Binder)", 0, 0, true}};
}

Outcome spawned(const Settings& settings, const std::string& row, Body body) {
  std::vector<Count> counts(rules().size() + 1);
  for (const double away : {0.0, 1e6}) {
    for (const double scale : {1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9}) {
      const Cell cell{body, scale, away};
      const Stage stage(cell, {{0}, {0, 1e-4}, {0, 1e-8}, {0, 0}});
      for (std::size_t i = 0; i < rules().size(); ++i)
        walk_cell(settings, row, cell, stage, RuleWalk(rules()[i]), counts[i]);
      walk_cell(settings, row, cell, stage, OwnWalk(), counts.back());
    }
  }
  Outcome outcome;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    Measure measure = counts[i].measure;
    measure.in_use = i + 1 == counts.size();
    measure.method = measure.in_use ? "in use" : rules()[i].name;
    measure.distance_max = counts[i].distances.largest();
    measure.distance_999 = counts[i].distances.at(0.999);
    outcome.measures.push_back(measure);
  }
  const Measure& own = outcome.measures.back();
  if (body != Body::plane) outcome.limits.push_back({"distance to the far side, ulp", own.distance_max, 1});
  outcome.limits.push_back({"self-hits", static_cast<double>(own.self_hits), 0});
  outcome.limits.push_back({"far sides missed (leaks)", static_cast<double>(own.leaks), 0});
  outcome.limits.push_back({"neighbours missed (wrong)", static_cast<double>(own.wrong), 0});
  outcome.note = counts.back().note;
  return outcome;
}

}  // namespace
}  // namespace lancer::stress::flat

void lancer::stress::add_secondary_rows(Rows& rows) {
  using namespace flat;
  const auto add = [&](const std::string& what, Body body) {
    const std::string name = "secondary." + what;
    rows.push_back({name,
                    "rays that leave it, into it and off it; neighbours at 1e-4, 1e-8 and 0 of its size",
                    [name, body](const Settings& settings) { return spawned(settings, name, body); }});
  };
  add("sphere", Body::sphere);
  add("plane", Body::plane);
  add("ellipsoid", Body::ellipsoid);
  add("box", Body::box);
  add("mesh", Body::mesh);
}
