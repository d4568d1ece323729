#pragma once
// Groups of rays that search together: every primitive is asked for all of them. Compiled in the namespace
// LANCER_TARGET.

#include "tracer/packet/passing.hpp"
#include "tracer/packet/slabs.hpp"
#include "tracer/tree/walk.hpp"

namespace lancer::tracer::LANCER_TARGET {

/// What all searches of a group have.
struct Group {
  const Scenery& scenery;
  Work& work;
  std::size_t first;  // of the columns
  std::array<Probes, k_vectors> probes;
  std::array<Start, k_vectors> start;
  std::array<Mask, k_vectors> doubt;
  std::uint64_t rays = 0;
  std::uint64_t spent = 0;  // in about the time of a test of four rays

  LANCER_INLINE Group(const Scenery& s, const RaysView& view, std::size_t from, Work& w)
      : scenery(s), work(w), first(from) {
    for (std::size_t k = 0; k < k_vectors; ++k) {
      const std::size_t at = first + 4 * k;
      Probes& p = probes[k];
      p.origin = load(*view.origin, at);
      p.direction = load(*view.direction, at);
      const Lanes one = lanes(1.0);
      p.inverse = {one / p.direction.x, one / p.direction.y, one / p.direction.z};
      const auto left = static_cast<long long>(view.count) - static_cast<long long>(at);
      p.active = mask(Mask{0, 1, 2, 3} < masks(left));
      doubt[k] = masks(0);
      if (view.starts) {
        set_start(view, k, at);
      } else {
        start[k].set_none();
      }
    }
  }

  /// Once it is known which rays search; false: none.
  LANCER_INLINE bool begin() {
    for (Probes& p : probes) {
      rays += static_cast<unsigned>(std::popcount(bits(p.active)));
      if (scenery.has_facets && any(p.active)) set_shear(p);
    }
    return rays != 0;
  }

  /// One by one its rays would by now be nearly done.
  LANCER_INLINE bool is_too_much() const { return spent > k_worth * rays; }

  LANCER_INLINE const Probes* probe() const { return probes.data(); }
  LANCER_INLINE void count_node() {
    ++work.node_visits;
    spent += k_node;
  }
  /// The largest lane of those active.
  LANCER_INLINE double most(const std::array<Lanes, k_vectors>& values) const {
    Lanes all = lanes(-k_infinity);
    for (std::size_t k = 0; k < k_vectors; ++k)
      all = greater(all, select(probes[k].active, values[k], lanes(-k_infinity)));
    return std::max(std::max(all[0], all[1]), std::max(all[2], all[3]));
  }

 private:
  static constexpr std::uint64_t k_worth = 10, k_node = 3;

  LANCER_INLINE void set_start(const RaysView& view, std::size_t k, std::size_t at) {
    const Starts& from = *view.starts;
    start[k].primitive = load(&from.primitive[at]);
    start[k].shape = load(&from.shape[at]);
    start[k].rise = load(&from.rise[at]);
    start[k].error = load(&from.error[at]);
    start[k].most_open = 0;
    doubt[k] = load(&from.passes[at]) & ~load(&view.exits->known[at]) & probes[k].active;
    if (view.open) doubt[k] |= start[k].set_open(view, at) & probes[k].active;
    probes[k].active &= ~doubt[k];
  }
};

/// Asks a primitive which rays meet it, and tells `take(k, surface, crossings)`.
template <class Take>
LANCER_INLINE void ask(Group& g, std::uint32_t primitive, const Take& take) {
  g.work.shape_tests += g.rays;
  with_surface(g.scenery, primitive, [&](const auto& surface) {
    for (std::size_t k = 0; k < k_vectors; ++k) {
      const Mask asked = g.probes[k].active & ~mask(g.start[k].primitive == masks(primitive));
      if (!any(asked)) continue;
      ++g.spent;
      Crossings c{};
      if (!meet(surface, g.probes[k], asked, c)) continue;
      g.start[k].doubt_near(g.scenery, primitive, surface, masks(-1), c);
      take(k, surface, c);
    }
  });
}

struct ClosestSearch : Group {
  std::array<First, k_vectors> found;

  LANCER_INLINE ClosestSearch(const Scenery& s, const RaysView& view, std::size_t from, Work& w)
      : Group(s, view, from, w) {
    if (!view.starts) return;
    for (std::size_t k = 0; k < k_vectors; ++k) {
      const std::size_t at = first + 4 * k;
      const Mask exits = load(&view.starts->passes[at]) & probes[k].active;
      if (!any(exits)) continue;
      found[k].begin(exits, load(&view.exits->primitive[at]), load(&view.exits->t[at]),
                     load(&view.exits->error[at]));
    }
  }

  LANCER_INLINE bool is_over() const { return is_too_much(); }
  LANCER_INLINE double limit() const {
    return most({found[0].high, found[1].high, found[2].high, found[3].high});
  }
  LANCER_INLINE void ask_one(std::uint32_t primitive) {
    ask(*this, primitive, [&](std::size_t k, const auto&, const Crossings& c) {
      doubt[k] |= c.doubt;
      found[k].take(masks(primitive), c);
    });
  }
  LANCER_INLINE void ask_leaf(const std::uint32_t* item) {
    for (;; ++item) {
      ask_one(scenery.bounded[*item & ~k_last_item]);
      if ((*item & k_last_item) != 0) return;
    }
  }

  LANCER_INLINE void tell(FirstHits& out) const {
    for (std::size_t k = 0; k < k_vectors; ++k) {
      const std::size_t at = first + 4 * k;
      store(&out.primitive[at], found[k].primitive);
      store(&out.entering[at], found[k].entering);
      store(&out.t[at], found[k].t);
      store(&out.error[at], found[k].error);
      const unsigned unclear = bits(doubt[k] | found[k].has_rival());
      const unsigned met = bits(mask(found[k].primitive != masks(k_no_primitive)));
      for (std::size_t i = 0; i < 4; ++i) {
        out.seen[at + i] = (unclear >> i & 1) != 0 ? Outlook::in_doubt
                           : (met >> i & 1) != 0   ? Outlook::surface
                                                   : Outlook::nothing;
      }
    }
  }
};

/// Is anything that casts a shadow in between?
template <bool k_filters>
struct BlockedSearch : Group {
  std::array<Lanes, k_vectors> distance;
  std::array<Mask, k_vectors> asked, blocked;
  std::array<Passed, k_filters ? k_group : 0> passed;
  bool all_known = false;

  LANCER_INLINE BlockedSearch(const Scenery& s, const ShadowsView& view, std::size_t from, Work& w)
      : Group(s, view.rays, from, w) {
    for (std::size_t k = 0; k < k_vectors; ++k) {
      asked[k] = load(&(*view.asked)[from + 4 * k]) & (probes[k].active | doubt[k]);
      probes[k].active &= asked[k];
      doubt[k] &= asked[k];
      distance[k] = load(&(*view.distance)[from + 4 * k]);
      blocked[k] = masks(0);
      go_out(view, k);
    }
  }

  LANCER_INLINE bool is_over() const { return all_known || is_too_much(); }
  LANCER_INLINE double limit() const { return most(distance); }
  LANCER_INLINE void ask_one(std::uint32_t primitive) {
    const Shade shade = scenery.shade[primitive];
    if (shade == Shade::none) return;
    ask(*this, primitive, [&](std::size_t k, const auto& surface, Crossings& c) {
      using Surface = std::remove_cvref_t<decltype(surface)>;
      Mask sure = surely_before(surface, probes[k], distance[k], c);
      if (shade == Shade::black) {
        blocked[k] |= sure;
      } else if constexpr (k_filters && k_is_solid<Surface>) {
        if (shade == Shade::unclear) c.doubt |= sure;
        sure &= ~c.doubt;
        const Mask twice = surely_through(surface, probes[k], distance[k], sure, c);
        pass(k, primitive, sure & ~c.doubt, twice, c);
      } else {
        c.doubt |= sure;
      }
      doubt[k] |= c.doubt;
      probes[k].active &= ~(blocked[k] | doubt[k]);
    });
    Mask left = masks(0);
    for (const Probes& p : probes) left |= p.active;
    all_known = !any(left);
  }
  LANCER_INLINE void ask_leaf(const std::uint32_t* item) {
    for (;; ++item) {
      ask_one(scenery.bounded[*item & ~k_last_item]);
      if (all_known || (*item & k_last_item) != 0) return;
    }
  }

  LANCER_INLINE void tell(const ShadowsSeen& out) const {
    for (std::size_t k = 0; k < k_vectors; ++k) {
      const std::size_t at = first + 4 * k;
      Mask lit = asked[k] & ~blocked[k] & ~doubt[k];
      if constexpr (k_filters) lit &= ~tell_passed(out, k);
      store(&(*out.lit)[at], lit);
      const unsigned sure = bits(blocked[k]), unclear = bits(doubt[k]);
      work.unclear += static_cast<unsigned>(std::popcount(bits(asked[k] & ~blocked[k] & ~lit)));
      for (std::size_t i = 0; i < 4; ++i) {
        (*out.seen)[at + i] = (sure >> i & 1) != 0      ? Outlook::surface
                              : (unclear >> i & 1) != 0 ? Outlook::in_doubt
                                                        : Outlook::nothing;
      }
    }
  }

 private:
  /// Which have gone through something.
  LANCER_INLINE Mask tell_passed(const ShadowsSeen& out, std::size_t k) const {
    Mask some = masks(0);
    for (std::size_t i = 0; i < 4; ++i) {
      passed[4 * k + i].tell(*out.filters, first + 4 * k + i);
      if (passed[4 * k + i].count > 0) some[static_cast<int>(i)] = -1;
    }
    return some;
  }

  /// The way out of what the rays start on.
  LANCER_INLINE void go_out(const ShadowsView& view, std::size_t k) {
    const std::size_t at = first + 4 * k;
    const unsigned exits = bits(load(&view.rays.starts->passes[at]) & probes[k].active);
    for (std::size_t i = 0; i < 4; ++i) {
      if ((exits >> i & 1) == 0) continue;
      Passed* const through = k_filters ? &passed[4 * k + i] : nullptr;
      const Outlook outlook = way_out_to_light(scenery, view, at + i, through);
      if (outlook == Outlook::nothing) continue;
      Mask& found = outlook == Outlook::surface ? blocked[k] : doubt[k];
      found[static_cast<int>(i)] = -1;
      probes[k].active[static_cast<int>(i)] = 0;
    }
  }

  /// Notes that rays go through the primitive; those that have gone through too many are in doubt.
  LANCER_INLINE void pass(std::size_t k, std::uint32_t primitive, Mask which, Mask twice, Crossings& c) {
    const unsigned some = bits(which), both = bits(twice);
    for (std::size_t i = 0; i < 4; ++i) {
      if ((some >> i & 1) == 0 || passed[4 * k + i].add(primitive, (both >> i & 1) != 0)) continue;
      c.doubt[static_cast<int>(i)] = -1;
    }
  }
};

/// False: given up, as the rays are faster one by one.
template <class Search>
LANCER_INLINE bool search_together(Search& search) {
  const Scenery& s = search.scenery;
  if (!search.begin()) return true;
  for (std::size_t i = 0; i < s.listed_count; ++i) search.ask_one(s.listed[i]);
  if (!s.nodes) return true;
  if (!search.is_over()) walk<GroupSlabs>(search, s.frames[0]);
  return !search.is_too_much();
}

}  // namespace lancer::tracer::LANCER_TARGET
