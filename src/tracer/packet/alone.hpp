#pragma once
// Single rays, for which four primitives are asked at a time. Compiled in the namespace LANCER_TARGET.

#include "tracer/packet/passing.hpp"
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
    start.set_none();
    if (!view.starts) return;
    start.primitive = masks(view.starts->primitive[i]);
    start.shape = masks(view.starts->shape[i]);
    start.rise = lanes(view.starts->rise[i]);
    start.error = lanes(view.starts->error[i]);
    if (!view.open) return;
    const OpenRow& row = view.open[view.starts->open[i]];
    if (!row.is_whole) doubt = masks(-1);
    for (std::size_t k = 0; k < OpenRow::k_most && row.shape[k] >= 0; ++k) {
      start.open[k] = masks(row.shape[k]);
      start.most_open = k + 1;
    }
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
      const std::uint32_t record = s.primitives[primitive].record;
      if (kind == Kind::plane) {
        ask_batch(search, s.planes[record], one, there);
      } else if (kind == Kind::box) {
        ask_batch(search, s.boxes[record], one, there);
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
      : Lone(s, view, i, w) {
    if (!view.starts || view.starts->passes[i] == 0) return;
    const Mask lane = Mask{-1, 0, 0, 0};
    found.begin(lane, masks(view.exits->primitive[i]), lanes(view.exits->t[i]), lanes(view.exits->error[i]));
  }

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

template <bool k_filters>
struct LoneBlocked : Lone {
  Lanes distance;
  Mask blocked = masks(0);
  Passed passed;

  LANCER_INLINE LoneBlocked(const Scenery& s, const ShadowsView& view, std::size_t i, Work& w)
      : Lone(s, view.rays, i, w), distance(lanes((*view.distance)[i])) {
    if (view.rays.starts->passes[i] == 0) return;
    const Outlook outlook = way_out_to_light(s, view, i, k_filters ? &passed : nullptr);
    if (outlook == Outlook::surface) blocked = masks(-1);
    if (outlook == Outlook::in_doubt) doubt = masks(-1);
  }

  LANCER_INLINE bool ignores(std::uint32_t primitive) const {
    return scenery.shade[primitive] == Shade::none;
  }
  LANCER_INLINE bool is_over() const { return any(blocked); }
  LANCER_INLINE double limit() const { return distance[0]; }
  template <class Surface>
  LANCER_INLINE void take(const Surface& surface, Mask ids, Crossings& c) {
    const Mask sure = surely_before(surface, probes, distance, c);
    Mask black = masks(-1);
    if constexpr (k_filters) black = pass(surface, ids, sure, c);
    blocked |= sure & black;
    doubt |= c.doubt;
  }
  LANCER_INLINE void ask_leaf(const std::uint32_t* item) { ask_items(*this, item); }

  LANCER_INLINE void tell(const ShadowsSeen& out, std::size_t at) const {
    (*out.seen)[at] = any(blocked) ? Outlook::surface : any(doubt) ? Outlook::in_doubt : Outlook::nothing;
    if constexpr (k_filters) passed.tell(*out.filters, at);
    const bool clear = !any(blocked) && !any(doubt) && !(k_filters && passed.count > 0);
    (*out.lit)[at] = clear ? -1 : 0;
    work.unclear += !any(blocked) && !clear ? 1 : 0;
  }

 private:
  /// Notes the solids that the ray goes through; those that let nothing through are returned.
  template <class Surface>
  LANCER_INLINE Mask pass(const Surface& surface, Mask ids, Mask sure, Crossings& c) {
    Mask black = masks(0), filters = masks(0);
    for (int i = 0; i < 4; ++i) {
      const Shade shade = scenery.shade[ids[i]];
      if (shade == Shade::black) black[i] = -1;
      if (shade == Shade::filtered) filters[i] = -1;
    }
    c.doubt |= sure & ~(black | filters);
    const Mask through = sure & filters;
    if (!any(through)) return black;
    if constexpr (k_is_solid<Surface>) {
      const unsigned twice = bits(surely_through(surface, probes, distance, through, c));
      const unsigned some = bits(through & ~c.doubt);
      for (int i = 0; i < 4; ++i) {
        if ((some >> i & 1) == 0) continue;
        if (!passed.add(static_cast<std::uint32_t>(ids[i]), (twice >> i & 1) != 0)) c.doubt[i] = -1;
      }
    } else {
      c.doubt |= through;
    }
    return black;
  }
};

/// Searches for ray i of a view, and tells.
struct ClosestAlone {
  const Scenery& scenery;
  const RaysView& view;
  FirstHits& out;
  Work& work;

  void operator()(std::size_t i) const {
    if (view.starts && view.starts->passes[i] != 0 && view.exits->known[i] == 0) {
      out.seen[i] = Outlook::in_doubt;
      return;
    }
    LoneClosest search(scenery, view, i, work);
    search_alone(search);
    search.tell(out, i);
  }
};
template <bool k_filters>
struct BlockedAlone {
  const Scenery& scenery;
  const ShadowsView& view;
  const ShadowsSeen& out;
  Work& work;

  void operator()(std::size_t i) const {
    (*out.lit)[i] = 0;
    if ((*view.asked)[i] == 0) return;
    if (view.rays.starts->passes[i] != 0 && view.rays.exits->known[i] == 0) {
      (*out.seen)[i] = Outlook::in_doubt;
      ++work.unclear;
      return;
    }
    LoneBlocked<k_filters> search(scenery, view, i, work);
    search_alone(search);
    search.tell(out, i);
  }
};

}  // namespace lancer::tracer::LANCER_TARGET
