#include "stress/subjects/cancelling.hpp"

#include <boost/multiprecision/cpp_int.hpp>

namespace lancer::stress::flat {
namespace {

using Whole = boost::multiprecision::cpp_int;

/// x with x a = 1 modulo b, both without a common divisor; 0: they have one.
Whole inverse_of(Whole a, Whole b) {
  Whole x = 1, next = 0;
  while (b != 0) {
    const Whole times = a / b, rest = a - times * b, after = x - times * next;
    a = b;
    b = rest;
    x = next;
    next = after;
  }
  return a == 1 ? x : 0;
}

}  // namespace

// With whole numbers d = (x, y, z 2^-s) 2^-53 this asks for x a + y b + z c 2^-s = target 2^-s: c follows
// modulo 2^s, then a modulo y, then b.
Across all_but_orthogonal(Random& random, int target) {
  constexpr int k_digits = 53;
  for (;;) {
    const double along = random.between(0.69, 0.73), beside = random.between(0.69, 0.73);
    const Vec3 d = normalize(Vec3{along, beside, random.between(0.55, 0.9) * 0x1p-24});
    const int s = -1 - std::ilogb(d.z);
    const auto x = static_cast<std::uint64_t>(std::ldexp(d.x, k_digits));
    const auto y = static_cast<std::uint64_t>(std::ldexp(d.y, k_digits));
    const auto z = static_cast<std::uint64_t>(std::ldexp(d.z, k_digits + s));
    const Whole inverse = inverse_of(x, y);
    if (z % 2 == 0 || inverse == 0) continue;
    std::uint64_t inverse_z = z;  // modulo 8, then modulo 2^6, 2^12, ...
    for (int i = 0; i < 5; ++i) inverse_z *= 2 - z * inverse_z;
    const std::uint64_t low = static_cast<std::uint64_t>(target) * inverse_z & ((std::uint64_t{1} << s) - 1);
    const std::uint64_t c = low + (random.bits() >> (64 - 52 + s) << s);
    const Whole sum = (Whole(target) - Whole(z) * c) / (Whole(1) << s);
    Whole a = inverse * sum % y;
    if (a < 0) a += y;
    const Whole b = (sum - a * x) / y;
    if (abs(b) >= (Whole(1) << k_digits)) continue;
    return {{a.convert_to<double>(), b.convert_to<double>(), static_cast<double>(c)}, d};
  }
}

}  // namespace lancer::stress::flat
