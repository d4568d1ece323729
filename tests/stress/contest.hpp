#pragma once
// Methods side by side on the same rays: what each said against the truth, gathered over the sets of a row.

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "stress/methods_facet.hpp"
#include "stress/oracle_facet.hpp"
#include "stress/random.hpp"
#include "stress/stress.hpp"
#include "stress/ulp.hpp"
#include "tracer/intersect.hpp"

namespace lancer::stress::flat {

/// What a method reported.
struct Reported {
  bool hit = false;
  double t = 0;
  Vec3 point, normal;
  int face = 0;
  bool entering = false;
};

/// One method's record over all sets of a row.
class Record {
 public:
  Record(std::string method, bool in_use) {
    measure_.method = std::move(method);
    measure_.in_use = in_use;
  }

  /// `judge_entering`: whether the method says so at all.
  bool add(const std::string& set, const Truth& truth, const Reported& got) {
    ++measure_.rays;
    if (truth.hit != got.hit || (truth.hit && (truth.face != got.face || truth.entering != got.entering))) {
      ++measure_.wrong;
      ++wrong_[set];
      return false;
    }
    if (!truth.hit) return true;
    const double distance = ulps(got.t, truth.t), point = ulps(got.point, truth.point),
                 normal = ulps(got.normal, truth.normal);
    distances_.add(distance);
    worst_[set] = std::max({worst_[set], distance, point, normal});
    point_ = std::max(point_, point);
    normal_ = std::max(normal_, normal);
    return distance <= 1 && point <= 1 && normal <= 1;
  }
  void add_in_band() { ++measure_.in_band; }
  std::uint64_t wrong() const { return measure_.wrong; }
  void add_time(double nanoseconds, double tests) {
    nanoseconds_ += nanoseconds;
    tests_ += tests;
  }

  Measure measure() const {
    Measure out = measure_;
    out.distance_max = distances_.largest();
    out.distance_999 = distances_.at(0.999);
    if (distances_.count() > 0) {
      out.point_max = point_;
      out.normal_max = normal_;
    }
    if (tests_ > 0) out.nanoseconds = nanoseconds_ / tests_;
    out.set = worst_set();
    return out;
  }

 private:
  /// That with the most wrong answers, else that with the largest error.
  std::string worst_set() const {
    std::string set;
    std::uint64_t most = 0;
    for (const auto& [name, count] : wrong_) {
      if (count > most) {
        most = count;
        set = name;
      }
    }
    double largest = 0;
    if (most > 0) return set;
    for (const auto& [name, error] : worst_) {
      if (error > largest) {
        largest = error;
        set = name;
      }
    }
    return set;
  }

  Measure measure_;
  Errors distances_;
  double point_ = 0, normal_ = 0, nanoseconds_ = 0, tests_ = 0;
  std::map<std::string, double> worst_;
  std::map<std::string, std::uint64_t> wrong_;
};

/// The least time of some runs of `work`, which makes `tests` tests.
template <class Work>
void time_into(Record& record, std::size_t tests, Work work) {
  constexpr int k_runs = 3;
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < k_runs; ++run) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
    least = std::min(least, taken.count());
  }
  record.add_time(least, static_cast<double>(tests));
}

/// What the tracer's own must keep on every row. Where nothing was to be hit there are no errors to judge.
inline void add_limits(Outcome& outcome, const Measure& own) {
  if (!std::isnan(own.distance_max)) {
    outcome.limits.push_back({"distance, ulp", own.distance_max, 1});
    outcome.limits.push_back({"point, ulp", own.point_max, 1});
    outcome.limits.push_back({"normal, ulp", own.normal_max, 1});
  }
  outcome.limits.push_back({"wrong hits and misses", static_cast<double>(own.wrong), 0});
}

// --- Sets of rays
// ---------------------------------------------------------------------------------------------------------

struct Line {
  Vec3 origin, direction;
};

/// A scene of one primitive, and what makes rays for it.
struct Subject {
  std::unique_ptr<scene::Scene> scene = std::make_unique<scene::Scene>();
  std::function<Line(Random&)> ray;
};

/// How hard rays of one kind are made: a subject for every few rays.
struct Set {
  std::string name;
  std::function<Subject(Random&)> make;
};
using Sets = std::vector<Set>;

inline constexpr std::size_t k_rays_a_subject = 8;

/// The rays of a set, with the prepared worlds that they are for.
struct Field {
  std::string set;
  std::vector<Subject> subjects;
  std::vector<tracer::World> worlds;
  std::vector<Line> lines;

  const tracer::World& world_of(std::size_t ray) const { return worlds[ray / k_rays_a_subject]; }
};

inline Field make_field(const Settings& settings, const std::string& row, const Set& set, std::size_t rays) {
  const std::string name = row + "/" + set.name;
  Field field;
  field.set = set.name;
  for (std::size_t ray = 0; ray < rays; ++ray) {
    if (ray % k_rays_a_subject == 0) {
      Random random(settings.seed, name + "/subject", ray);
      field.subjects.push_back(set.make(random));
      field.worlds.push_back(tracer::prepare(*field.subjects.back().scene));
    }
    Random random(settings.seed, name, ray);
    field.lines.push_back(field.subjects.back().ray(random));
  }
  return field;
}

/// The digits that read back the same.
std::string exactly(Vec3 v);

/// How to make the first wrong answer again, or else the first that is not accurate enough.
struct Failure {
  std::string text;
  bool wrong_told = false;
  void tell(const Field& field, std::size_t ray, const std::string& numbers, const Truth& truth,
            const Reported& got);
};

/// A row's work: every method on every set. Kind has Numbers, numbers(world), plain (what methods
/// prepare from), truth, in_band, face and tell.
template <class Kind, class... Methods>
class Contest {
 public:
  Contest(const Settings& settings, std::string row) : settings_(settings), row_(std::move(row)) {}

  Outcome run(const Sets& sets) {
    for (const Set& set : sets) {
      const Field field = make_field(settings_, row_, set, rays());
      std::vector<Truth> truths;
      for (std::size_t ray = 0; ray < field.lines.size(); ++ray) {
        const Line& line = field.lines[ray];
        truths.push_back(Kind::truth(Kind::numbers(field.world_of(ray)), line.origin, line.direction));
      }
      std::size_t place = 0;
      (candidate<Methods>(records_[place++], field, truths), ...);
      in_use(field, truths);
    }
    Outcome outcome;
    for (const Record& record : records_) outcome.measures.push_back(record.measure());
    outcome.measures.push_back(own_.measure());
    add_limits(outcome, outcome.measures.back());
    outcome.note = failure_.text;
    return outcome;
  }

 private:
  std::size_t rays() const { return settings_.full ? 20000 : 600; }
  std::size_t rounds() const { return settings_.full ? 1 : 4; }

  void judge(Record& record, const Field& field, std::size_t ray, const Truth& truth, const Reported& got,
             bool own) {
    const Line& line = field.lines[ray];
    const auto numbers = [&] { return Kind::numbers(field.world_of(ray)); };
    const std::uint64_t wrong = record.wrong();
    if (record.add(field.set, truth, got)) return;
    if (record.wrong() > wrong && Kind::in_band(numbers(), line.origin, line.direction)) record.add_in_band();
    if (own) failure_.tell(field, ray, Kind::tell(numbers()), truth, got);
  }

  template <class Method>
  void candidate(Record& record, const Field& field, const std::vector<Truth>& truths) {
    std::vector<typename Method::Prepared> prepared;
    for (const tracer::World& world : field.worlds)
      prepared.push_back(Method::prepare(Kind::plain(Kind::numbers(world))));
    std::vector<Aim> aims;
    for (const Line& line : field.lines) aims.emplace_back(line.origin, line.direction);
    std::vector<Answer> answers(aims.size());
    time_into(record, aims.size() * rounds(), [&] {
      for (std::size_t round = 0; round < rounds(); ++round) {
        for (std::size_t ray = 0; ray < aims.size(); ++ray)
          answers[ray] = Method::test(prepared[ray / k_rays_a_subject], aims[ray]);
      }
    });
    for (std::size_t ray = 0; ray < aims.size(); ++ray) {
      Reported got{answers[ray].hit, answers[ray].t, {}, {}, answers[ray].face, truths[ray].entering};
      if (got.hit) {
        const Place place = Method::place(prepared[ray / k_rays_a_subject], aims[ray], answers[ray]);
        got.point = place.point;
        got.normal = place.normal;
      }
      judge(record, field, ray, truths[ray], got, false);
    }
  }

  void in_use(const Field& field, const std::vector<Truth>& truths) {
    std::vector<tracer::Probe> probes;
    for (const Line& line : field.lines) probes.emplace_back(line.origin, line.direction);
    int found = 0;
    time_into(own_, probes.size() * rounds(), [&] {
      for (std::size_t round = 0; round < rounds(); ++round) {
        for (std::size_t ray = 0; ray < probes.size(); ++ray)
          found += roots(field.world_of(ray), 0, probes[ray]).count;
      }
    });
    sink_ = sink_ + found;
    tracer::Stats stats;
    tracer::Hit hit;
    for (std::size_t ray = 0; ray < field.lines.size(); ++ray) {
      tracer::Ray one;
      one.origin = field.lines[ray].origin;
      one.direction = field.lines[ray].direction;
      Reported got;
      got.hit = closest(field.world_of(ray), one, stats, hit);
      if (got.hit) got = {true, hit.root.t, hit.point, hit.normal, Kind::face(hit.root), hit.root.entering};
      judge(own_, field, ray, truths[ray], got, true);
    }
  }

  Settings settings_;
  std::string row_;
  std::vector<Record> records_{Record(Methods::k_name, false)...};
  Record own_{"in use", true};
  Failure failure_;
  volatile int sink_ = 0;
};

}  // namespace lancer::stress::flat
