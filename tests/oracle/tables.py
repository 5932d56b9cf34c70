# SPDX-License-Identifier: Apache-2.0
"""Table resolution and exact gearing.

hermite_error: the true largest interpolation error of N equal intervals on the cycloid z - sin(2 pi z)/(2 pi) for
    straight lines, cubic Hermite (position, velocity) and quintic Hermite (position, velocity, acceleration), next
    to the usual bounds h^2 M2/8, h^4 M4/384, h^6 M6/46080 (h = 1/N, Mk = max |f^(k)| = (2 pi)^(k-1)).
gear: floor(p n / q) for counts n far beyond what a double or a 64-bit product holds; integers, as text.
"""
from mpmath import mp, mpf

from exact import ZERO, Piece, bracketed_zeros, check_printed, hermite

RULES = {  # derivatives taken over at the knots, order and divisor of the bound, N to report
    "linear": (1, 2, 8, (1, 4, 10, 40, 90, 886, 887)),
    "cubic": (2, 4, 384, (1, 4, 10, 28, 29, 40, 100)),
    "quintic": (3, 6, 46080, (1, 4, 7, 8, 16, 40)),
}
TOLERANCE = mpf("1e-6")


def error(rule, n):
    """max over z of |cycloid - interpolant|."""
    return max(interval_error(rule, n, i) for i in range((n + 1) // 2))  # point-symmetric about z = 1/2


def interval_error(rule, n, i):
    """The same in interval i. The straight-line part of the cycloid interpolates exactly, so the sine is enough."""
    count, h, w = RULES[rule][0], mpf(1) / n, 2 * mp.pi
    if rule == "linear":
        return linear_error(i * h, h, w)
    sine = Piece(h, (), ((-1 / w, w, w * i * h),))
    ends = [[p(u) for p in derivatives(sine, count)] for u in (ZERO, h)]
    fitted = hermite(h, *ends)
    difference = Piece(h, tuple(-c for c in fitted.poly), sine.sines)
    grid = [h * (k + mpf("0.5")) / 24 for k in range(24)]  # the ends are zeros of the slope as well
    return max(abs(difference(u)) for u in bracketed_zeros(difference.derivative(), grid) + grid)


def linear_error(z, h, w):
    """Chord error of -sin(w z)/w: the slope equals the chord's where cos(w z) = -chord."""
    def sine(x):
        return -mp.sin(w * x) / w

    chord = (sine(z + h) - sine(z)) / h
    angle = mp.acos(-chord)
    points = [(sign * angle + 2 * mp.pi * k) / w for sign in (-1, 1) for k in (0, 1)]
    inside = [x for x in points if z < x < z + h]
    return max([abs(sine(x) - sine(z) - chord * (x - z)) for x in inside] + [ZERO])


def derivatives(piece, count):
    result = [piece]
    while len(result) < count:
        result.append(result[-1].derivative())
    return result


def bound(rule, n):
    _, order, divisor, _ = RULES[rule]
    return (2 * mp.pi) ** (order - 1) / divisor / mpf(n) ** order


def smallest_by_bound(rule):
    n = 1
    while bound(rule, n) > TOLERANCE:
        n += 1
    return n


def smallest_by_error(rule, by_bound):
    """Down from the bound until the error breaks the tolerance; fewer intervals then fail next to z = 1/4 already."""
    n = by_bound
    while n > 1 and error(rule, n - 1) <= TOLERANCE:
        n -= 1
    assert all(interval_error(rule, k, k // 4) > TOLERANCE for k in range(1, n))
    return n


def make_hermite_error():
    result = {"tolerance": 1e-6, "rules": {}}
    for rule, printed in (("linear", 887), ("cubic", 29), ("quintic", 8)):
        by_bound = smallest_by_bound(rule)
        check_printed(f"{rule} intervals for 1e-6", str(printed), mpf(by_bound))
        numbers = RULES[rule][3]
        result["rules"][rule] = {
            "n": list(numbers), "max_error": [error(rule, n) for n in numbers],
            "bound": [bound(rule, n) for n in numbers], "smallest_n_by_bound": by_bound,
            "smallest_n_by_error": smallest_by_error(rule, by_bound)}
    cubic = result["rules"]["cubic"]
    at40 = cubic["n"].index(40)
    check_printed("cubic, 40 intervals, error in 1e-7", "2.514", cubic["max_error"][at40] * 10**7)
    check_printed("cubic, 40 intervals, bound in 1e-7", "2.523", cubic["bound"][at40] * 10**7)
    return result


# --------------------------------------------------------------------------------------------------- gear

RATIOS = ((4000, 3072), (-7, 3), (1, 3), (65536, 65535), (1, 1), (-1, 1), (0, 5), (4, -6), (-4, -6), (1, -7),
          (355, 113), (2147483647, 2147483646), (1000003, 999983), (1, 4294967291), (4294967291, 2))
COUNTS = (0, 1, -1, 2, -2, 3, -3, 5, -5, 3072, -3072, 3071, 10**6 + 1, -(10**6) - 1, 10**12, -(10**12),
          10**12 + 1, -(10**12) - 1, 2**40 + 7, -(2**40) - 7, 2**53 + 1, -(2**53) - 1, 2**62, -(2**63))


def make_gear():
    """Python integers: // floors towards minus infinity for every pair of signs."""
    ratios = []
    for p, q in RATIOS:
        floors = [p * n // q for n in COUNTS]
        remainders = [(p * n * (1 if q > 0 else -1)) % abs(q) for n in COUNTS]
        for n, f, r in zip(COUNTS, floors, remainders):
            assert f * q + r * (1 if q > 0 else -1) == p * n and 0 <= r < abs(q)
        ratios.append({"p": str(p), "q": str(q), "floor": [str(f) for f in floors],
                       "remainder": [str(r) for r in remainders],
                       "product_fits_int64": [-(2**63) <= p * n < 2**63 for n in COUNTS],
                       "floor_fits_int64": [-(2**63) <= f < 2**63 for f in floors]})
    return {"n": [str(n) for n in COUNTS], "ratios": ratios}
