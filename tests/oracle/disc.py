#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes disc.json: plate cams with roller followers, computed without any of the library's code or formulas.

The roller's center is placed in the machine by plain trigonometry and turned back with the cam; everything else is
numerical differentiation (mpmath, 40 digits) of that path: tangent, normal, curvature. The follower's direction is the
difference of two places with slightly different lift. Extremes are found on a grid of half a degree and refined by
bisection of the numerical derivative. 17 digits are written.

    apt install python3-mpmath
    python3 disc.py            # about a minute
"""
import json
from pathlib import Path

import mpmath as mp

mp.mp.dps = 40
RISE = {
    "345": lambda z: 10 * z**3 - 15 * z**4 + 6 * z**5,
    "inclined_sine": lambda z: z - mp.sin(2 * mp.pi * z) / (2 * mp.pi),
}
KNOTS = [0, 120, 180, 300, 360]  # deg: rise, dwell, return, dwell
STROKE = 10


def lift_piece(law, piece, x):
    f = RISE[law]
    if piece == 0:
        return STROKE * f(x / 120)
    if piece == 1:
        return mp.mpf(STROKE)
    if piece == 2:
        return STROKE * (1 - f((x - 180) / 120))
    return mp.mpf(0)


def center_in_machine(case, lift):
    prime = mp.mpf(case["base_radius"] + case["roller_radius"])
    if case["follower"] == "translating":
        e = mp.mpf(case["offset"])
        return mp.mpc(e, mp.sqrt(prime**2 - e**2) + lift)
    l, c = mp.mpf(case["arm_length"]), mp.mpf(case["center_distance"])
    at_pivot = mp.acos((l**2 + c**2 - prime**2) / (2 * l * c)) + lift / l
    return mp.mpc(c - l * mp.cos(at_pivot), l * mp.sin(at_pivot))


def turn(case):
    return 1 if case["rotation"] == "counterclockwise" else -1


def path(case, piece):
    def center(x):
        return center_in_machine(case, lift_piece(case["law"], piece, x)) * mp.expj(-turn(case) * mp.radians(x))
    return center


def look(case, piece, x):
    """center, contact, pressure angle [rad], curvature at x deg."""
    c = path(case, piece)
    x = mp.mpf(x)
    tangent, second = mp.diff(c, x, 1), mp.diff(c, x, 2)
    normal = tangent / abs(tangent) * 1j * turn(case)  # the cam lies on the right where it turns clockwise under us
    if mp.re(normal * mp.conj(c(x))) < 0:
        raise SystemExit("normal points inwards")
    cross = mp.im(mp.conj(tangent) * second)
    curvature = -turn(case) * cross / abs(tangent) ** 3
    lift, d = lift_piece(case["law"], piece, x), mp.mpf(10) ** -15
    way = center_in_machine(case, lift + d) - center_in_machine(case, lift - d)
    push = normal * mp.expj(turn(case) * mp.radians(x))  # in the machine
    angle = mp.acos(mp.re(push * mp.conj(way)) / abs(way))
    side = -turn(case) * mp.im(mp.conj(push) * way)
    return c(x), c(x) - case["roller_radius"] * normal, mp.sign(side) * angle, curvature


def extreme(case, index, sign):
    best = None
    for piece in range(4):
        a, b = KNOTS[piece], KNOTS[piece + 1]
        g = lambda x, p=piece: sign * look(case, p, x)[index]  # noqa: E731
        grid = [a + mp.mpf(i) / 2 for i in range(2 * (b - a) + 1)] if piece in (0, 2) else [mp.mpf(a)]
        values = [g(x) for x in grid]
        for i, x in enumerate(grid):
            left = values[i - 1] if i > 0 else -mp.inf
            right = values[i + 1] if i + 1 < len(grid) else -mp.inf
            if values[i] < left or values[i] < right:
                continue
            if 0 < i < len(grid) - 1:
                x = mp.findroot(lambda t: mp.diff(g, t), (grid[i - 1], grid[i + 1]), solver="anderson", tol=1e-24)
            if best is None or g(x) > best[0] + mp.mpf(10) ** -15:
                best = (g(x), x)
    return {"value": float(sign * best[0]), "where": float(best[1])}


def cases():
    base = {"base_radius": 20, "roller_radius": 8}
    slide = {"follower": "translating"}
    arm = {"follower": "oscillating", "arm_length": 40, "center_distance": 50}
    for law in RISE:
        for geometry in ({**slide, "offset": 0}, {**slide, "offset": 5}, arm):
            for rotation in ("counterclockwise", "clockwise"):
                yield {"law": law, **base, **geometry, "rotation": rotation}


def make(case):
    points = []
    for piece, x in [(0, 1), (0, 17.5), (0, 60), (0, 111.25), (1, 150), (2, 190.5), (2, 240), (2, 299), (3, 330)]:
        center, contact, angle, curvature = look(case, piece, x)
        points.append({"master": x, "center": [float(center.real), float(center.imag)],
                       "contact": [float(contact.real), float(contact.imag)],
                       "pressure_angle": float(angle), "pitch_curvature": float(curvature)})
    extremes = {f"{name}_{bound}": extreme(case, index, sign)
                for index, name in ((2, "pressure_angle"), (3, "pitch_curvature"))
                for bound, sign in (("max", 1), ("min", -1))}
    return {**case, "points": points, **extremes}


def main():
    target = Path(__file__).with_name("disc.json")
    text = json.dumps([make(case) for case in cases()], indent=1, sort_keys=True)
    target.write_text(text + "\n", encoding="ascii")


main()
