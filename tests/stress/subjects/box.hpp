#pragma once
// Boxes to aim at, along the axes and turned, and the rays that come close to their edges and corners.

#include <functional>

#include "base/transform.hpp"
#include "stress/contest/field.hpp"

namespace lancer::stress::flat {

/// A box as it is put into a scene, in coordinates q that are -1 to 1 across it.
struct PlacedBox {
  Vec3 lo, hi;
  Affine map;

  Vec3 point(Vec3 q) const;
  Vec3 vector(Vec3 q) const;
  double largest() const;
  double smallest() const;
  /// A distance that is ordinary for it: 2 to 10 of its largest or of its smallest size.
  double distance(Random& random) const;
};

enum class Style { aligned, aligned_uneven, turned, uneven, nested };
constexpr Style k_styles[] = {Style::aligned, Style::aligned_uneven, Style::turned, Style::uneven,
                              Style::nested};

const char* name_of(Style style);

/// About one unit across, unless uneven; then moved by `away` in a random direction, then scaled.
PlacedBox any_box(Style style, Random& random, double scale = 1, double away = 0);

/// At it or past it, from an ordinary distance.
Line past(const PlacedBox& box, Random& random);

enum class Where { silhouette, front_edge, corner };

/// Past or onto an edge or a corner, off it by `offset` of the box.
Line at_rim(const PlacedBox& box, Where where, double offset, Random& random);

/// A mixture that every placement of a box is tried with.
Line common_ray(const PlacedBox& box, Random& random);

Subject subject(const PlacedBox& box, std::function<Line(Random&)> ray);

}  // namespace lancer::stress::flat
