#include "stress/contest/harness.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

#include "stress/truth/ulp.hpp"

namespace lancer::stress {
namespace {

constexpr int k_batch = 32;
constexpr int k_quick = 24, k_full = 625;  // batches a set
constexpr std::size_t k_timed = 2048;      // rays at most
constexpr double k_one_ulp = 1;

std::string hex(Vec3 v) { return fmt::format("{{{:a}, {:a}, {:a}}}", v.x, v.y, v.z); }

/// The numbers of the batch's primitive, to the bit.
std::string described(const tracer::World& world) {
  if (!world.spheres.empty()) {
    return fmt::format("sphere {} {:a}", hex(world.spheres[0].center), world.spheres[0].radius);
  }
  if (!world.ellipsoids.empty()) {
    const auto& e = world.ellipsoids[0];
    return fmt::format("ellipsoid {} rows {} {} {}", hex(e.center), hex(e.to_own[0]), hex(e.to_own[1]),
                       hex(e.to_own[2]));
  }
  const auto& p = world.planes[0];
  return fmt::format("plane {} normal {} level {:a}", hex(p.point), hex(p.normal), p.level);
}

/// Is it no further from the start than that, but for the rounding of the point?
bool is_within(const Answer& answer, const Shot& shot, double most) {
  const double rounding = 0x1p-50 * (max_abs(shot.ray.origin) + max_abs(answer.point));
  return answer.t <= most && max_abs(answer.point - shot.ray.origin) <= most + rounding;
}

/// What is known of a method after some rays.
class Tally {
 public:
  void start_set(const std::string& name) { set_ = {name, 0, 0}; }

  void add(const Batch& batch, const Shot& shot, const Answer& answer, const Truth& truth) {
    ++measure_.rays;
    if (truth.open) {
      if (answer.hit && !is_within(answer, shot, to_double(truth.t))) add_wrong(batch, shot, answer, truth);
    } else if (answer.hit != truth.hit || (truth.hit && answer.entering != truth.entering)) {
      add_wrong(batch, shot, answer, truth);
    } else if (truth.hit) {
      const double distance = ulps(answer.t, truth.t), point = ulps(answer.point, truth.point),
                   normal = ulps(answer.normal, truth.normal);
      distance_.add(distance);
      point_.add(point);
      normal_.add(normal);
      const double worst = std::max({distance, point, normal});
      if (worst > set_.error) set_.error = worst;
      if (worst > worst_ && wrong_text_.empty()) {
        worst_ = worst;
        worst_text_ =
            text_of(fmt::format("{:.3g}, {:.3g} and {:.3g} ulp", distance, point, normal), batch, shot);
      }
    }
  }

  void end_set() {
    if (set_.wrong > worst_set_.wrong || (set_.wrong == worst_set_.wrong && set_.error > worst_set_.error)) {
      worst_set_ = set_;
    }
  }

  Measure measure(bool one_set) const {
    Measure out = measure_;
    if (!one_set) out.set = worst_set_.name;
    out.distance_max = distance_.largest();
    out.distance_999 = distance_.at(0.999);
    out.point_max = point_.largest();
    out.normal_max = normal_.largest();
    return out;
  }
  /// How to repeat the worst ray.
  const std::string& worst() const { return wrong_text_.empty() ? worst_text_ : wrong_text_; }

 private:
  struct Set {
    std::string name;
    std::uint64_t wrong = 0;
    double error = 0;
  };

  void add_wrong(const Batch& batch, const Shot& shot, const Answer& answer, const Truth& truth) {
    ++measure_.wrong;
    ++set_.wrong;
    const bool in_band = truth.in_band && !truth.open;
    if (in_band) ++measure_.in_band;
    if (shot.from_surface && answer.hit && !in_band) ++measure_.self_hits;
    const auto word = [](bool hit, bool entering) {
      return !hit ? "a miss" : entering ? "an entry" : "an exit";
    };
    if (shot.from_surface && in_band) return;  // which no limit is for
    if (wrong_text_.empty() || (!in_band && wrong_in_band_)) {
      wrong_in_band_ = in_band;
      wrong_text_ = text_of(
          fmt::format("{} for {}", word(answer.hit, answer.entering), word(truth.hit, truth.entering)), batch,
          shot);
    }
  }

  std::string text_of(const std::string& what, const Batch& batch, const Shot& shot) const {
    return fmt::format("{} in {}: {}, {}from {} along {}", what, set_.name, described(batch.world),
                       shot.from_surface ? "leaving it, " : "", hex(shot.ray.origin),
                       hex(shot.ray.direction));
  }

  Measure measure_;
  Errors distance_, point_, normal_;
  Set set_, worst_set_;
  double worst_ = -1;
  bool wrong_in_band_ = false;
  std::string worst_text_, wrong_text_;
};

/// The same share of every set's batches, at most k_timed rays in all. They stay alive in `kept`.
std::vector<Timed> timed_rays(const std::vector<Batch>& kept) {
  std::vector<Timed> out;
  for (const Batch& batch : kept) {
    for (const Shot& shot : batch.shots) {
      if (out.size() < k_timed) out.push_back({&batch.world, &shot.ray, tracer::Probe(shot.ray)});
    }
  }
  return out;
}

void add_limits(const Measure& m, const std::string& worst, bool any_hits, bool from_surface,
                Outcome& outcome) {
  if (any_hits) {
    outcome.limits.push_back({"distance", m.distance_max, k_one_ulp});
    outcome.limits.push_back({"point", m.point_max, k_one_ulp});
    outcome.limits.push_back({"normal", m.normal_max, k_one_ulp});
  }
  // On which side a ray leaves a surface is decided by a rounded normal.
  if (from_surface) {
    outcome.limits.push_back({"wrong, not in band", static_cast<double>(m.wrong - m.in_band), 0});
    outcome.limits.push_back({"self-hits", static_cast<double>(m.self_hits), 0});
  } else {
    outcome.limits.push_back({"wrong", static_cast<double>(m.wrong), 0});
  }
  if (!outcome.met()) outcome.note = "worst ray: " + worst;
}

Answer answer_in_use(const tracer::World& world, const tracer::Ray& ray) {
  tracer::Stats stats;
  tracer::Hit hit;
  if (!tracer::closest(world, ray, stats, hit)) return {};
  return {true, hit.root.entering, hit.root.t, hit.point, hit.normal};
}

}  // namespace

std::vector<Method> methods_in_use() {
  const auto one_test = [](const Timed& timed) {
    const tracer::Ray& ray = *timed.ray;
    if (!ray.contacts.empty()) return tracer::exit(*timed.world, 0, ray.origin, ray.direction).t;
    const tracer::Roots found = tracer::roots(*timed.world, 0, timed.probe);
    return found.count > 0 ? found.root[0].t : 0;
  };
  const auto whole_ray = [](const Timed& timed) {
    tracer::Stats stats;
    tracer::Hit hit;
    return tracer::closest(*timed.world, *timed.ray, stats, hit) ? hit.root.t : 0;
  };
  return {{"in use", true, answer_in_use,
           [one_test](const std::vector<Timed>& rays) { return best_nanoseconds(rays, one_test); }},
          {"in use, whole ray", true, {}, [whole_ray](const std::vector<Timed>& rays) {
             return best_nanoseconds(rays, whole_ray);
           }}};
}

std::vector<Method> with_those_in_use(std::vector<Method> candidates) {
  for (Method& method : methods_in_use()) candidates.push_back(std::move(method));
  return candidates;
}

Outcome measure(const Settings& settings, const std::string& row, const std::vector<RaySet>& sets,
                const std::vector<Method>& methods, const Oracle& oracle) {
  std::vector<Tally> tallies(methods.size());
  std::vector<Batch> kept;
  const int batches = settings.full ? k_full : k_quick;
  const std::size_t kept_of_set = std::max<std::size_t>(1, k_timed / k_batch / sets.size());
  bool any_hits = false, from_surface = false;
  for (const RaySet& set : sets) {
    for (Tally& tally : tallies) tally.start_set(set.name);
    for (int i = 0; i < batches; ++i) {
      Random random(settings.seed, row + '/' + set.name, static_cast<std::uint64_t>(i));
      Batch batch = set.make(random, k_batch);
      for (const Shot& shot : batch.shots) {
        const Truth truth = oracle(batch.world, shot.sight());
        any_hits = any_hits || truth.hit;
        from_surface = from_surface || shot.from_surface;
        for (std::size_t m = 0; m < methods.size(); ++m) {
          if (methods[m].answer) tallies[m].add(batch, shot, methods[m].answer(batch.world, shot.ray), truth);
        }
      }
      if (static_cast<std::size_t>(i) < kept_of_set) kept.push_back(std::move(batch));
    }
    for (Tally& tally : tallies) tally.end_set();
  }
  const std::vector<Timed> timed = timed_rays(kept);
  Outcome outcome;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    Measure one = tallies[m].measure(sets.size() == 1);
    one.method = methods[m].name;
    one.in_use = methods[m].in_use;
    one.nanoseconds = methods[m].nanoseconds(timed);
    outcome.measures.push_back(one);
    if (one.in_use && methods[m].answer) add_limits(one, tallies[m].worst(), any_hits, from_surface, outcome);
  }
  return outcome;
}

void want(double value) {
  volatile double sink = value;
  static_cast<void>(sink);
}

}  // namespace lancer::stress
