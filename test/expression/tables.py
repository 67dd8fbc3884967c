#!/usr/bin/env python3
"""Prints the tables of lib/expression, to 200 bits by mpmath.

Nothing runs this: it tells where the numbers are from. To see them again:

    python3 tables.py exp_table > ../../lib/expression/exp_table.ml

and the same with log_table and arc_table, then dune fmt; the numbers that stand
in other files are those of "tables.py constants".
"""
import sys
from mpmath import mp, mpf, log, atan, pi, floor

mp.prec = 200


def hexadecimal(x):
    return float(x).hex().replace("0x0.0p+0", "0.")


def split(exact, unit=None):
    """The exact number as a double, or a multiple of unit, and what is left."""
    high = mpf(float(exact)) if unit is None else floor(exact / unit + 0.5) * unit
    return high, mpf(float(exact - high))


def table(numbers, unit=None):
    parts = [split(x, unit) for x in numbers]
    for name, i in (("high", 0), ("low", 1)):
        print(f"let {name} = [|")
        for p in parts:
            print(f"  {hexadecimal(p[i])};")
        print("|]\n")


def constant(name, exact, unit=None):
    high, low = split(exact, unit)
    print(f"let {name}_high = {hexadecimal(high)}")
    print(f"let {name}_low = {hexadecimal(low)}\n")


if sys.argv[1] == "exp_table":
    table(mpf(2) ** (mpf(j) / 32) for j in range(32))
elif sys.argv[1] == "log_table":
    print("let first = 45\n")
    table((log(mpf(j) / 64) for j in range(45, 92)), mpf(2) ** -42)
elif sys.argv[1] == "arc_table":
    table((atan(mpf(j) / 16) * 180 / pi for j in range(17)), mpf(2) ** -44)
elif sys.argv[1] == "constants":  # of degrees.ml, arc.ml and power.ml
    constant("radian", pi / 180, mpf(2) ** -31)
    print("let radian =", hexadecimal(pi / 180))
    constant("degree", 180 / pi, mpf(2) ** -20)
    print("let degree =", hexadecimal(180 / pi))
    constant("ln2", log(mpf(2)), mpf(2) ** -42)
    constant("step", log(mpf(2)) / 32, mpf(2) ** -42)
    print("let steps_per_unit =", hexadecimal(32 / log(mpf(2))))
