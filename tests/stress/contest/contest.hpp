#pragma once
// Methods side by side on the same rays: what each said against the truth, gathered over the sets of a row.

#include <string>
#include <vector>

#include "stress/contest/field.hpp"
#include "stress/contest/record.hpp"
#include "stress/methods/aim.hpp"

namespace lancer::stress::flat {

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

/// Adds a row that is a contest on the sets that `sets` makes.
template <class AContest>
void add_row(Rows& rows, const std::string& name, const std::string& about, Sets (*sets)()) {
  rows.push_back(
      {name, about, [name, sets](const Settings& settings) { return AContest(settings, name).run(sets()); }});
}

}  // namespace lancer::stress::flat
