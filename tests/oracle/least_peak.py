#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes least_peak.json: the least max |f''| of cams of quintics over the velocities and accelerations left free, by
linear programming on a grid of 2000 intervals a segment; none of the library's code is used.

A grid can only allow too much between its points: the true least peak lies between the number written and
1 + 3e-6 times it (f'' exceeds t between points h apart by at most h^2 max |f''''| / 8, and a cubic that stays within t on
[0, 1] has a second derivative of at most 96 t: Markov).

    /usr/bin/python3 least_peak.py      # needs python3-scipy (1.10), some seconds; values are rounded to 1e-9
"""
import json
from pathlib import Path

import numpy as np
import scipy.sparse as sparse
from scipy.optimize import linprog

GRID = 2000
CASES = (  # knots: master, slave, velocity, acceleration (None: free)
    {"name": "end free", "periodic": False, "knots": ((0, 0, 0, 0), (1, 1, None, None))},
    {"name": "middle free", "periodic": False, "knots": ((0, 0, 0, 0), (1, 0.25, None, None), (3, 1, 0, 0))},
    {"name": "one velocity given", "periodic": False,
     "knots": ((0, 0, 0, 0), (0.5, 2, 1, None), (2, 1, None, None), (2.5, 1.5, None, 0), (4, 0, 0, 0))},
    {"name": "periodic", "periodic": True,
     "knots": ((0, 0, None, None), (60, 12, None, None), (150, 40, None, None), (240, 25, None, None),
               (360, 0, None, None))},
)


def second_derivative(length):
    """Rows: grid points; columns: p0, v0, a0, p1, v1, a1."""
    condition = []
    for z in (0.0, 1.0):
        for order in range(3):
            row = [0.0] * 6
            for k in range(order, 6):
                row[k] = np.prod(range(k - order + 1, k + 1)) * z ** (k - order)
            condition.append(row)
    coefficients = np.linalg.inv(np.array(condition))
    z = np.linspace(0, 1, GRID + 1)
    second = np.stack([k * (k - 1) * z ** max(k - 2, 0) for k in range(6)], axis=1)
    scale = np.array([1, length, length**2] * 2) / length**2
    return second @ coefficients * scale


def least(case):
    knots, last = case["knots"], len(case["knots"]) - 1
    index = {}
    for i, knot in enumerate(knots):
        for order in (2, 3):
            if knot[order] is None:
                index[i, order] = index[0, order] if case["periodic"] and i == last else len(set(index.values()))
    n = len(set(index.values()))
    rows, right = [], []
    for i in range(last):
        a = second_derivative(knots[i + 1][0] - knots[i][0])
        block, constant = np.zeros((GRID + 1, n)), np.zeros(GRID + 1)
        for column, (k, order) in enumerate(((i, 1), (i, 2), (i, 3), (i + 1, 1), (i + 1, 2), (i + 1, 3))):
            if (k, order) in index:
                block[:, index[k, order]] += a[:, column]
            else:
                constant += a[:, column] * knots[k][order]
        for sign in (1, -1):
            rows.append(np.hstack([sign * block, -np.ones((GRID + 1, 1))]))
            right.append(-sign * constant)
    found = linprog([0] * n + [1], A_ub=sparse.csr_matrix(np.vstack(rows)), b_ub=np.hstack(right),
                    bounds=[(None, None)] * (n + 1), method="highs",
                    options={"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10})
    assert found.status == 0, found.message
    return round(found.fun, 9)


def main():
    rows = [{**case, "peak": least(case)} for case in CASES]
    Path(__file__).with_name("least_peak.json").write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")


main()
