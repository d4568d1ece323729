#pragma once
// Sets of hard rays, each for a primitive in a world of its own, and what the sets of facets and of boxes
// have in common.

#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "stress/contest/line.hpp"
#include "stress/stress.hpp"
#include "tracer/intersect.hpp"

namespace lancer::stress::flat {

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

Field make_field(const Settings& settings, const std::string& row, const Set& set, std::size_t rays);

/// How near, as 10^-k sizes, rays come to what is hard.
inline constexpr int k_powers[] = {3, 6, 8, 10, 12, 14, 15, 16};
/// How near to a surface they start.
inline constexpr int k_near_powers[] = {4, 6, 8, 10, 12};
inline double ten_to_minus(int k) { return 1 / std::pow(10.0, k); }

/// What the other components of a direction along an axis are.
inline constexpr double k_next_to_nothing[] = {0.0, -0.0, 0x1p-1074, -0x1p-1074, 0x1p-1040, -1e-300};

/// Scaled by 1e-9 to 1e9 and 2^+-100. make(name, scale, away): a set.
template <class Make>
void add_scaled(Sets& sets, Make make) {
  for (const int k : {-9, -6, -3, 3, 6, 9})
    sets.push_back(make(fmt::format("1e{}", k), std::pow(10.0, k), 0.0));
  for (const int k : {-100, 100}) sets.push_back(make(fmt::format("2^{}", k), std::scalbn(1.0, k), 0.0));
}

/// Moved by 1e3 to 1e9 sizes.
template <class Make>
void add_moved(Sets& sets, Make make) {
  for (int k = 3; k <= 9; ++k) sets.push_back(make(fmt::format("1e{}", k), 1.0, std::pow(10.0, k)));
}

}  // namespace lancer::stress::flat
