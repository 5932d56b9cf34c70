#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes spline_times.json: best times of multi-joint cubic splines of the Lin-Chang-Luh class, with none of the
library's code and another search.

Six joints through four points, virtual second and fifth knots, velocity and acceleration zero at both ends. A joint is
found from the definition: the 20 coefficients of five cubics by one dense linear system. Extrema in closed form. With
all intervals times s, velocity, acceleration and jerk go with s^-1, s^-2, s^-3, so the least duration of given ratios
is known, and the ratios are sought:

- peaks (shortest time; least peak jerk at a duration): successive linear programs in the logarithms of the ratios
  within a shrinking box, derivatives by central differences of a quantity that does not need many digits: every
  accepted step is exact. At the end Kuhn and Tucker's conditions are tried: multipliers >= 0 of the active peaks that
  balance the gradient, by non-negative least squares. Their relative residual is written too.
- the integral of jerk^2: Newton's method on its logarithm, differences of 1e-4.

    python3 spline_times.py      # writes spline_times.json, about 1 min; needs python3-scipy
"""
import json
from pathlib import Path

import numpy as np
from scipy.optimize import linprog, nnls

KNOTS = [(-10, 60, 20, 55), (20, 50, 120, 35), (15, 100, -10, 30), (150, 100, 40, 10), (30, 110, 90, 70),
         (120, 60, 100, 25)]
VELOCITY = [100, 95, 100, 150, 130, 110]
SETS = {
    "A": {"velocity": VELOCITY, "acceleration": [45, 40, 75, 70, 90, 80], "jerk": [60, 60, 55, 70, 75, 70]},
    "B": {"velocity": VELOCITY, "acceleration": [60, 60, 75, 70, 90, 80], "jerk": [60, 66, 85, 70, 75, 70]},
}
DURATION = 9.1


def row(order, u):
    """Of c0 + c1 u + c2 u^2 + c3 u^3."""
    c = [np.polynomial.polynomial.polyder(e, order) if order else e for e in np.eye(4)]
    return np.array([np.polynomial.polynomial.polyval(u, e) for e in c])


def coefficients(points, h):
    """c[interval][power] of one joint."""
    a, b = [], []

    def add(parts, value):
        line = np.zeros(20)
        for i, entries, sign in parts:
            line[4 * i:4 * i + 4] += sign * entries
        a.append(line)
        b.append(value)

    for order, value in ((0, points[0]), (1, 0), (2, 0)):
        add([(0, row(order, 0), 1)], value)
    for order, value in ((0, points[3]), (1, 0), (2, 0)):
        add([(4, row(order, h[4]), 1)], value)
    add([(2, row(0, 0), 1)], points[1])
    add([(3, row(0, 0), 1)], points[2])
    for i in range(4):
        for order in range(3):
            add([(i, row(order, h[i]), 1), (i + 1, row(order, 0), -1)], 0)
    return np.linalg.solve(np.array(a), np.array(b)).reshape(5, 4)


def shares(h, limits):
    """|quantity| / limit, to the root of its order: each must be at most 1 for the duration to be possible."""
    out = []
    for j, points in enumerate(KNOTS):
        for c, length in zip(coefficients(points, h), h):
            if "velocity" in limits:
                places = [0, length]
                if c[3] != 0 and 0 < -c[2] / (3 * c[3]) < length:
                    places.append(-c[2] / (3 * c[3]))
                out.append(max(abs(row(1, u) @ c) for u in places) / limits["velocity"][j])
                out += [(abs(row(2, u) @ c) / limits["acceleration"][j]) ** 0.5 for u in (0, length)]
            out.append((6 * abs(c[3]) / limits["jerk"][j]) ** (1 / 3))
    return np.array(out)


def shortest(limits, start):
    """log of the least duration over y = log of the intervals."""
    def terms(y):
        h = np.exp(y)
        return np.log(np.maximum(shares(h, limits), 1e-30)) + np.log(h.sum())

    def gradients(y, near, step=1e-6):
        g = np.array([(terms(y + step * e)[near] - terms(y - step * e)[near]) / (2 * step) for e in np.eye(5)])
        return g.T

    y, radius = np.log(start), 0.3
    best = terms(y).max()
    while radius > 1e-10:
        f = terms(y)
        near = f > f.max() - 20 * radius
        g = gradients(y, near)
        rows = np.hstack([g, -np.ones((g.shape[0], 1))])
        found = linprog([0] * 5 + [1], A_ub=rows, b_ub=-f[near], bounds=[(-radius, radius)] * 5 + [(None, None)])
        trial = y + found.x[:5] if found.status == 0 else y
        value = terms(trial).max()
        if value < best:
            y, best, radius = trial, value, radius * 1.5
        else:
            radius /= 2
    f = terms(y)
    active = f > f.max() - 1e-7
    g = gradients(y, active)
    weights, residual = nnls(np.vstack([g.T, 1e3 * np.ones(g.shape[0])]), np.array([0] * 5 + [1e3]))
    return np.exp(best), np.exp(y), int(active.sum()), float(residual)


def least_square_jerk(start):
    def f(y):
        h = np.exp(y)
        square = sum((6 * coefficients(p, h)[:, 3]) ** 2 @ h for p in KNOTS)
        return np.log(square) + 5 * np.log(h.sum())

    y, d = np.log(start), 1e-4
    for _ in range(40):
        e = np.eye(5) * d
        g = np.array([(f(y + a) - f(y - a)) / (2 * d) for a in e])
        hess = np.array([[(f(y + a + b) - f(y + a - b) - f(y - a + b) + f(y - a - b)) / (4 * d * d) for a in e]
                         for b in e])
        # f does not change along (1, ..., 1).
        move = -np.linalg.lstsq(hess + np.eye(5) * 0 + np.ones((5, 5)), g, rcond=None)[0]
        length = 1.0
        while f(y + length * move) > f(y) and length > 1e-12:
            length /= 2
        y = y + length * move
    return float(np.exp(f(y))) / DURATION ** 5, np.exp(y)


def scaled(h, duration):
    return [float(v) for v in h * duration / h.sum()]


def best_of(limits, starts):
    runs = [shortest(limits, s) for s in starts]
    runs.sort(key=lambda r: r[0])
    t, h, active, residual = runs[0]
    print(len(runs), "starts:", [float(r[0]) for r in runs], "active", active, "residual", residual)
    return {"duration": float(t), "intervals": scaled(h, t), "active": active, "kuhn_tucker_residual": residual}


def main():
    random = np.random.default_rng(1)
    starts = [np.array([1, 3, 3, 3, 1.])] + [np.exp(random.uniform(-1, 1, 5)) for _ in range(3)]
    out = {"knots": KNOTS, "sets": {}}
    for name, limits in SETS.items():
        out["sets"][name] = {**limits, **best_of(limits, starts)}
    jerk = best_of({"jerk": [1.0] * 6}, starts)
    out["least_peak_jerk"] = {"duration": DURATION, "value": (jerk["duration"] / DURATION) ** 3,
                              "kuhn_tucker_residual": jerk["kuhn_tucker_residual"],
                              "intervals": scaled(np.array(jerk["intervals"]), DURATION)}
    value, h = least_square_jerk(starts[0])
    out["least_square_jerk"] = {"duration": DURATION, "value": value, "intervals": scaled(h, DURATION)}
    Path(__file__).with_name("spline_times.json").write_text(json.dumps(out, indent=1, sort_keys=True) + "\n")
    print(json.dumps(out["least_peak_jerk"]), json.dumps(out["least_square_jerk"]))


if __name__ == "__main__":
    main()
