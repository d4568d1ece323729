#include "stress/contest/line.hpp"

#include <fmt/format.h>

namespace lancer::stress::flat {

Line towards(Vec3 target, double distance, Random& random) {
  return line_to(target + random.direction() * distance, target);
}

Line towards(Vec3 target, Random& random) {
  const double distance = random.between(2, 10);
  return towards(target, distance, random);
}

std::string exactly(Vec3 v) { return fmt::format("<{:a}, {:a}, {:a}>", v.x, v.y, v.z); }

std::string told(Vec3 origin, Vec3 direction) {
  return fmt::format("origin {} direction {}", exactly(origin), exactly(direction));
}

}  // namespace lancer::stress::flat
