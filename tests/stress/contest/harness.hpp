#pragma once
// Runs methods over sets of rays, judges what they say by the truth and takes their times.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "stress/contest/clock.hpp"
#include "stress/random.hpp"
#include "stress/stress.hpp"
#include "stress/truth/first_hit.hpp"
#include "tracer/intersect.hpp"

namespace lancer::stress {

struct Shot {
  tracer::Ray ray;
  bool from_surface = false;  // its ray has the contact

  Sight sight() const { return {ray.origin, ray.direction, from_surface}; }
};

/// A world of one primitive, and rays that look for it.
struct Batch {
  std::unique_ptr<scene::Scene> scene;  // where the world finds it
  tracer::World world;
  std::vector<Shot> shots;
};

/// A set of rays of one sort. `make` makes a batch of `shots` rays from its own random numbers.
struct RaySet {
  std::string name;
  std::function<Batch(Random& random, int shots)> make;
};

/// What a method says that a ray meets first.
struct Answer {
  bool hit = false;
  bool entering = true;
  double t = 0;
  Vec3 point, normal;
};

/// A ray as the methods get it when they are timed.
struct Timed {
  const tracer::World* world;
  const tracer::Ray* ray;
  tracer::Probe probe;
};

struct Method {
  std::string name;
  bool in_use = false;
  std::function<Answer(const tracer::World&, const tracer::Ray&)> answer;  // empty: only timed
  std::function<double(const std::vector<Timed>&)> nanoseconds;            // a ray
};

/// Calls test(timed), which returns some double, for each ray, in several rounds: the best round's time a
/// ray.
template <class Test>
double best_nanoseconds(const std::vector<Timed>& rays, const Test& test);

/// What the tracer does: its errors are those of a whole ray's first hit, its time that of the test of one
/// primitive, and of the whole ray.
std::vector<Method> methods_in_use();
/// The candidates, and then these.
std::vector<Method> with_those_in_use(std::vector<Method> candidates);

using Oracle = std::function<Truth(const tracer::World&, const Sight&)>;

/// All of a row, with the limits that the method in use keeps: errors within 1 ulp and no wrong answer.
Outcome measure(const Settings& settings, const std::string& row, const std::vector<RaySet>& sets,
                const std::vector<Method>& methods, const Oracle& oracle);

// --- Details

/// Makes the compiler believe that the value is wanted.
void want(double value);

template <class Test>
double best_nanoseconds(const std::vector<Timed>& rays, const Test& test) {
  constexpr int k_rounds = 9;
  double best = std::numeric_limits<double>::infinity();
  for (int round = 0; round < k_rounds && !rays.empty(); ++round) {
    const double start = now_in_nanoseconds();
    double sum = 0;
    for (const Timed& timed : rays) sum += test(timed);
    best = std::fmin(best, now_in_nanoseconds() - start);
    want(sum);
  }
  return best / static_cast<double>(rays.size());
}

}  // namespace lancer::stress
