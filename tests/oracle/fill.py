#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes fill.json: velocities and accelerations at the knots of tables that leave them out, with 50 digits and none of
the library's code.

The splines are found from their definition by splines.py: one polynomial an interval, one equation a condition. The
harmonic mean of Fritsch and Butland is written out with fractions.

    python3 fill.py           # writes fill.json; needs python3-mpmath
    python3 fill.py --check   # exit status 1 if fill.json is not what the script makes
"""
import json
import sys
from fractions import Fraction
from pathlib import Path

from splines import derivative_row, evaluate, piecewise

# HMPL manual 5.2.8, s and mm; and a table of very uneven intervals that is closed.
TABLES = {
    "hmpl": ((0, 0), (2, 153.333), (3, 42.123), (4, 161.21), (6, 177), (11, 83.333)),
    "uneven": ((-3, 1), (-2.9990234375, 1.5), (0, 4), (0.0625, 4), (64, -2), (65, 0.25), (66, 1)),
}
ENDS = {
    "natural": dict(start=((2, 0),), end=((2, 0),)),
    "clamped": dict(start=((1, 0),), end=((1, 0),)),
    "periodic": dict(periodic=True),
}


def at_knots(points, solution, orders):
    breaks, pieces = solution
    return [[float(evaluate(breaks, pieces, p[0], order)) for p in points] for order in orders]


def splines(points):
    out = {name: at_knots(points, piecewise(points, 3, **ends), (1,))[0] for name, ends in ENDS.items()}
    joints = [0] + list(range(2, len(points) - 2)) + [len(points) - 1]
    out["not_a_knot"] = at_knots(points, piecewise(points, 3, joints=joints), (1,))[0]
    # The velocity of the third knot is given: two independent splines.
    left = at_knots(points[:3], piecewise(points[:3], 3, start=((2, 0),), end=((1, 5),)), (1,))[0]
    right = at_knots(points[2:], piecewise(points[2:], 3, start=((1, 5),), end=((2, 0),)), (1,))[0]
    out["natural, third given 5"] = left + right[1:]
    free = dict(start=((3, 0), (4, 0)), end=((3, 0), (4, 0)))
    out["minimum_jerk"] = at_knots(points, piecewise(points, 5, **free), (1, 2))
    out["minimum_jerk at rest"] = at_knots(
        points, piecewise(points, 5, start=((1, 0), (2, 0)), end=((1, 0), (2, 0))), (1, 2))
    out["minimum_jerk periodic"] = at_knots(points, piecewise(points, 5, periodic=True), (1, 2))
    return out


def monotone(points):
    x = [Fraction(p[0]) for p in points]
    p = [Fraction(p[1]) for p in points]
    h = [b - a for a, b in zip(x, x[1:])]
    d = [(b - a) / k for a, b, k in zip(p, p[1:], h)]

    def end(h0, d0, h1, d1):
        v = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1)
        if v * d0 <= 0:
            return Fraction(0)
        return v if abs(v) < 3 * abs(d0) else 3 * d0

    inner = [((2 * k + g) + (k + 2 * g)) / ((2 * k + g) / a + (k + 2 * g) / b) if a * b > 0 else Fraction(0)
             for g, k, a, b in zip(h, h[1:], d, d[1:])]
    return [float(v) for v in [end(h[0], d[0], h[1], d[1])] + inner + [end(h[-1], d[-1], h[-2], d[-2])]]


def made():
    assert derivative_row(1, 1, 0)[1] == 1
    out = {}
    for name, points in TABLES.items():
        out[name] = {"points": points, "monotone": monotone(points), **splines(points)}
    return json.dumps(out, indent=1, sort_keys=True) + "\n"


if __name__ == "__main__":
    target = Path(__file__).with_name("fill.json")
    if "--check" in sys.argv:
        sys.exit(0 if target.read_text() == made() else 1)
    target.write_text(made())
