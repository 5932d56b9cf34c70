#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/pictures/blending.svg: how the buffer modes pass the first target, over position.

usage: blending_picture.py > docs/pictures/blending.svg

Closed forms, v^2 = v0^2 + 2 a s: an implementation of its own. Standard library alone.
"""
from math import sqrt

A = 200.0  # u/s^2
FIRST, END = 50.0, 100.0  # u: the targets
MODES = (("buffered", "#777", lambda a, b: 0.0), ("low", "#2e8b57", min), ("previous", "#8e44ad", lambda a, b: a),
         ("next", "#c0392b", lambda a, b: b), ("high", "#1f5fa8", max))
PANEL, TOP, HIGH = 330, 44, 150


def velocity(s, own, begin, end, length):
    """At s of a move at its own velocity, from one velocity to another."""
    faster = end > own  # then it speeds up at the end
    ramp = (own * own + 2 * A * (s - (length - (end * end - own * own) / (2 * A)))) if faster else None
    up = sqrt(begin * begin + 2 * A * s) if begin < own else sqrt(max(begin * begin - 2 * A * s, own * own))
    if faster:
        return sqrt(ramp) if ramp > own * own else min(up, own)
    cruise = up if begin > own else min(up, own)
    return min(cruise, sqrt(end * end + 2 * A * (length - s)))


def curve(v1, v2, through):
    for i in range(401):
        s = END * i / 400
        yield s, (velocity(s, v1, 0.0, through, FIRST) if s < FIRST else
                  velocity(s - FIRST, v2, through, 0.0, END - FIRST))


def panel(left, v1, v2):
    at = lambda s, v: (left + 250 * s / END, TOP + HIGH - HIGH * v / 100)
    x = at(FIRST, 0)[0]
    print(f'<path d="M{x:.1f} {TOP}V{TOP + HIGH}" stroke="#bbb" stroke-dasharray="3 3"/>'
          f'<path d="M{left} {TOP + HIGH}H{left + 250}" stroke="#777"/>'
          f'<text x="{left}" y="{TOP - 12}">{v1:g} u/s, then {v2:g} u/s</text>'
          f'<text x="{x:.1f}" y="{TOP + HIGH + 16}" text-anchor="middle">first target</text>'
          f'<text x="{left + 250}" y="{TOP + HIGH + 16}" text-anchor="end">second</text>')
    for v in (0, 50, 100):
        print(f'<text x="{left - 6}" y="{at(0, v)[1] + 4:.1f}" text-anchor="end">{v}</text>')
    drawn = {}
    for name, color, through in MODES:
        drawn.setdefault(through(v1, v2), []).append((name, color))
    for k, (through, names) in enumerate(sorted(drawn.items())):
        color = names[0][1]
        points = " ".join("{:.1f},{:.1f}".format(*at(s, v)) for s, v in curve(v1, v2, through))
        print(f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="1.6"/>'
              f'<text x="{left}" y="{TOP + HIGH + 36 + 16 * k}" fill="{color}">'
              f'{", ".join(n for n, _ in names)}: through at {through:g} u/s</text>')


print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {2 * PANEL} 300" font-family="sans-serif" font-size="12">')
print('<title>Velocity over position: how the blending modes pass the first target</title>')
print(f'<rect width="{2 * PANEL}" height="300" fill="white"/>')
panel(50, 40.0, 80.0)
panel(50 + PANEL, 80.0, 40.0)
print('</svg>')
