#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""B-splines over their arc length, with 60 digits: length, places and tangents.

usage: b_splines.py           writes b_splines.json beside it
       b_splines.py --check   exit status 1 if b_splines.json is not what the script makes

The curve is the sum of control points times the basis functions of Cox and de Boor (their recursion, not a blossom);
its length is an integral by mpmath, and a place at a given length is the root of such an integral.
"""
import random
import sys
from pathlib import Path

import exact
from exact import exact as number
from mpmath import mp, mpf

mp.dps = 30


def basis(i, p, knots, t, last):
    """N_i,p(t); `last`: the span that is closed on the right."""
    if p == 0:
        inside = knots[i] <= t < knots[i + 1] or (i == last and t == knots[i + 1])
        return mpf(1) if inside else mpf(0)
    total = mpf(0)
    if knots[i + p] != knots[i]:
        total += (t - knots[i]) / (knots[i + p] - knots[i]) * basis(i, p - 1, knots, t, last)
    if knots[i + p + 1] != knots[i + 1]:
        total += (knots[i + p + 1] - t) / (knots[i + p + 1] - knots[i + 1]) * basis(i + 1, p - 1, knots, t, last)
    return total


def slope(points, p, knots, t, last):
    """The first derivative: a B-spline of degree p - 1 of the differences."""
    out = [mpf(0)] * len(points[0])
    for i in range(len(points) - 1):
        width = knots[i + p + 1] - knots[i + 1]
        n = basis(i + 1, p - 1, knots, t, last)
        for k in range(len(out)):
            out[k] += n * p * (points[i + 1][k] - points[i][k]) / width
    return out


def row(points, degree, knots):
    pts = [[number(x) for x in q] for q in points]
    u = [number(k) for k in knots]
    last = len(pts) - 1
    spans = u[degree:len(pts) + 1]
    speed = lambda t: mp.sqrt(sum(x * x for x in slope(pts, degree, u, t, last)))
    parts = [mp.quad(speed, mp.linspace(a, b, 4)) for a, b in zip(spans, spans[1:])]
    length = sum(parts)
    places = []
    for share in (mpf(1) / 4, mpf(1) / 2, mpf(4) / 5):
        rest, k = share * length, 0
        while rest > parts[k]:
            rest -= parts[k]
            k += 1
        t = spans[k] + (spans[k + 1] - spans[k]) * rest / parts[k]
        for _ in range(40):  # Newton
            step = (mp.quad(speed, mp.linspace(spans[k], t, 4)) - rest) / speed(t)
            t -= step
            if abs(step) < mpf(10) ** -22:
                break
        n = [basis(i, degree, u, t, last) for i in range(len(pts))]
        v = slope(pts, degree, u, t, last)
        size = speed(t)
        places.append({"share": share, "point": [sum(a * q[k2] for a, q in zip(n, pts)) for k2 in range(len(pts[0]))],
                       "tangent": [x / size for x in v]})
    return {"points": points, "degree": degree, "knots": knots, "length": length, "places": places}


def main():
    rng = random.Random(97)
    rows = []
    for count, degree, axes in ((4, 3, 2), (6, 3, 2), (7, 3, 3), (7, 4, 2), (8, 5, 3)):
        points = [[round(60 * k + rng.uniform(-20, 20), 3)] + [round(rng.uniform(-80, 80), 3) for _ in range(axes - 1)]
                  for k in range(count)]
        knots = [0.0] * (degree + 1) + [float(k) for k in range(1, count - degree)] + [float(count - degree)] * (degree + 1)
        rows.append(row(points, degree, knots))
    uneven = [0.0] * 4 + [0.5, 2.0, 2.25] + [4.0] * 4
    rows.append(row([[0.0, 0.0], [10.0, 30.0], [40.0, -20.0], [55.0, 45.0], [80.0, 10.0], [90.0, 60.0], [120.0, 0.0]], 3, uneven))
    return exact.finish(Path(__file__).with_name("b_splines.json"), {"b_splines": rows})


if __name__ == "__main__":
    sys.exit(main())
