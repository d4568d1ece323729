#pragma once
// Single rays, for which four primitives are asked at a time. Compiled in the namespace LANCER_TARGET.

#include "tracer/packet/seekers.hpp"
#include "tracer/tree/slabs8.hpp"
#include "tracer/tree/walk.hpp"

namespace lancer::tracer::LANCER_TARGET {

/// What all searches of one ray have.
struct Lone {
  const Scenery& scenery;
  Work& work;
  Probe own;
  Probes probes;  // four times the ray
  Start start;
  Mask doubt = masks(0);

  LANCER_INLINE Lone(const Scenery& s, const RaysView& view, std::size_t i, Work& w)
      : scenery(s), work(w), own((*view.origin)[i], (*view.direction)[i]) {
    probes.origin = vectors(own.origin);
    probes.direction = vectors(own.direction);
    probes.inverse = vectors(own.inverse);
    probes.active = masks(-1);
    probes.kx = own.kx;
    probes.ky = own.ky;
    probes.kz = own.kz;
    probes.shear_x = lanes(own.shear_x);
    probes.shear_y = lanes(own.shear_y);
    start = {masks(k_no_primitive), masks(k_no_primitive), lanes(0.0), lanes(0.0)};
    if (!view.starts) return;
    start = {masks(view.starts->primitive[i]), masks(view.starts->shape[i]), lanes(view.starts->rise[i]),
             lanes(view.starts->error[i])};
  }

  LANCER_INLINE const Probe& probe() const { return own; }
  LANCER_INLINE void count_node() { ++work.node_visits; }
};

/// Up to four primitives of a kind.
struct Batch {
  alignas(16) std::array<std::uint32_t, 4> primitive;
  std::size_t count = 0;

  LANCER_INLINE void add(std::uint32_t p) { primitive[count++] = p; }
  /// Those that are there; the other lanes have the first again.
  LANCER_INLINE Mask fill() {
    for (std::size_t i = count; i < 4; ++i) primitive[i] = primitive[0];
    return mask(Mask{0, 1, 2, 3} < masks(static_cast<long long>(count)));
  }
  LANCER_INLINE Mask ids() const { return Mask{primitive[0], primitive[1], primitive[2], primitive[3]}; }
};

template <class Search, class Surface>
LANCER_INLINE void ask_batch(Search& search, const Surface& surface, const Batch& batch, Mask there) {
  const Mask ids = batch.ids();
  const Mask asked = there & ~mask(ids == search.start.primitive);
  Crossings c{};
  if (!any(asked) || !meet(surface, search.probes, asked, c)) return;
  for (int i = 0; i < static_cast<int>(batch.count); ++i) {
    Mask lane = masks(0);
    lane[i] = -1;
    search.start.doubt_near(search.scenery, batch.primitive[static_cast<std::size_t>(i)], surface, lane, c);
  }
  search.take(surface, ids, c);
}

/// Asks the list's primitives, up to one marked as the last, or `count` of them.
template <class Search, class Get>
LANCER_INLINE void ask_list(Search& search, const Get& get) {
  const Scenery& s = search.scenery;
  Batch round, flat;
  const auto ask_round = [&] {
    if (round.count == 0) return;
    const Mask there = round.fill();
    ask_batch(search, spheres(s, round.primitive.data()), round, there);
    round.count = 0;
  };
  const auto ask_flat = [&] {
    if (flat.count == 0) return;
    const Mask there = flat.fill();
    ask_batch(search, facets(s, flat.primitive.data()), flat, there);
    flat.count = 0;
  };
  std::uint32_t primitive = 0;
  for (std::size_t i = 0; get(i, primitive); ++i) {
    if (search.ignores(primitive)) continue;
    ++search.work.shape_tests;
    const Kind kind = s.primitives[primitive].kind;
    if (kind == Kind::sphere) {
      round.add(primitive);
      if (round.count == 4) ask_round();
    } else if (kind == Kind::facet) {
      flat.add(primitive);
      if (flat.count == 4) ask_flat();
    } else {
      Batch one;
      one.add(primitive);
      const Mask there = one.fill();
      if (kind == Kind::plane) {
        ask_batch(search, s.planes[s.primitives[primitive].record], one, there);
      } else {
        ask_batch(search, Other{*s.world, primitive}, one, there);
      }
    }
  }
  ask_round();
  ask_flat();
}

template <class Search>
LANCER_INLINE void ask_items(Search& search, const std::uint32_t* item) {
  bool is_last = false;
  ask_list(search, [&](std::size_t i, std::uint32_t& primitive) {
    if (is_last) return false;
    primitive = search.scenery.bounded[item[i] & ~k_last_item];
    is_last = (item[i] & k_last_item) != 0;
    return true;
  });
}

template <class Search>
LANCER_INLINE void search_alone(Search& search) {
  const Scenery& s = search.scenery;
  ask_list(search, [&](std::size_t i, std::uint32_t& primitive) {
    if (i == s.listed_count) return false;
    primitive = s.listed[i];
    return true;
  });
  if (s.nodes && !search.is_over()) walk<Slabs8>(search, s.frames[0]);
}

struct LoneClosest : Lone {
  First found;

  LANCER_INLINE LoneClosest(const Scenery& s, const RaysView& view, std::size_t i, Work& w)
      : Lone(s, view, i, w) {}

  LANCER_INLINE bool ignores(std::uint32_t) const { return false; }
  LANCER_INLINE bool is_over() const { return false; }
  LANCER_INLINE double limit() const {
    return std::min(std::min(found.high[0], found.high[1]), std::min(found.high[2], found.high[3]));
  }
  template <class Surface>
  LANCER_INLINE void take(const Surface&, Mask ids, const Crossings& c) {
    doubt |= c.doubt;
    found.take(ids, c);
  }
  LANCER_INLINE void ask_leaf(const std::uint32_t* item) { ask_items(*this, item); }

  LANCER_INLINE void tell(FirstHits& out, std::size_t at) const {
    int best = 0;
    for (int i = 1; i < 4; ++i) best = found.high[i] < found.high[best] ? i : best;
    double rival = k_infinity;
    for (int i = 0; i < 4; ++i)
      rival = std::min(rival, i == best ? found.rival[i] : std::min(found.rival[i], found.low[i]));
    out.primitive[at] = found.primitive[best];
    out.entering[at] = found.entering[best];
    out.t[at] = found.t[best];
    out.error[at] = found.error[best];
    const bool unclear = any(doubt) || (rival <= found.high[best] && rival < k_infinity);
    out.seen[at] = unclear                                   ? Outlook::in_doubt
                   : found.primitive[best] != k_no_primitive ? Outlook::surface
                                                             : Outlook::nothing;
  }
};

struct LoneBlocked : Lone {
  Lanes distance;
  Mask blocked = masks(0);

  LANCER_INLINE LoneBlocked(const Scenery& s, const ShadowsView& view, std::size_t i, Work& w)
      : Lone(s, view.rays, i, w), distance(lanes((*view.distance)[i])) {}

  LANCER_INLINE bool ignores(std::uint32_t primitive) const {
    return scenery.shade[primitive] == Shade::none;
  }
  LANCER_INLINE bool is_over() const { return any(blocked); }
  LANCER_INLINE double limit() const { return distance[0]; }
  template <class Surface>
  LANCER_INLINE void take(const Surface& surface, Mask ids, Crossings& c) {
    Mask filtered = masks(0);
    for (int i = 0; i < 4; ++i) {
      // One that lets light through is no answer here.
      if (scenery.shade[ids[i]] == Shade::filtered) filtered[i] = -1;
    }
    const Mask met = c.met;
    c.met &= ~filtered;
    blocked |= surely_black(Shade::black, surface, probes, distance, c);
    c.met = met & filtered;
    surely_black(Shade::filtered, surface, probes, distance, c);
    doubt |= c.doubt;
  }
  LANCER_INLINE void ask_leaf(const std::uint32_t* item) { ask_items(*this, item); }

  LANCER_INLINE void tell(Column<Outlook>& seen, std::size_t at) const {
    seen[at] = any(blocked) ? Outlook::surface : any(doubt) ? Outlook::in_doubt : Outlook::nothing;
  }
};

/// Searches for ray i of a view, and tells.
struct ClosestAlone {
  const Scenery& scenery;
  const RaysView& view;
  FirstHits& out;
  Work& work;

  void operator()(std::size_t i) const {
    if (view.starts && view.starts->passes[i] != 0) {
      out.seen[i] = Outlook::in_doubt;
      return;
    }
    LoneClosest search(scenery, view, i, work);
    search_alone(search);
    search.tell(out, i);
  }
};
struct BlockedAlone {
  const Scenery& scenery;
  const ShadowsView& view;
  Column<Outlook>& out;
  Work& work;

  void operator()(std::size_t i) const {
    if ((*view.asked)[i] == 0) return;
    if (view.rays.starts->passes[i] != 0) {
      out[i] = Outlook::in_doubt;
      return;
    }
    LoneBlocked search(scenery, view, i, work);
    search_alone(search);
    search.tell(out, i);
  }
};

}  // namespace lancer::tracer::LANCER_TARGET
