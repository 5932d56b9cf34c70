#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes cam_then.json: cams that are made from others (examples/cam-algebra), and laws between velocities, with 50
digits and none of the library's code.

The laws are integrals of the shape of their acceleration: two amplitudes solve the stroke and the velocity at the end.
Polynomials solve their boundary conditions. B-splines are evaluated by the recurrence of Cox and de Boor, inverses by
bisection, and all derivatives of a chain by the chain rule.

    python3 cam_then.py           # writes cam_then.json, some seconds; needs python3-mpmath
    python3 cam_then.py --check   # exit status 1 if cam_then.json is not what the script makes
"""
import json
import sys
from pathlib import Path

from mpmath import cos, factorial, lu_solve, matrix, mp, mpf, pi, sin

mp.dps = 50
ZERO = mpf(0)


def out(x):
    return float(0 if abs(x) < mpf(10) ** -40 else x)


# ---- the laws, over z in [0, 1]: each returns f, f', f'', f''' at z ---------------------------------------------------

def poly345(z):
    return [10 * z**3 - 15 * z**4 + 6 * z**5, 30 * z**2 - 60 * z**3 + 30 * z**4, 60 * z - 180 * z**2 + 120 * z**3,
            60 - 360 * z + 360 * z**2]


def cycloid(z):
    w = 2 * pi
    return [z - sin(w * z) / w, 1 - cos(w * z), w * sin(w * z), w * w * cos(w * z)]


def boundary(degree, start, end):
    """The polynomial with the derivatives 0, 1, 2, ... at both ends: its coefficients."""
    n = len(start)
    rows = matrix(2 * n, degree + 1)
    for k in range(n):
        rows[k, k] = factorial(k)
        for i in range(k, degree + 1):
            rows[n + k, i] = factorial(i) / factorial(i - k)
    return list(lu_solve(rows, matrix([*start, *end])))


def polynomial(c, z):
    return [sum((factorial(i) / factorial(i - k) * c[i] * z ** (i - k) for i in range(k, len(c))), ZERO)
            for k in range(4)]


# ---- laws of quarter sines: acceleration by pieces (length, at the start, at the end: sine or cosine) ------------------

def quarter(length, rising):
    """f'' = sin or cos of pi u / (2 length): its integrals from 0, as functions of u."""
    w = pi / (2 * length)
    if rising:
        return lambda u: [u / w - sin(w * u) / w**2, (1 - cos(w * u)) / w, sin(w * u), w * cos(w * u)]
    return lambda u: [(1 - cos(w * u)) / w**2, sin(w * u) / w, cos(w * u), -w * sin(w * u)]


def ramps(first, second, v0, v1):
    """Pieces (length, shape); the first ones have the amplitude A, the second ones -B, from the velocity v0 at 0 to v1
    and the position 1 at 1."""
    def walk(a, b):
        state, pieces, at = [ZERO, mpf(v0)], [], ZERO
        for amplitude, parts in ((a, first), (-b, second)):
            for length, shape in parts:
                pieces.append((at, state[:], amplitude, shape))
                end = shape(length)
                state = [state[0] + state[1] * length + amplitude * end[0], state[1] + amplitude * end[1]]
                at += length
        return state, pieces

    rest, _ = walk(ZERO, ZERO)
    by_a, _ = walk(mpf(1), ZERO)
    by_b, _ = walk(ZERO, mpf(1))
    system = matrix([[by_a[k] - rest[k], by_b[k] - rest[k]] for k in range(2)])
    a, b = lu_solve(system, matrix([mpf(1) - rest[0], mpf(v1) - rest[1]]))
    pieces = walk(a, b)[1]

    def law(z):
        at, state, amplitude, shape = [p for p in pieces if p[0] <= z][-1]
        u = z - at
        own = shape(u)
        return [state[0] + state[1] * u + amplitude * own[0], state[1] + amplitude * own[1], amplitude * own[2],
                amplitude * own[3]]

    return law


def reflected(length, shape_of):
    """A piece run backwards: f''(u) = s(length - u)."""
    def shape(u):
        whole, back = shape_of(length), shape_of(length - u)
        return [whole[1] * u - (whole[0] - back[0]), whole[1] - back[1], back[2], -back[3]]
    return shape


def modified_sine(v0, v1, inflection):
    x = mpf(inflection)
    y = 1 - x
    rise, fall = quarter(x / 4, True), quarter(3 * x / 4, False)
    first = [(x / 4, rise), (3 * x / 4, fall)]
    second = [(3 * y / 4, reflected(3 * y / 4, quarter(3 * y / 4, False))),
              (y / 4, reflected(y / 4, quarter(y / 4, True)))]
    return ramps(first, second, v0, v1)


def harmonic_gu(v0, inflection):
    x = mpf(inflection)
    first = [(x / 4, quarter(x / 4, True)), (3 * x / 4, quarter(3 * x / 4, False))]
    return ramps(first, [(1 - x, quarter(1 - x, True))], v0, 0)


def triple(a1, a2):
    """f'' = a1 sin 2 pi z + a2 sin 4 pi z + a3 sin 6 pi z, from rest; a3 makes the stroke 1."""
    stroke = mpf(a1) / (2 * pi) + mpf(a2) / (4 * pi)
    a3 = (1 - stroke) * 6 * pi
    def law(z):
        f = [ZERO] * 4
        for k, a in ((1, mpf(a1)), (2, mpf(a2)), (3, a3)):
            w = 2 * pi * k
            f = [f[0] + a * (z / w - sin(w * z) / w**2), f[1] + a * (1 - cos(w * z)) / w, f[2] + a * sin(w * z),
                 f[3] + a * w * cos(w * z)]
        return f
    return law


# ---- the cams of the examples -----------------------------------------------------------------------------------------

def placed(law, x, x0, x1, y0, y1):
    length = mpf(x1) - x0
    return [(y0 if k == 0 else 0) + (mpf(y1) - y0) * d / length**k for k, d in enumerate(law((x - x0) / length))]


def pusher(x):
    x = x % 360
    if x < 120:
        return placed(poly345, x, 0, 120, 0, 40)
    if x < 180:
        return [mpf(40), ZERO, ZERO, ZERO]
    if x < 300:
        return placed(cycloid, x, 180, 300, 40, 0)
    return [ZERO] * 4


def wear(x):
    if 120 <= x < 150:
        return placed(poly345, x, 120, 150, 0, mpf(float(0.3)))
    if 150 <= x < 180:
        return placed(poly345, x, 150, 180, mpf(float(0.3)), 0)
    return [ZERO] * 4


SHAFT = boundary(5, [ZERO, mpf(180), ZERO], [mpf(200), mpf(180), ZERO]), boundary(
    5, [mpf(200), mpf(180), ZERO], [mpf(360), mpf(180), ZERO])


def shaft(x):
    part, z = (SHAFT[0], x / 180) if x < 180 else (SHAFT[1], (x - 180) / 180)
    return [d / mpf(180) ** k for k, d in enumerate(polynomial(part, z))]


def chain(f, g):
    return [f[0], f[1] * g[1], f[2] * g[1] ** 2 + f[1] * g[2],
            f[3] * g[1] ** 3 + 3 * f[2] * g[1] * g[2] + f[1] * g[3]]


def inverse(y):
    low, high = ZERO, mpf(120)
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if pusher(middle)[0] < y else (low, middle)
    f = pusher(low)
    return [low, 1 / f[1], -f[2] / f[1] ** 3, (3 * f[2] ** 2 - f[1] * f[3]) / f[1] ** 5]


def longer(x):
    """part to 330 deg, then 30 deg of dwell at 150, then 1.25 of the slave."""
    f = pusher(x if x < 150 else mpf(150) if x < 180 else x - 30)
    return [mpf(5) / 4 * d for d in f]


def de_boor(control, knots, degree, x, order=0):
    """The derivative of a B-spline, by control values of lower degree."""
    control, knots = [mpf(float(c)) for c in control], [mpf(k) for k in knots]
    for _ in range(order):
        control = [degree * (b - a) / (knots[i + degree + 1] - knots[i + 1])
                   for i, (a, b) in enumerate(zip(control, control[1:]))]
        knots, degree = knots[1:-1], degree - 1

    def basis(i, p):
        if p == 0:
            return mpf(1) if knots[i] <= x < knots[i + 1] else ZERO
        left = knots[i + p] - knots[i]
        right = knots[i + p + 1] - knots[i + 1]
        return ((x - knots[i]) / left * basis(i, p - 1) if left else ZERO) + (
            (knots[i + p + 1] - x) / right * basis(i + 1, p - 1) if right else ZERO)

    return sum((c * basis(i, degree) for i, c in enumerate(control)), ZERO)


def lever(x):
    if x < 100:
        control, knots, degree = [0, 0, 0, 10, 15, 20], [0] * 6 + [100] * 6, 5
    elif x < 140:
        return [20 + (x - 100) / 4, mpf(1) / 4, ZERO, ZERO]
    else:
        control = [30, 32.8125, 38.4375, 44, 46, 46, 46]
        knots, degree = [140] * 5 + [185, 230] + [260] * 5, 4
    return [de_boor(control, knots, degree, x, k) for k in range(4)]


def table(f, places):
    rows = [f(mpf(x)) for x in places]
    return {"x": [float(x) for x in places], **{f"f{k}": [out(row[k]) for row in rows] for k in range(4)}}


def septic_with_jerk():
    c = boundary(7, [ZERO, mpf(1), mpf(-2), mpf(30)], [mpf(1), mpf("0.5"), mpf(3), mpf(-12)])
    return lambda z: polynomial(c, z)


def make():
    turn = [mpf(k) * 7 + mpf(1) / 3 for k in range(51)]
    share = [mpf(k) / 32 for k in range(32)]
    laws = {f"modified_sine_gg {v0} {v1} {x}": table(modified_sine(v0, v1, x), share)
            for v0, v1, x in ((0, 0, 0.5), (0.5, 0, 0.5), (0.25, 1.75, 0.5), (-1, 0.5, 0.375))}
    laws |= {f"harmonic_combination_gu {v0} {x}": table(harmonic_gu(v0, x), share)
             for v0, x in ((0, 0.5), (0.5, 0.5), (1, 0.25), (-0.5, 0.625))}
    laws |= {f"triple_harmonic {a} {b}": table(triple(a, b), share) for a, b in ((6.0, 0.75), (5.25, 1.75))}
    laws["triple_harmonic"] = table(triple(9 * pi / 4, 0), share)
    laws["septic with jerk"] = table(septic_with_jerk(), share)
    return {
        "laws": laws,
        "last-year": table(pusher, turn),
        "left-hand": table(lambda x: [40 - f if k == 0 else -f for k, f in enumerate(pusher(x - 30))], turn),
        "corrected": table(lambda x: [a + b for a, b in zip(pusher(x), wear(x))], turn),
        "driven": table(lambda x: chain(pusher(shaft(x)[0]), shaft(x)), turn),
        "longer": table(longer, turn),
        "shaft-of-pusher": table(inverse, [mpf(1) + mpf(k) * 38 / 64 for k in range(64)]),
        "bezier": table(lever, [mpf(k) * 26 / 8 + mpf(1) / 16 for k in range(80)]),
    }


def main():
    text = json.dumps(make(), indent=1, sort_keys=True) + "\n"
    path = Path(__file__).with_suffix(".json")
    if "--check" in sys.argv:
        sys.exit(path.read_text() != text)
    path.write_text(text)


main()
