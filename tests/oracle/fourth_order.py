#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes fourth_order.json: the least duration of rest-to-rest moves with limited velocity, acceleration, jerk and
jounce, by linear programming; nothing is assumed about phases or symmetry, and none of the library's code is used.

The jounce is constant on n equal intervals; velocity, acceleration and jerk are limited at the grid points. The
largest distance that a duration T permits is a linear program in the states and jounces; T follows by Brent's method.
The grid's error falls as n^-2 (shown by halving n, which the script prints); at n = 500 it is below 5e-5 of T.

    /usr/bin/python3 fourth_order.py      # needs python3-scipy (1.10), about 1 min; durations are rounded to 1e-6
"""
import json
from pathlib import Path

import numpy as np
import scipy.sparse as sparse
from scipy.optimize import brentq, linprog

CASES = (  # velocity, acceleration, jerk, jounce; over distance 1. Limits that are not reached are near.
    ("jounce alone", 3, 10, 90, 384),
    ("jerk", 3, 10, 40, 1000),
    ("jerk and acceleration", 3, 4, 40, 1000),
    ("acceleration without jerk", 3, 4, 60, 200),
    ("all four, with a cruise", 0.9, 4, 40, 1000),
    ("velocity and jerk, with a cruise", 0.6, 6, 40, 1000),
    ("velocity and jounce, with a cruise", 1.2, 10, 90, 384),
    ("velocity and jounce, jerk let go, just no cruise", 1.6817928, 10, 90, 384),
    ("velocity touched with a jerk, jounce alone", 1.9, 10, 90, 384),
    ("velocity touched with a jerk, almost let go", 1.7, 10, 90, 384),
    ("velocity touched with a jerk, acceleration", 1.7, 4, 40, 200),
    ("velocity touched with a jerk, jerk", 2.0, 10, 40, 1000),
)


def longest_way(T, n, v, a, j, s):
    """Of a rest-to-rest move of duration T; states in units of their limits."""
    t = T / n
    step = np.array([[1, t, t**2 / 2, t**3 / 6], [0, 1, t, t**2 / 2], [0, 0, 1, t], [0, 0, 0, 1]])
    push = np.array([t**4 / 24, t**3 / 6, t**2 / 2, t]) * s
    unit = np.array([1.0, v, a, j])
    step = step * unit[None, :] / unit[:, None]
    push = push / unit
    states = sparse.eye(4 * n) - sparse.kron(sparse.eye(n, k=-1), step)
    jounce = -sparse.kron(sparse.eye(n), push[:, None])
    inside = [(None, None)] + 3 * [(-1, 1)]
    at_rest = [(None, None)] + 3 * [(0, 0)]
    goal = np.zeros(5 * n)
    goal[4 * n - 4] = -1
    for presolve in (True, False):  # HiGHS now and then gives up with the one or the other
        found = linprog(goal, A_eq=sparse.hstack([states, jounce]).tocsr(), b_eq=np.zeros(4 * n),
                        bounds=(n - 1) * inside + at_rest + n * [(-1, 1)], method="highs-ds",
                        options={"presolve": presolve})
        if found.status == 0:
            return -found.fun
    raise RuntimeError(found.message)


def least_duration(n, *limits):
    return brentq(lambda T: longest_way(T, n, *limits) - 1, 0.8, 3.0, xtol=1e-7)


def main():
    out = []
    for name, *limits in CASES:
        coarse, fine = least_duration(250, *limits), least_duration(500, *limits)
        print(f"{name}: {coarse:.6f} {fine:.6f}", flush=True)
        out.append(dict(name=name, velocity=limits[0], acceleration=limits[1], jerk=limits[2], jounce=limits[3],
                        duration=round(fine, 6)))
    (Path(__file__).parent / "fourth_order.json").write_text(json.dumps(out, indent=1) + "\n")


if __name__ == "__main__":
    main()
