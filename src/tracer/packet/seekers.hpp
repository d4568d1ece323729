#pragma once
// What searches find out, for four lanes: one of a ray each, or all four of one ray. Compiled in the
// namespace LANCER_TARGET.

#include <algorithm>
#include <bit>

#include "tracer/packet/meet.hpp"
#include "tracer/packet/meet_box.hpp"
#include "tracer/tree/walk.hpp"

namespace lancer::tracer::LANCER_TARGET {

/// Where rays start.
struct Start {
  Mask primitive, shape;
  Lanes rise, error;
  std::array<Mask, OpenRow::k_most> open;  // as many as are used
  std::size_t most_open;

  LANCER_INLINE void set_none() {
    primitive = shape = masks(k_no_primitive);
    rise = error = lanes(0.0);
    most_open = 0;
  }

  /// Those that are inside of too many are returned.
  LANCER_INLINE Mask set_open(const RaysView& view, std::size_t at) {
    const Mask rows = load(&view.starts->open[at]);
    if (!any(rows != masks(0))) return masks(0);
    Mask too_many = masks(0);
    for (int i = 0; i < 4; ++i) {
      const OpenRow& row = view.open[rows[i]];
      if (!row.is_whole) too_many[i] = -1;
      for (std::size_t k = 0; k < OpenRow::k_most; ++k) {
        open[k][i] = row.shape[k];
        if (row.shape[k] >= 0) most_open = std::max(most_open, k + 1);
      }
    }
    return too_many;
  }

  LANCER_INLINE Mask is_inside(std::uint32_t asked_shape) const {
    Mask inside = masks(0);
    for (std::size_t i = 0; i < most_open; ++i) inside |= mask(open[i] == masks(asked_shape));
    return inside;
  }

  /// Next to its start a ray that leaves a mesh may meet it where is_echo() has to tell, and any closed mesh,
  /// or a convex solid that it seems to start in, where ahead() has to: those crossings are in doubt.
  LANCER_INLINE void doubt_near(const Scenery& s, std::uint32_t asked, const Facets&, Mask where,
                                Crossings& c) const {
    const Mask same = mask(shape == masks(s.primitives[asked].shape));
    const Mask echo = c.met & same & ~mask((c.t - c.error) * rise > error);
    const Mask near = c.crossed & mask((abs(c.t) - c.error) * abs(c.slope) <= error);
    leave_open(where & (echo | (near & mask(error != lanes(0.0)))), c);
  }
  LANCER_INLINE void doubt_near(const Scenery&, std::uint32_t, const PlanePrimitive&, Mask,
                                Crossings&) const {}
  template <class ConvexSolid>
  LANCER_INLINE void doubt_near(const Scenery& s, std::uint32_t asked, const ConvexSolid&, Mask where,
                                Crossings& c) const {
    const Mask rounded = where & mask(error != lanes(0.0));
    Mask unclear = c.met & ~c.entering & ~mask(c.clear > error);
    if (most_open > 0) {
      // Of a solid that it is inside of it meets the way out, wherever that seems to be.
      const Mask inside = is_inside(s.primitives[asked].shape);
      unclear = select(inside, c.crossed & (c.entering | ~c.met), unclear);
    }
    leave_open(rounded & unclear, c);
  }

 private:
  LANCER_INLINE static void leave_open(Mask which, Crossings& c) {
    c.met &= ~which;
    c.doubt |= which;
  }
};

/// The first surface: that whose crossing surely lies before all others.
struct First {
  Lanes t = lanes(0.0), error = lanes(0.0);
  Lanes low = lanes(k_infinity), high = lanes(k_infinity);  // the bounds of its distance
  Lanes rival = lanes(k_infinity);                          // the least lower bound of all others
  Mask primitive = masks(k_no_primitive), entering = masks(0);

  LANCER_INLINE void take(Mask which, const Crossings& c) {
    const Lanes c_low = c.t - c.error, c_high = c.t + c.error;
    const Mask better = c.met & mask(c_high < high);
    rival = lesser(rival, select(better, low, select(c.met, c_low, lanes(k_infinity))));
    low = select(better, c_low, low);
    high = select(better, c_high, high);
    t = select(better, c.t, t);
    error = select(better, c.error, error);
    primitive = select(better, which | c.face, primitive);
    entering = select(better, c.entering, entering);
  }
  /// What it starts on and leaves by an exit, before anything else was asked.
  LANCER_INLINE void begin(Mask where, Mask which, Lanes exit_t, Lanes exit_error) {
    t = select(where, exit_t, t);
    error = select(where, exit_error, error);
    low = select(where, exit_t - exit_error, low);
    high = select(where, exit_t + exit_error, high);
    primitive = select(where, which, primitive);
  }
  LANCER_INLINE Mask has_rival() const { return mask(rival <= high) & mask(rival < lanes(k_infinity)); }
};

/// Which of the crossings surely lie before the light and count; where that is open they are in c.doubt.
template <class Surface>
LANCER_INLINE Mask surely_before(const Surface& surface, const Probes& p, Lanes distance, Crossings& c) {
  const Mask may = c.met & ~mask(c.t - c.error >= distance);
  Mask sure = may & mask(c.t + c.error < distance);
  if (any(sure)) {
    // Where the crossing lies within the surface's own bounds, within() leaves it where it is.
    const Intervals own = own_interval(surface, p);
    sure &= mask(own.enter <= c.t) & mask(c.t <= own.leave);
  }
  c.doubt |= may & ~sure;
  return sure;
}

/// Of crossings that surely lie before the light: where the ray goes out again before it, too. Where that is
/// open, or the two might be at one place, they are in c.doubt.
template <class Surface>
LANCER_INLINE Mask surely_through(const Surface& surface, const Probes& p, Lanes distance, Mask sure,
                                  Crossings& c) {
  const Mask may = sure & c.entering & ~mask(c.out_t - c.out_error >= distance);
  Mask through = may & mask(c.out_t + c.out_error < distance) & mask(c.t + c.error < c.out_t - c.out_error);
  if (any(through)) {
    const Intervals own = own_interval(surface, p);
    through &= mask(own.enter <= c.out_t) & mask(c.out_t <= own.leave);
  }
  c.doubt |= may & ~through;
  return through;
}

/// Kinds whose two crossings are known together.
template <class Surface>
inline constexpr bool k_is_solid = false;
template <>
inline constexpr bool k_is_solid<Spheres> = true;
template <>
inline constexpr bool k_is_solid<BoxPrimitive> = true;

/// A child that rays may meet, and where: as one number, so that the nearest is the least.
class Waiting {
 public:
  Waiting() = default;
  LANCER_INLINE Waiting(float enter, Child child)
      : bits_(std::uint64_t{std::bit_cast<std::uint32_t>(std::max(enter, 0.0F))} << 32 | child.bits()) {}
  LANCER_INLINE float enter() const { return std::bit_cast<float>(static_cast<std::uint32_t>(bits_ >> 32)); }
  LANCER_INLINE Child child() const { return Child(static_cast<std::uint32_t>(bits_)); }
  LANCER_INLINE bool operator<(Waiting other) const { return bits_ < other.bits_; }

 private:
  std::uint64_t bits_;
};

/// Goes through the tree, nearest first. Slabs tell which children are met; the search sees to leaves, tells
/// how far it looks, and when it is over.
template <class Slabs, class Search>
void walk(Search& search, const Frame& frame) {
  const Scenery& s = search.scenery;
  const Slabs slabs(frame, search.probe());
  std::array<Waiting, (k_width - 1) * k_max_depth + 1> stack;
  std::size_t size = 0;
  float limit = slabs.limit(search.limit());
  Child at = Child::node(frame.root);
  for (;;) {
    if (at.is_node()) {
      search.count_node();
      const Node& node = s.nodes[at.index()];
      alignas(32) std::array<float, k_width> enter;
      unsigned hits = slabs.meets(node, limit, enter.data());
      const std::size_t bottom = size;
      while (hits != 0) {
        const auto i = static_cast<std::size_t>(std::countr_zero(hits));
        hits &= hits - 1;
        const Waiting next(enter[i], node.children[i]);
        std::size_t place = size++;
        for (; place != bottom && stack[place - 1] < next; --place) stack[place] = stack[place - 1];
        stack[place] = next;
      }
    } else {
      if (at.is_leaf()) {
        search.ask_leaf(s.items + at.index());
      } else {
        walk<Slabs>(search, s.frames[at.index()]);
      }
      if (search.is_over()) return;
      limit = slabs.limit(search.limit());
    }
    do {
      if (size == 0) return;
      --size;
    } while (stack[size].enter() > std::max(limit, 0.0F));
    at = stack[size].child();
  }
}

/// Calls ask(surface, primitive) with the primitive as the kernels know it, once for four lanes.
template <class Ask>
LANCER_INLINE void with_surface(const Scenery& s, std::uint32_t primitive, const Ask& ask) {
  const Primitive p = s.primitives[primitive];
  switch (p.kind) {
    case Kind::sphere: return ask(four_times(s.spheres[p.record]));
    case Kind::plane: return ask(s.planes[p.record]);
    case Kind::facet: return ask(four_times(s.facets[p.record]));
    case Kind::box: return ask(s.boxes[p.record]);
    case Kind::ellipsoid: return ask(Other{*s.world, primitive});
  }
}

}  // namespace lancer::tracer::LANCER_TARGET
