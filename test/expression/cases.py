#!/usr/bin/env python3
"""Prints cases.txt: hard cases of the elementary functions, from mpmath.

Nothing runs this: it tells where the numbers are from. Each line is a name, the
arguments, and the exact result, as the nearest double and what that lacks. Of
many random arguments those are kept whose results lie nearest to the middle
between two doubles, which are the hardest to round, and some of the others.
"""
import math
import random
from mpmath import mp, mpf, sin, cos, tan, asin, acos, atan2, exp, log, power, pi, isnan

mp.prec = 1400
random.seed(20)


def degrees(radians):
    return radians * 180 / pi


def turns_off(x):
    """x less whole turns, exactly; both are doubles"""
    return math.fmod(x, 360.0)


def radians(x):
    return mpf(turns_off(x)) * pi / 180


exact = {
    "sin": lambda x: sin(radians(x)),
    "cos": lambda x: cos(radians(x)),
    "tan": lambda x: tan(radians(x)),
    "asin": lambda x: degrees(asin(mpf(x))),
    "acos": lambda x: degrees(acos(mpf(x))),
    "atan": lambda x: degrees(atan2(mpf(x), mpf(1))),
    "atan2": lambda y, x: degrees(atan2(mpf(y), mpf(x))),
    "exp": lambda x: exp(mpf(x)),
    "log": lambda x: log(mpf(x)),
    "pow": lambda x, y: power(mpf(x), mpf(y)),
}


def uniform(a, b):
    return lambda: random.uniform(a, b)


def size(a, b):
    """numbers of both signs from 10^a to 10^b"""
    return lambda: random.choice((-1, 1)) * 10 ** random.uniform(a, b)


def positive(numbers):
    return lambda: abs(numbers())


def near(place, numbers):
    return lambda: place + numbers()


def multiple(n, numbers):
    return lambda: n * random.randint(-30, 30) + numbers()


angles = [uniform(-45, 45), uniform(-720, 720), multiple(15, size(-14, -3)),
          size(-12, 0), size(10, 22), size(22, 300)]
sines = [uniform(-1, 1), size(-15, 0), lambda: 1 - 10 ** random.uniform(-15, -1)]
reals = [uniform(-2, 2), size(-3, 3), size(-40, 40)]
positives = [positive(uniform(0, 10)), near(1, size(-15, -1)), positive(size(-300, 300))]

sources = {
    "sin": [[a] for a in angles],
    "cos": [[a] for a in angles],
    "tan": [[a] for a in angles],
    "asin": [[a] for a in sines],
    "acos": [[a] for a in sines],
    "atan": [[a] for a in reals],
    "atan2": [[a, b] for a in reals for b in reals],
    "exp": [[a] for a in (uniform(-1, 1), uniform(-708, 709), size(-10, 0))],
    "log": [[a] for a in positives],
    "pow": [[a, b] for a in positives for b in (uniform(-5, 5), size(-3, 2))],
}

# where the results, or the arguments, leave the range of doubles
edges = {
    "sin": [[5e-324], [1e-310], [1.7976931348623157e308], [2.0 ** 67], [2.0 ** 36]],
    "cos": [[5e-324], [1.7976931348623157e308], [-(2.0 ** 67)]],
    "tan": [[5e-324], [1.7976931348623157e308], [90.00000000000001]],
    "asin": [[5e-324], [1e-300], [0.9999999999999999]],
    "acos": [[5e-324], [-0.9999999999999999]],
    "atan": [[5e-324], [1e-300], [1.7976931348623157e308]],
    "atan2": [[5e-324, 1.0], [5e-324, 1e-300], [1e308, 1e308], [5e-324, -5e-324],
              [1e-100, 1e220], [-1e300, 1e-300], [3e-324, 1e-323]],
    "exp": [[709.78], [-708.5], [-744.4], [5e-324], [-1e-300]],
    "log": [[5e-324], [1e-310], [1.7976931348623157e308], [0.9999999999999999]],
    "pow": [[1.0000000000000002, 3e18], [0.9999999999999999, 6e18], [5e-324, 0.99],
            [1.7976931348623157e308, 0.5], [10.0, -320.3], [2.0, -1073.4]],
}


def case(name, arguments):
    result = exact[name](*arguments)
    high = float(result)
    if not math.isfinite(high) or high == 0:
        return None
    low = result - mpf(high)
    ulp = math.ulp(high)
    return abs(abs(low) / mpf(ulp) - 0.5), name, arguments, high, float(low)


def show(c):
    _, name, arguments, high, low = c
    print(" ".join([name] + [a.hex() for a in arguments] + [high.hex(), low.hex()]))


for name in exact:
    for source in sources[name]:
        many = [case(name, [f() for f in source]) for _ in range(600)]
        many = [c for c in many if c]
        for c in sorted(many, key=lambda c: c[0])[: 60 // len(sources[name])] + many[:3]:
            show(c)
    for arguments in edges[name]:
        c = case(name, arguments)
        if c:
            show(c)
