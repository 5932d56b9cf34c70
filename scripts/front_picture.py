#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/pictures/front.svg: peak acceleration against peak jerk of the laws, and the front none can pass.

usage: front_picture.py > docs/pictures/front.svg
Closed forms only; the certificates' tests hold the same numbers against the library.
"""
from math import log, pi, sqrt

LAWS = [  # name, Cj, Ca
    ("perfect spline", 32, 8),
    ("inclined sine", 4 * pi**2, 2 * pi),
    ("Freudenstein 1-3", 36 * pi**2 / 7, 12 * pi / 7),
    ("4-5-6-7", 52.5, 84 / (5 * sqrt(5))),
    ("Gutman 1-3", 6 * pi**2, 5.130199),
    ("3-4-5", 60, 10 / sqrt(3)),
    ("modified trapezoid", 32 * pi**2 / (2 + pi), 8 * pi / (2 + pi)),
    ("modified sine", 16 * pi**3 / (4 + pi), 4 * pi**2 / (4 + pi)),
    ("5-6-7-8-9", 78.75, 9.371976),
]
WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 640, 400, 56, 24, 20, 48


def x(cj):
    return LEFT + (WIDTH - LEFT - RIGHT) * log(cj / 30) / log(120 / 30)


def y(ca):
    return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * (ca - 3.5) / 6.5


def front(cj):
    return cj / 4 * (1 - sqrt(1 - 32 / cj))


def text(at, words, anchor="start", extra=""):
    return f'<text x="{at[0]:.1f}" y="{at[1]:.1f}" text-anchor="{anchor}"{extra}>{words}</text>'


def main():
    curve = [(32 + 88 * (i / 200) ** 2) for i in range(201)]
    line = " ".join(f"{x(c):.1f},{y(front(c)):.1f}" for c in curve)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="12">',
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#fff"/>']
    for cj in (32, 40, 50, 60, 80, 100, 120):
        out.append(f'<path d="M{x(cj):.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#e3e6ea"/>')
        out.append(text((x(cj), HEIGHT - BOTTOM + 18), cj, "middle"))
    for ca in range(4, 11):
        out.append(f'<path d="M{LEFT} {y(ca):.1f}H{WIDTH - RIGHT}" stroke="#e3e6ea"/>')
        out.append(text((LEFT - 8, y(ca) + 4), ca, "end"))
    low = y(3.5)
    out.append(f'<polygon points="{x(30):.1f},{y(10):.1f} {x(32):.1f},{y(10):.1f} {line} {x(120):.1f},{low:.1f} {x(30):.1f},{low:.1f}" fill="#f3d9d5"/>')
    out.append(f'<polyline points="{x(32):.1f},{y(10):.1f} {line}" fill="none" stroke="#b3372a" stroke-width="2"/>')
    out.append(text((x(33), y(4.1)), "no motion can be here", extra=' fill="#8c2a20"'))
    for name, cj, ca in LAWS:
        out.append(f'<circle cx="{x(cj):.1f}" cy="{y(ca):.1f}" r="4" fill="#1f5fa8"/>')
        out.append(text((x(cj) + 8, y(ca) + 4), name))
    out.append(text((WIDTH / 2, HEIGHT - 10), "Cj, peak jerk (logarithmic)", "middle"))
    out.append(text((14, HEIGHT / 2), "Ca, peak acceleration", "middle", f' transform="rotate(-90 14 {HEIGHT / 2})"'))
    out.append("</svg>")
    print("\n".join(out))


main()
