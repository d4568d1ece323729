#include "tracer/search.hpp"

#include <algorithm>

#include "tracer/contacts.hpp"

namespace lancer::tracer {
namespace {

/// One ray's search for the first surface. Called for each primitive that the ray may meet.
class Search {
 public:
  Search(const World& world, const Ray& ray, Found& found)
      : world_(world), ray_(ray), start_(ray), probe_(ray, world.has_facets()), found_(found) {}

  void run(Stats& stats) {
    pass_through_solids();
    for (const std::uint32_t primitive : world_.unbounded) test(primitive);
    world_.listed_spheres.each(probe_, [&](std::uint32_t primitive) {
      test(primitive);
      return false;
    });
    world_.tree.traverse(probe_, found_.candidates.limit(), stats.node_visits, [&](std::uint32_t item) {
      test(world_.bounded[item]);
      return false;
    });
    stats.shape_tests += tests_;
    if (!found_.passed.empty()) settle_passed();
    found_.candidates.tidy();
  }

 private:
  /// Those that the ray starts on and is inside of.
  void pass_through_solids() {
    for (const Contact& contact : ray_.contacts) {
      const Kind kind = world_.primitives[contact.primitive].kind;
      if (at_start(contact, kind, ray_.direction) != AtStart::passes_through) continue;
      const Root root = exit(world_, contact.primitive, ray_.origin, ray_.direction);
      found_.candidates.add(contact.primitive, root, k_anywhere);
    }
  }

  void test(std::uint32_t primitive) {
    if (start_.is_on(primitive)) return;
    ++tests_;
    with_roots(world_, world_.primitives[primitive], probe_, [&](const Roots& roots) {
      if (roots.count > 0) {
        take(primitive, start_.is_rounded() ? ahead(world_, ray_, primitive, roots) : roots);
      } else if (roots.passes) {
        found_.passed.push_back({primitive, roots.root[0]});
      }
    });
  }

  void take(std::uint32_t primitive, const Roots& roots) {
    const bool first = roots.root[0].t > 0 || roots.at_start;
    if (first && take(primitive, roots.root[0])) return;
    if (roots.count > 1 && roots.root[1].t > 0) take(primitive, roots.root[1]);
  }

  /// False: the primitive's next root may do.
  bool take(std::uint32_t primitive, const Root& root) {
    if (!root.loose && root.t - root.error > found_.candidates.limit()) return true;
    const Interval own = own_interval(world_, primitive, probe_);
    if (!(own.enter <= own.leave)) return true;
    if (is_echo(world_, ray_, primitive, root)) return false;
    found_.candidates.add(primitive, root, own);
    return true;
  }

  void settle_passed();
  void add_touched();
  bool is_at_rim(std::uint32_t primitive, const Root& root) const {
    return root.rim && root.t > 0 && encloses(*world_.scene, shape_of(primitive));
  }
  std::uint32_t shape_of(std::uint32_t primitive) const { return world_.primitives[primitive].shape; }

  const World& world_;
  const Ray& ray_;
  const Start start_;
  const Probe probe_;
  Found& found_;
  std::uint64_t tests_ = 0;
};

bool meet(const Root& a, const Root& b) { return std::fabs(a.t - b.t) <= a.error + b.error; }

/// A closed mesh whose edge or corner the ray touches without a crossing is met there all the same, by a
/// facet that takes the ray in and one that takes it out again; where only one of the two is, as at the start
/// of an edge that the ray runs along, it runs beside the mesh. The other facets stay passed.
void Search::add_touched() {
  Candidates& candidates = found_.candidates;
  const auto is_same = [&](std::uint32_t a, std::uint32_t b) { return shape_of(a) == shape_of(b); };
  PassedList touched;
  for (const Passed& m : found_.passed) {
    if (!is_at_rim(m.primitive, m.root) || m.root.t - m.root.error > candidates.limit()) continue;
    const bool crossed = std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& c) {
      return is_at_rim(c.primitive, c.root) && is_same(c.primitive, m.primitive) && meet(c.root, m.root);
    });
    if (!crossed && !is_echo(world_, ray_, m.primitive, m.root)) touched.push_back(m);
  }
  std::sort(touched.begin(), touched.end(),
            [](const Passed& a, const Passed& b) { return a.primitive < b.primitive; });
  for (const Passed& m : touched) {
    const auto first_there = [&](bool entering) {
      return std::find_if(touched.begin(), touched.end(), [&](const Passed& o) {
        return is_same(o.primitive, m.primitive) && meet(o.root, m.root) && o.root.entering == entering;
      });
    };
    const bool goes_out_again = first_there(!m.root.entering) != touched.end();
    if (!goes_out_again || first_there(m.root.entering)->primitive != m.primitive) continue;
    const Interval own = own_interval(world_, m.primitive, probe_);
    Root root = m.root;
    root.rim = false;
    if (own.enter <= own.leave) candidates.add(m.primitive, root, own);
  }
}

[[gnu::noinline, gnu::cold]] void Search::settle_passed() {
  add_touched();
  Candidates& candidates = found_.candidates;
  candidates.tidy();
  // Of those farther away the search finds some and leaves out others, as the tree has it.
  std::size_t kept = 0;
  for (const Passed& m : found_.passed) {
    const Interval own = own_interval(world_, m.primitive, probe_);
    const bool is_met = std::any_of(candidates.begin(), candidates.end(),
                                    [&](const Candidate& c) { return c.primitive == m.primitive; });
    if (!is_met && own.enter <= own.leave && own.enter <= candidates.limit()) found_.passed[kept++] = m;
  }
  found_.passed.shrink(kept);
}

}  // namespace

void search(const World& world, const Ray& ray, Stats& stats, Found& found) {
  Search(world, ray, found).run(stats);
}

}  // namespace lancer::tracer
