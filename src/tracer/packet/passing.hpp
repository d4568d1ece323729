#pragma once
// What shadow rays go through. Compiled in the namespace LANCER_TARGET.

#include "tracer/packet/seekers.hpp"

namespace lancer::tracer::LANCER_TARGET {

/// What one shadow ray has met so far of what lets light through.
struct Passed {
  std::array<std::uint32_t, Filters::k_most> crossed;
  std::uint8_t count = 0;

  /// False: that is one too many.
  LANCER_INLINE bool add(std::uint32_t primitive, bool twice) {
    if (count == Filters::k_most) return false;
    crossed[count++] = 2 * primitive + (twice ? 1 : 0);
    return true;
  }
  LANCER_INLINE void tell(Filters& out, std::size_t at) const {
    out.count[at] = count;
    if (count > 0) out.crossed[at] = crossed;
  }
};

/// A shadow ray's way out of the solid that it starts on; null: nothing lets light through.
LANCER_INLINE Outlook way_out_to_light(const Scenery& s, const ShadowsView& view, std::size_t i,
                                       Passed* passed) {
  const Exits& exits = *view.rays.exits;
  const std::uint32_t primitive = primitive_of(exits.primitive[i]);
  const Shade shade = s.shade[primitive];
  const double t = exits.t[i], error = exits.error[i], distance = (*view.distance)[i];
  if (shade == Shade::none || t - error >= distance) return Outlook::nothing;
  if (!(t + error < distance) || shade == Shade::unclear) return Outlook::in_doubt;
  if (shade == Shade::black) return Outlook::surface;
  if (passed) passed->add(primitive, false);
  return Outlook::nothing;
}

}  // namespace lancer::tracer::LANCER_TARGET
