#pragma once
// What landings compute in twice the precision, four hits side by side: see shapes/lanes.hpp, where it is the
// components of one. Compiled in the namespace LANCER_TARGET.

#include "tracer/packet/vectors.hpp"

namespace lancer::tracer::LANCER_TARGET {

/// A distance as an unevaluated sum, and how far it may be off; see Distance.
struct Distances {
  Lanes hi, lo, error;

  LANCER_INLINE void add(Lanes correction, Mask where) {
    const Sum<Lanes> s = exact_sum(hi, lo + correction);
    hi = select(where, s.hi, hi);
    lo = select(where, s.lo, lo);
  }
};

LANCER_INLINE Twice advance(Lanes from, Lanes from_low, Lanes d, const Distances& t) {
  const Sum<Lanes> way = exact_product(t.hi, d);
  const Sum<Lanes> s = exact_sum(from, way.hi);
  return {s.hi, s.lo + (way.lo + t.lo * d + from_low)};
}
LANCER_INLINE Vectors2 advance(const Vectors2& from, const Vectors& d, const Distances& t) {
  const Twice x = advance(from.hi.x, from.lo.x, d.x, t), y = advance(from.hi.y, from.lo.y, d.y, t),
              z = advance(from.hi.z, from.lo.z, d.z, t);
  return {{x.hi, y.hi, z.hi}, {x.lo, y.lo, z.lo}};
}
LANCER_INLINE Vectors advance_error(const Vectors& from, const Vectors& d, const Distances& t) {
  const Lanes far = abs(t.hi), part = lanes(8 * k_u * k_u);
  const auto of = [&](Lanes f, Lanes c) { return (abs(f) + abs(c) * far) * part + abs(c) * t.error; };
  return {of(from.x, d.x), of(from.y, d.y), of(from.z, d.z)};
}
LANCER_INLINE Lanes advance_bound(Lanes reach, const Distances& t) {
  return (reach + abs(t.hi)) * lanes(8 * k_u * k_u) + t.error;
}

/// from + v.hi + v.lo.
LANCER_INLINE Vectors moved(const Vectors& from, const Vectors2& v) {
  const auto of = [](Lanes f, Lanes hi, Lanes lo) {
    const Sum<Lanes> s = exact_sum(f, hi);
    return s.hi + (s.lo + lo);
  };
  return {of(from.x, v.hi.x, v.lo.x), of(from.y, v.hi.y, v.lo.y), of(from.z, v.hi.z, v.lo.z)};
}

/// As settles().
LANCER_INLINE Mask settle(const Distances& t) {
  return is_finite(t.hi) & mask(t.error <= greater(abs(t.hi), lanes(0.0)) * lanes(k_u / 16));
}
LANCER_INLINE Mask settle(const Vectors& value, const Vectors& error) {
  const Lanes enough = sum_abs(value) * lanes(0x1p-41);
  const auto of = [&](Lanes v, Lanes e) { return mask(e <= greater(abs(v), enough) * lanes(k_u / 16)); };
  return of(value.x, error.x) & of(value.y, error.y) & of(value.z, error.z);
}
LANCER_INLINE Mask settle(const Vectors& value, Lanes error) {
  const Lanes least = lesser(abs(value.x), lesser(abs(value.y), abs(value.z)));
  return mask(error <= greater(least, sum_abs(value) * lanes(0x1p-41)) * lanes(k_u / 16));
}

/// The sum of four products, the last of plain numbers; see total().
LANCER_INLINE Twice total(const Vectors2& a, const Vectors2& b, Lanes a_more, Lanes b_more) {
  const auto low_of = [](Lanes product_low, Lanes ahi, Lanes alo, Lanes bhi, Lanes blo) {
    return product_low + (ahi * blo + alo * bhi) + alo * blo;
  };
  const Sum<Lanes> x = exact_product(a.hi.x, b.hi.x), y = exact_product(a.hi.y, b.hi.y),
                   z = exact_product(a.hi.z, b.hi.z), more = exact_product(a_more, b_more);
  const Lanes low_x = low_of(x.lo, a.hi.x, a.lo.x, b.hi.x, b.lo.x);
  const Lanes low_y = low_of(y.lo, a.hi.y, a.lo.y, b.hi.y, b.lo.y);
  const Lanes low_z = low_of(z.lo, a.hi.z, a.lo.z, b.hi.z, b.lo.z);
  const Sum<Lanes> even = exact_sum(x.hi, z.hi), odd = exact_sum(y.hi, more.hi);
  const Sum<Lanes> all = exact_sum(even.hi, odd.hi);
  return {all.hi, all.lo + (even.lo + odd.lo) + ((low_x + low_z) + (low_y + more.lo))};
}

}  // namespace lancer::tracer::LANCER_TARGET
