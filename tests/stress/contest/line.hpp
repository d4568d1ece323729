#pragma once
// A ray as it is made and told of: where it starts and its direction, in digits that read back the same.

#include <string>

#include "stress/random.hpp"

namespace lancer::stress::flat {

struct Line {
  Vec3 origin, direction;
};

/// From `origin` at `target`.
inline Line line_to(Vec3 origin, Vec3 target) { return {origin, normalize(target - origin)}; }
/// At `target` from `distance` away, out of any direction.
Line towards(Vec3 target, double distance, Random& random);
/// The same, from 2 to 10 away.
Line towards(Vec3 target, Random& random);

/// The digits that read back the same.
std::string exactly(Vec3 v);
std::string told(Vec3 origin, Vec3 direction);
inline std::string told(const Line& line) { return told(line.origin, line.direction); }

}  // namespace lancer::stress::flat
