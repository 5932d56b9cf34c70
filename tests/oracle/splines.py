#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes splines.json: splines through points, B-splines, Bezier curves and points with tolerances, with 50 digits and
none of the library's code.

A spline of degree d is found from the definition alone: the coefficients of one polynomial an interval, and one linear
equation for each value, each continuous derivative and each end condition. B-splines are evaluated by the recurrence of
Cox and de Boor over all control values, interpolating ones from their collocation matrix, Bezier curves by de
Casteljau's method. Points with a tolerance: the least integral of the squared third derivative as a quadratic form of
the values (by the splines through unit vectors), and all 3^n choices of what is at a bound are tried for the one that
keeps Kuhn and Tucker's conditions.

    python3 splines.py           # writes splines.json, about 1 min; needs python3-mpmath
    python3 splines.py --check   # exit status 1 if splines.json is not what the script makes
"""
import itertools
import json
import sys
from pathlib import Path

from mpmath import factorial, lu_solve, matrix, mp, mpf

mp.dps = 50

POINTS = ((0, 0), (0.5, 1.25), (2, 1), (2.75, -0.5), (4.5, 3), (5, 2.5), (7, 0.5), (9, 0))
TIES = ((0, 0, 0), (1, 1.25, 0.5), (2.5, 1, 0.25), (3, -0.5, 0.5), (4.5, 2, 1), (6, 0.5, 0.125), (7, 0, 0))


def derivative_row(degree, order, x):
    """Of the monomials up to `degree`, counted from the start of their interval."""
    return [mpf(0) if k < order else factorial(k) / factorial(k - order) * mpf(x) ** (k - order)
            for k in range(degree + 1)]


def piecewise(points, degree, start=(), end=(), periodic=False, joints=None):
    """Coefficients of each interval. start, end: (order, value); joints: the points where intervals meet."""
    x = [mpf(p[0]) for p in points]
    y = [mpf(p[1]) for p in points]
    at = list(range(len(x))) if joints is None else joints
    size = (degree + 1) * (len(at) - 1)
    rows, right = [], []

    def add(parts, value):
        row = [mpf(0)] * size
        for interval, entries, sign in parts:
            for k, e in enumerate(entries):
                row[interval * (degree + 1) + k] += sign * e
        rows.append(row)
        right.append(value)

    def length(i):
        return x[at[i + 1]] - x[at[i]]

    for i in range(len(at) - 1):
        inner = range(at[i], at[i + 1] + (1 if i == len(at) - 2 else 0))
        for p in inner:
            add([(i, derivative_row(degree, 0, x[p] - x[at[i]]), 1)], y[p])
    for i in range(len(at) - 2):
        for order in range(degree):
            add([(i, derivative_row(degree, order, length(i)), 1),
                 (i + 1, derivative_row(degree, order, 0), -1)], mpf(0))
    last = len(at) - 2
    if periodic:
        for order in range(1, degree):
            add([(last, derivative_row(degree, order, length(last)), 1),
                 (0, derivative_row(degree, order, 0), -1)], mpf(0))
    for order, value in start:
        add([(0, derivative_row(degree, order, 0), 1)], mpf(value))
    for order, value in end:
        add([(last, derivative_row(degree, order, length(last)), 1)], mpf(value))
    assert len(rows) == size, (len(rows), size)
    solution = lu_solve(matrix(rows), matrix(right))
    return [x[k] for k in at], [[solution[i * (degree + 1) + k] for k in range(degree + 1)]
                                for i in range(len(at) - 1)]


def evaluate(breaks, pieces, x, order=0):
    i = max(k for k in range(len(pieces)) if breaks[k] <= x)
    row = derivative_row(len(pieces[i]) - 1, order, x - breaks[i])
    return sum(a * b for a, b in zip(row, pieces[i]))


def sampled(breaks, pieces, count=37):
    first, last = breaks[0], breaks[-1]
    places = [float(first + (last - first) * k / count) for k in range(count)]
    return [{"x": x, "jet": [float(evaluate(breaks, pieces, mpf(x), order)) for order in range(4)]} for x in places]


def interpolating():
    n = len(POINTS)
    ends = {
        "cubic natural": (3, dict(start=[(2, 0)], end=[(2, 0)])),
        "cubic clamped": (3, dict(start=[(1, 2)], end=[(1, -0.75)])),
        "cubic periodic": (3, dict(periodic=True)),
        "cubic not_a_knot": (3, dict(joints=[0, *range(2, n - 2), n - 1])),
        "quintic natural": (5, dict(start=[(3, 0), (4, 0)], end=[(3, 0), (4, 0)])),
        "quintic clamped": (5, dict(start=[(1, 2), (2, -1)], end=[(1, -0.75), (2, 0.5)])),
        "quintic half clamped": (5, dict(start=[(1, 2), (3, 0)], end=[(2, 0.5), (4, 0)])),
        "quintic periodic": (5, dict(periodic=True)),
        "quintic not_a_knot": (5, dict(joints=[0, *range(3, n - 3), n - 1])),
    }
    return {name: sampled(*piecewise(POINTS, degree, **how)) for name, (degree, how) in ends.items()}


def cox_de_boor(t, i, p, x):
    """Right-continuous; the last interval is closed."""
    if p == 0:
        closed = x == t[-1] and t[i] < t[i + 1] == t[-1]
        return mpf(1) if t[i] <= x < t[i + 1] or closed else mpf(0)
    total = mpf(0)
    if t[i + p] > t[i]:
        total += (x - t[i]) / (t[i + p] - t[i]) * cox_de_boor(t, i, p - 1, x)
    if t[i + p + 1] > t[i + 1]:
        total += (t[i + p + 1] - x) / (t[i + p + 1] - t[i + 1]) * cox_de_boor(t, i + 1, p - 1, x)
    return total


def b_spline_value(t, control, p, x):
    return sum(c * cox_de_boor(t, i, p, x) for i, c in enumerate(control))


def values_of(t, control, p, count=29):
    first, last = t[p], t[len(control)]
    places = [float(first + (last - first) * k / count) for k in range(count + 1)]
    return [{"x": x, "value": float(b_spline_value(t, control, p, mpf(x)))} for x in places]


def interpolating_b_splines():
    x = [mpf(p[0]) for p in POINTS]
    out = []
    for p in range(1, 8):
        inner = len(x) - p - 1
        skip = (p + 1) // 2
        middle = [x[skip + i] if p % 2 else (x[skip + i] + x[skip + i + 1]) / 2 for i in range(inner)]
        t = [x[0]] * (p + 1) + middle + [x[-1]] * (p + 1)
        a = matrix([[cox_de_boor(t, i, p, xi) for i in range(len(x))] for xi in x])
        control = list(lu_solve(a, matrix([mpf(q[1]) for q in POINTS])))
        out.append({"degree": p, "samples": values_of(t, control, p)})
    return out


def given_b_splines():
    cases = (
        (2, (0, 0, 0, 1, 2.5, 2.5, 4, 4, 4), (0, 1, 3, 2, 2, 5)),
        (3, (0, 0.5, 1, 2, 3.5, 4, 5, 6, 8), (1, 0, -2, 4, 1)),          # not clamped to its end values
        (5, (0, 0, 0, 0, 0, 0, 1, 3, 3, 4, 4, 4, 4, 4, 4), (0, 0, 0, 2, 5, 3, 1, 1, 1)),
        (11, (-1,) * 12 + (0.5,) + (2,) * 12, (0, 0, 0, 0, 0, 0, 4, 10, 10, 10, 10, 10, 10)),
    )
    return [{"degree": p, "knots": t, "control": c,
             "samples": values_of([mpf(v) for v in t], [mpf(v) for v in c], p)} for p, t, c in cases]


def beziers():
    out = []
    for control in ((3,), (1, -2), (0, 0, 0, 40, 40, 40), (0, 0, 0, 0, 0, 0, 7, 7, 7, 7, 7, 7), (1, -1, 2, -2, 3)):
        samples = []
        for k in range(9):
            b, s = [mpf(c) for c in control], mpf(k) / 8
            while len(b) > 1:
                b = [(1 - s) * u + s * v for u, v in zip(b, b[1:])]
            samples.append(float(b[0]))
        out.append({"control": control, "samples": samples})
    return out


def square_jerk(breaks, pieces, other):
    """Integral of the product of two splines' third derivatives."""
    total = mpf(0)
    for i, (f, g) in enumerate(zip(pieces, other)):
        h = breaks[i + 1] - breaks[i]
        for k, l in itertools.product(range(3, 6), repeat=2):
            power = k + l - 5
            total += (f[k] * g[l] * factorial(k) / factorial(k - 3) * factorial(l) / factorial(l - 3)
                      * h ** power / power)
    return total


def with_tolerance(name, **how):
    """Brute force over what is at its lower bound, free, or at its upper bound."""
    n = len(TIES)
    zero = [(x, 0) for x, _, _ in TIES]
    clean = {k: [(order, 0) for order, _ in v] for k, v in how.items()}
    base, offset = piecewise(zero, 5, **how)
    units = [piecewise([(x, 1 if i == k else 0) for i, (x, _, _) in enumerate(TIES)], 5, **clean)[1]
             for k in range(n)]
    h = [[square_jerk(base, units[i], units[k]) for k in range(n)] for i in range(n)]
    g = [square_jerk(base, units[i], offset) for i in range(n)]
    constant = square_jerk(base, offset, offset)
    loose = [i for i in range(n) if TIES[i][2] > 0]
    found = []
    for choice in itertools.product((-1, 0, 1), repeat=len(loose)):
        y = [mpf(p[1]) for p in TIES]
        side = dict(zip(loose, choice))
        for i, s in side.items():
            y[i] += s * mpf(TIES[i][2])
        free = [i for i in loose if side[i] == 0]
        if free:
            pinned = [k for k in range(n) if k not in free]
            right = [-g[i] - sum(h[i][k] * y[k] for k in pinned) for i in free]
            for i, v in zip(free, lu_solve(matrix([[h[i][k] for k in free] for i in free]), matrix(right))):
                y[i] = v
        gradient = [2 * (g[i] + sum(h[i][k] * y[k] for k in range(n))) for i in range(n)]
        if all(abs(y[i] - TIES[i][1]) <= TIES[i][2] for i in free) and \
                all(side[i] * gradient[i] <= 0 for i in loose if side[i]):
            energy = constant + sum(2 * g[i] * y[i] + sum(h[i][k] * y[i] * y[k] for k in range(n)) for i in range(n))
            found.append({"square_jerk": float(energy), "slave": [float(v) for v in y],
                          "side": [side.get(i, 2) for i in range(n)]})
    assert len(found) == 1, (name, found)
    return found[0]


def make():
    natural = [(3, 0), (4, 0)]
    rest = [(1, 0), (2, 0)]
    return {
        "points": POINTS,
        "interpolating": interpolating(),
        "b_spline": given_b_splines(),
        "interpolating_b_spline": interpolating_b_splines(),
        "bezier": beziers(),
        "tolerance": {"points": TIES,
                      "natural": with_tolerance("natural", start=natural, end=natural),
                      "clamped": with_tolerance("clamped", start=rest, end=rest)},
    }


def main():
    path = Path(__file__).with_name("splines.json")
    text = json.dumps(make(), indent=1, sort_keys=True) + "\n"
    if "--check" in sys.argv:
        sys.exit(0 if path.read_text(encoding="utf-8") == text else "splines.json is not what this script makes")
    path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
