#pragma once
// Signs of polynomials in doubles, without any doubt: MPFR tells whether a single operation rounded. Where
// one did, everything is done again with room for all bits of any doubles.

#include "stress/truth/number.hpp"

namespace lancer::stress::flat {

/// Room for every bit of a sum of products of four doubles: 4 (2 * 1074) and what is carried.
using Wide = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<2640, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

/// -1, 0 or 1, for a polynomial of degree 4 at most: `value(Number())` is it in that kind of number.
template <class Value>
int exact_sign(Value value) {
  mpfr_clear_inexflag();
  const Real quick = value(Real());
  if (mpfr_inexflag_p() == 0) return quick.sign();
  return value(Wide()).sign();
}

}  // namespace lancer::stress::flat
