#pragma once
// The contest of the methods that meet facets.

#include <fmt/format.h>
#include <string>

#include "stress/contest/contest.hpp"
#include "stress/methods/facet.hpp"
#include "stress/subjects/facet.hpp"

namespace lancer::stress::flat {

struct FacetKind {
  using Numbers = FacetNumbers;
  static FacetNumbers numbers(const tracer::World& world) { return numbers_of(world.facets.at(0)); }
  static Triangle plain(const FacetNumbers& f) {
    return f.flipped ? Triangle{f.a, f.c, f.b} : Triangle{f.a, f.b, f.c};
  }
  static Truth truth(const FacetNumbers& f, Vec3 o, Vec3 d) { return facet_truth(f, o, d); }
  static bool in_band(const FacetNumbers& f, Vec3 o, Vec3 d) { return facet_in_band(f, o, d); }
  static int face(const tracer::Root&) { return 0; }
  static std::string tell(const FacetNumbers& f) {
    return fmt::format("facet {} {} {}{}", exactly(f.a), exactly(f.b), exactly(f.c),
                       f.flipped ? " flipped" : "");
  }
};

using FacetContest = Contest<FacetKind, NaiveFacet, MollerTrumbore, BaldwinWeber, Plucker, Woop<false>,
                             Woop<true>, DoubleDoubleFacet>;

}  // namespace lancer::stress::flat
