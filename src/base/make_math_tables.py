#!/usr/bin/env python3
"""Prints math_tables.cpp: the values that the functions of math.hpp start from.

Every value is the sum of two doubles, each the nearest to what the ones before it leave over. Worked out with
60 decimal digits; needs Python alone. Run it as
make_math_tables.py > math_tables.cpp, then clang-format.
"""
from decimal import Decimal, getcontext

getcontext().prec = 60


def series(x, first, ratio):
    """The sum of a series whose term k + 1 is term k times ratio(k)."""
    total, term, k = Decimal(0), first, 0
    while term != 0 and (total == 0 or abs(term) > abs(total) * Decimal(10) ** -58):
        total += term
        term *= ratio(k)
        k += 1
    return total


def sin(x):
    return series(x, x, lambda k: -x * x / ((2 * k + 2) * (2 * k + 3)))


def cos(x):
    return series(x, Decimal(1), lambda k: -x * x / ((2 * k + 1) * (2 * k + 2)))


def atan(x):
    """Three halvings of the angle, then the series of Gregory."""
    for _ in range(3):
        x = x / (1 + (1 + x * x).sqrt())
    total, power, k = Decimal(0), x, 0
    while power != 0 and abs(power) > Decimal(10) ** -60:
        total += power / (2 * k + 1)
        power *= -x * x
        k += 1
    return 8 * total


PI = 4 * atan(Decimal(1))
LN2 = Decimal(2).ln()
LN10 = Decimal(10).ln()


def pair(value):
    hi = float(value)
    lo = float(value - Decimal(hi))
    return "{%s, %s}" % (hi.hex(), lo.hex())


def head(value, bits):
    """The leading bits of a positive number."""
    scale = Decimal(2) ** (bits - 1 - int((value.ln() / LN2).to_integral_value(rounding="ROUND_FLOOR")))
    return (value * scale).to_integral_value() / scale


def reciprocal(i):
    """About 1 / m in steps of 1/512, for m in the i-th of 128 parts of [1, 2), or of [1/2, 1) from 53 on."""
    if i in (0, 127):
        return Decimal(1)
    m = (1 + (Decimal(i) + Decimal("0.5")) / 128) / (2 if i >= 53 else 1)
    return (512 / m).to_integral_value() / 512


def table(kind, name, rows):
    print("const %s %s = {{" % (kind, name))
    for row in rows:
        print("    %s," % row)
    print("}};\n")


def main():
    print("// Made by make_math_tables.py.\n")
    print('#include "base/math_tables.hpp"\n')
    print("namespace lancer::math {\n")
    ln2_head = head(LN2, 42)
    ln2_rest = LN2 - ln2_head
    step = LN2 / 4096
    step_head = head(step, 30)
    for name, value in (("k_log2_e", 1 / LN2), ("k_log10_e", 1 / LN10), ("k_degree", PI / 180), ("k_radian", 180 / PI)):
        print("const DoubleDouble %s = %s;" % (name, pair(value)))
    print("const double k_ln2_head = %s;" % float(ln2_head).hex())
    print("const DoubleDouble k_ln2_rest = %s;" % pair(ln2_rest))
    print("const double k_exp_step_head = %s;" % float(step_head).hex())
    print("const DoubleDouble k_exp_step_rest = %s;\n" % pair(step - step_head))
    table("std::array<DoubleDouble, 64>", "k_exp_coarse", [pair((LN2 * i / 64).exp()) for i in range(64)])
    table("std::array<DoubleDouble, 64>", "k_exp_fine", [pair((LN2 * i / 4096).exp()) for i in range(64)])
    table("std::array<LogEntry, 128>", "k_log_coarse",
          ["{%s, %s}" % (float(reciprocal(i)).hex(), pair(-reciprocal(i).ln())) for i in range(128)])
    table("std::array<DoubleDouble, 129>", "k_log_fine", [pair(-(1 - Decimal(j) / 8192).ln()) for j in range(-64, 65)])
    angles = [PI * i / 128 for i in range(33)]
    table("std::array<SinCos, 33>", "k_sin_cos", ["{%s, %s}" % (pair(sin(a)), pair(cos(a))) for a in angles])
    table("std::array<DoubleDouble, 65>", "k_atan_degrees",
          [pair(atan(Decimal(i) / 64) * 180 / PI) for i in range(65)])
    print("}  // namespace lancer::math")


if __name__ == "__main__":
    main()
