// Glass in glass of every kind and across it; the eye outside, between and within.

#include <fmt/format.h>

#include "stress/rows/rows.hpp"
#include "stress/subjects/glass.hpp"
#include "stress/subjects/script.hpp"
#include "stress/truth/reference/pictures.hpp"

namespace lancer::stress {
namespace {

constexpr double k_indices[][2] = {{1.5, 1.2}, {1.2, 1.5}, {1.5, 0.8}, {1.5, 1.5}};

/// Pairs of all kinds: one in the other, across it, beside it; the eye outside, between and within.
Outcome pairs(const Settings& settings, double inner, Vec3 to) {
  const int size = settings.full ? 48 : 10;
  Measures measures{1e-12, {}, true};
  Verdict all;
  int number = 0;
  for (const Solid& a : solids()) {
    for (const Solid& b : solids()) {
      for (const auto& index : k_indices) {
        ++number;
        if (!settings.full && number % 4 != (number / 20) % 4) continue;
        for (const Vec3 eye :
             {Vec3{0.3, 0.2, 4}, to + Vec3{0.11, 0.07, 0.13} * inner, Vec3{-0.45, -0.3, 0.2}}) {
          const std::string name = fmt::format("{} of {} and {} of {} at {} from {}", a.name, index[0],
                                               b.name, index[1], at(to), at(eye));
          all.add(judge(name,
                        room(5) + a.placed(1, {}, index[0]) + b.placed(inner, to, index[1]) +
                            view(eye, {0.05, 0.03, -1}, 60, size),
                        measures));
        }
      }
    }
  }
  return outcome(all, measures);
}

}  // namespace

void add_media_nested_rows(Rows& rows) {
  rows.push_back({"media.nested", "solids in solids of other indices", [](const Settings& s) {
                    return pairs(s, 0.5, {0.05, -0.04, 0.03});
                  }});
  rows.push_back({"media.overlapping", "solids that overlap", [](const Settings& s) {
                    return pairs(s, 0.8, {0.9, 0.3, -0.2});
                  }});
}

}  // namespace lancer::stress
