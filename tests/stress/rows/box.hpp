#pragma once
// The contest of the methods that meet boxes.

#include <fmt/format.h>
#include <string>

#include "stress/contest/contest.hpp"
#include "stress/methods/box.hpp"

namespace lancer::stress::flat {

struct BoxKind {
  using Numbers = BoxNumbers;
  static BoxNumbers numbers(const tracer::World& world) { return numbers_of(world.boxes.at(0)); }
  static const BoxNumbers& plain(const BoxNumbers& b) { return b; }
  static Truth truth(const BoxNumbers& b, Vec3 o, Vec3 d) { return box_truth(b, o, d); }
  static bool in_band(const BoxNumbers& b, Vec3 o, Vec3 d) { return box_in_band(b, o, d); }
  static int face(const tracer::Root& root) { return root.face; }
  static std::string tell(const BoxNumbers& b) {
    std::string text = fmt::format("box {} {}", exactly(b.lo), exactly(b.hi));
    if (!b.turned) return text;
    return text + fmt::format(" center {} to_own {} {} {}", exactly(b.center), exactly(b.to_own[0]),
                              exactly(b.to_own[1]), exactly(b.to_own[2]));
  }
};

using BoxContest = Contest<BoxKind, TwelveFacets, SlabReciprocal, SlabDivision, DoubleDoubleBox>;

}  // namespace lancer::stress::flat
