#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Rotary knives: closed forms, and recoveries from their boundary values by linear algebra.

Writes knife.json (--check: exit status 1 if the file is not what this makes). None of the library's code or formulas of
its recovery: each is solved from its boundary values, the longest cut is where its least slope, found by solving for
the critical points, is zero, and the blade is simulated as a point on a circle over a running web.
"""
import json
import os
import sys

from mpmath import acos, asin, cos, diff, findroot, inf, lu_solve, matrix, mp, mpf, pi, polyroots, polyval, sin, sqrt

mp.dps = 40
HERE = os.path.dirname(os.path.abspath(__file__))


def out(x):
    return float(mp.nstr(x, 17))


# Peaks of the laws from rest to rest, from cams.md's closed forms (VDI 2143, Norton).
CV = {
    "cubic": mpf(3) / 2, "parabola": mpf(2), "simple_sine": pi / 2, "inclined_sine": mpf(2),
    "modified_sine": 4 * pi / (4 + pi), "modified_trapezoid": mpf(2), "345": mpf(15) / 8, "4567": mpf(35) / 16,
    "56789": mpf(315) / 128, "gutman_13": mpf(2), "freudenstein_13": mpf(2), "freudenstein_135": mpf(2),
    "minimum_peak_jerk": mpf(2), "modified_constant_velocity": 8 * pi / (5 * pi + 4),
    "sine_straight": 1 / (mpf(1) / 2 + 2 * mpf(1) / 2 / pi),
}


def printed(value, text):
    digits = len(text.split(".")[1])
    assert abs(value - mpf(text)) <= mpf(10) ** -digits * mpf("0.5000001"), (value, text)


def polynomial(b, left, right):
    """Ascending coefficients of the polynomial of least degree with these derivatives at 0 and b."""
    n = len(left) + len(right)
    a, y = matrix(n, n), matrix(n, 1)
    for i, (x, values) in enumerate(((mpf(0), left), (b, right))):
        for k, value in enumerate(values):
            row = i * len(left) + k
            y[row] = value
            for j in range(k, n):
                a[row, j] = mp.factorial(j) / mp.factorial(j - k) * (x ** (j - k) if j > k else 1)
    return [c for c in lu_solve(a, y)]


def derived(c, k):
    for _ in range(k):
        c = [i * x for i, x in enumerate(c)][1:]
    return c


def at(c, x):
    return polyval(c[::-1], x)


def extremes(c, b):
    places = [mpf(0), b]
    d = derived(c, 1)
    while len(d) > 1 and abs(d[-1]) * b ** (len(d) - 1) < mpf(10) ** -25 * max(abs(x) for x in d):
        d = d[:-1]  # a symmetric recovery loses its leading terms
    if len(d) > 1:
        places += [r.real for r in polyroots(d[::-1], maxsteps=500, extraprec=400)
                   if abs(r.imag) < mpf(10) ** -15 * b and 0 < r.real < b]
    values = [at(c, x) for x in places]
    return min(values), max(values)


def case_y():
    d, v, length, theta = mpf(3), mpf(20), mpf("4.71"), 10 * pi / 180
    r = d / 2
    c, s = pi * d, r * theta
    b, h = length - s, 2 * pi - theta
    recovery = polynomial(b, [0, 1 / r, 0], [h, 1 / r, 0])
    low, high = extremes(derived(recovery, 1), b)
    _, peak = extremes(derived(recovery, 2), b)
    longest = s + findroot(lambda x: extremes(derived(polynomial(x, [0, 1 / r, 0], [h, 1 / r, 0]), 1), x)[0],
                           (mpf(18), mpf(21)), solver="anderson", tol=mpf(10) ** -50)
    rho = b / (r * h)
    rpm = 60 * v / (2 * pi)
    for value, text in ((c, "9.424778"), (s, "0.261799"), (b, "4.448201"), (h, "6.108652"), (rho, "0.485454"),
                        (high * r, "2.987367"), (rpm / r, "127.3240"), (rpm * high, "380.3634"),
                        (peak * v * v, "366.8602"), (longest, "19.896753")):
        printed(value, text)
    return {"synchronous": out(c), "sync_length": out(s), "recovery_length": out(b), "recovery_angle": out(h),
            "rho": out(rho), "surface_ratio": out(high * r), "sync_rpm": out(rpm / r), "peak_rpm": out(rpm * high),
            "acceleration": out(peak * v * v), "longest": out(longest)}


def horizontal(diameter, blades, degrees, length, ratio, jerk):
    """Recovery through slope, acceleration (and jerk) of asin(k x / R), differentiated numerically."""
    r, half, k = mpf(diameter) / 2, mpf(degrees) * pi / 360, mpf(ratio)
    sigma = r * sin(half) / k
    psi = lambda x: asin(k * x / r)
    orders = 3 if jerk else 2
    leave = [diff(psi, sigma, n) for n in range(1, orders + 1)]
    enter = [diff(psi, -sigma, n) for n in range(1, orders + 1)]
    h = 2 * pi / blades - 2 * half
    make = lambda b: polynomial(b, [0] + leave, [h] + enter)
    b = mpf(length) - 2 * sigma
    c = make(b)
    first, second, third = (extremes(derived(c, n), b) for n in (1, 2, 3))
    zero = findroot(lambda x: extremes(derived(make(x), 1), x)[0], (b / 4, 40 * r), solver="anderson", tol=mpf(10) ** -40)
    return {"diameter": float(diameter), "blades": blades, "degrees": float(degrees), "length": float(length),
            "ratio": float(ratio), "jerk": jerk, "sync_length": out(2 * sigma), "longest": out(2 * sigma + zero),
            "velocity": [out(x) for x in first], "acceleration": [out(x) for x in second],
            "third": [out(x) for x in third],
            "angles": [[out(sigma + b * i / 8), out(half + at(c, b * i / 8))] for i in range(9)],
            "in_step": [[out(sigma * i / 8), out(psi(sigma * i / 8))] for i in range(9)]}


def contact(diameter, thickness):
    """The blade's tip falls onto the web: the first angle at which it is as high as the web is thick."""
    r = mpf(diameter) / 2
    angle = findroot(lambda a: r - r * cos(a) - mpf(thickness), mp.sqrt(2 * mpf(thickness) / r))
    assert abs(angle - acos(1 - mpf(thickness) / r)) < mpf(10) ** -30
    return {"diameter": float(diameter), "thickness": float(thickness), "angle": out(angle)}


def shortest(v, vmax, amax, jmax):
    """Case Y's knife at v: the shortest cut under each limit alone, each its own equation in b."""
    r, theta = mpf(3) / 2, 10 * pi / 180
    h, s = 2 * pi - theta, r * theta
    peak = lambda b, n: max(map(abs, extremes(derived(polynomial(b, [0, 1 / r, 0], [h, 1 / r, 0]), n), b)))
    find = lambda n, most: out(s + findroot(lambda b: peak(b, n) * mpf(v) ** n - most, (mpf("0.2"), mpf(9)),
                                            solver="anderson", tol=mpf(10) ** -30))
    return {"speed": v, "velocity": [vmax, find(1, vmax)], "acceleration": [amax, find(2, amax)],
            "jerk": [jmax, find(3, jmax)]}


def make():
    return {
        "case_y": case_y(),
        "longest_factor": {law: out(cv / (cv - 1)) for law, cv in CV.items()},
        "horizontal": [horizontal(d, n, a, length, k, j)
                       for d, n, a, length, k in (("3", 1, "10", "4.71", "1"), ("200", 2, "60", "250", "1"),
                                                  ("318.31", 3, "40", "500", "1.005"))
                       for j in (False, True)],
        "contact": [contact("300", "5"), contact("3", "0.125")],
        "shortest": shortest(20, 40, 400, 12000),
    }


def main():
    text = json.dumps(make(), indent=1, sort_keys=True) + "\n"
    path = os.path.join(HERE, "knife.json")
    if "--check" in sys.argv:
        sys.exit(open(path).read() != text)
    open(path, "w").write(text)


main()
