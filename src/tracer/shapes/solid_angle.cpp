#include "tracer/shapes/solid_angle.hpp"

#include "base/math.hpp"
#include "tracer/exact.hpp"
#include "tracer/shapes/rim.hpp"

namespace lancer::tracer {
namespace {

using ExactVec = Triple<Exact>;
using WideVec = Triple<Wide>;

/// The tangent of half a solid angle as a quotient (van Oosterom and Strackee 1983), from directions of unit
/// length.
struct HalfTangent {
  double numerator = 0, denominator = 0;

  HalfTangent(Vec3 a, Vec3 b, Vec3 c)
      : numerator(dot(a, cross(b, c))), denominator(1 + dot(a, b) + dot(b, c) + dot(c, a)) {}

  /// Within 2^-25 of a turn? Its terms are off by less than 2^-48.
  bool is_certain() const {
    const bool far_from_edges = std::fabs(numerator) + std::fabs(denominator) > 0x1p-20;
    return far_from_edges && (denominator > 0 || std::fabs(numerator) > 0x1p-40);
  }
  double turns() const { return math::atan2_deg(numerator, denominator) / 360; }
};

WideVec unit(const WideVec& v) { return v * (Wide(1) / sqrt(dot(v, v))); }

/// With the numerator's sign as given.
double wide_turns(const WideVec& a, const WideVec& b, const WideVec& c, int sign) {
  if (sign == 0) return 0;
  const Wide numerator = abs(dot(a, cross(b, c)));
  const Wide denominator = Wide(1) + dot(a, b) + dot(b, c) + dot(c, a);
  const double turns =
      Wide(atan2(numerator, denominator) / atan2(Wide(0), Wide(-1)) / 2).convert_to<double>();
  return sign < 0 ? -turns : turns;
}

bool is_zero(const ExactVec& v) { return v.x.sign() == 0 && v.y.sign() == 0 && v.z.sign() == 0; }

/// d, moved as rim.hpp has it, far enough for 192 bits to tell.
WideVec moved(const ExactVec& d) {
  WideVec v = unit(wide(d));
  v.x += ldexp(Wide(1), -60);
  v.y += ldexp(Wide(1), -120);
  return unit(v);
}

[[gnu::noinline, gnu::cold]] double careful_sector(Vec3 p, Vec3 direction, Vec3 to_b, Vec3 to_c) {
  const ExactVec d = exact(direction), b = exact(to_b) - exact(p), c = exact(to_c) - exact(p);
  const ExactVec n = cross(b, c);
  if (is_zero(n)) return 0;  // p is on the edge
  int sign = -dot(d, n).sign();
  if (sign == 0) sign = -sign_beside(n.x, n.y, n.z);
  const WideVec back = moved(d) * Wide(-1);
  return wide_turns(back, unit(wide(b)), unit(wide(c)), sign);
}

/// What the part of the facet between p and the edge from b to c fills, were it to go on for ever.
double sector(Vec3 p, Vec3 direction, Vec3 b, Vec3 c) {
  const HalfTangent half(-direction, normalize(b - p), normalize(c - p));
  const bool corner = b == p || c == p;
  return !corner && half.is_certain() ? half.turns() : careful_sector(p, direction, b, c);
}

/// Is p, in the plane of the facet, not outside of the edge from b to c? n is the facet's normal.
bool is_within(const ExactVec& b, const ExactVec& c, const ExactVec& n) {
  const ExactVec m = cross(b, c);
  const auto opposite = [](const Exact& x, const Exact& y) { return x.sign() * y.sign() < 0; };
  return !opposite(m.x, n.x) && !opposite(m.y, n.y) && !opposite(m.z, n.z);
}

[[gnu::noinline, gnu::cold]] Seen careful_seen_from(const FacetPrimitive& facet, Vec3 p) {
  const ExactVec at = exact(p);
  const ExactVec a = exact(facet.a) - at, b = exact(facet.b) - at, c = exact(facet.c) - at;
  const int sign = dot(a, cross(b, c)).sign();
  if (sign != 0) return {false, wide_turns(unit(wide(a)), unit(wide(b)), unit(wide(c)), sign)};
  const ExactVec n = cross(b - a, c - a);
  return {is_within(a, b, n) && is_within(b, c, n) && is_within(c, a, n), 0};
}

}  // namespace

Seen seen_from(const FacetPrimitive& facet, Vec3 p) {
  const HalfTangent half(normalize(facet.a - p), normalize(facet.b - p), normalize(facet.c - p));
  const bool corner = facet.a == p || facet.b == p || facet.c == p;
  Seen seen = half.is_certain() && !corner ? Seen{false, half.turns()} : careful_seen_from(facet, p);
  if (facet.flipped) seen.turns = -seen.turns;
  return seen;
}

double turns_ahead(const FacetPrimitive& facet, Vec3 p, Vec3 direction) {
  const double turns = sector(p, direction, facet.a, facet.b) + sector(p, direction, facet.b, facet.c) +
                       sector(p, direction, facet.c, facet.a);
  return facet.flipped ? -turns : turns;
}

}  // namespace lancer::tracer
