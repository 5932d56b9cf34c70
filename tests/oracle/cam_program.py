#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A program as a CAM system writes it: a free-form surface finished in parallel passes of short lines.

usage: cam_program.py FILE [LINES]   writes the program, about LINES blocks (30000); tests/io/cam_program_test.cpp plans it

The surface is z = 6 sin(x / 17) cos(y / 23) + 0.1 (x - 60)^2 / 60. As in real programs: points by a chord error of
0.005 mm, so lines of 0.2 to 2 mm; coordinates rounded to 0.001 mm, so directions tremble; modal words left out; a roughing
contour with arcs and a drilled corner before it; retracts at G0; spindle and coolant.
"""
import math
import sys
from pathlib import Path

DEVIATION = 0.02  # mm, G64 P
CHORD = 0.005


def height(x, y):
    return 6 * math.sin(x / 17) * math.cos(y / 23) + 0.1 * (x - 60) ** 2 / 60


def bend(x, y):
    """Curvature of the surface along x, about."""
    return abs(-6 / 17**2 * math.sin(x / 17) * math.cos(y / 23) + 0.2 / 60)


def passes(lines):
    """Points of each pass, there and back, as many as give about so many lines."""
    y, made, forward = 0.0, 0, True
    while made < lines:
        xs = [0.0]
        while xs[-1] < 120:
            chord = math.sqrt(8 * CHORD / max(bend(xs[-1], y), 1e-3))
            xs.append(min(xs[-1] + min(max(chord, 0.2), 2.0), 120.0))
        points = [(x, y, height(x, y)) for x in (xs if forward else reversed(xs))]
        yield points
        made += len(points)
        forward, y = not forward, y + 0.25


class Writer:
    def __init__(self):
        self.lines, self.last = [], {}

    def move(self, code, feed=None, **words):
        text = [f"N{10 * (len(self.lines) + 1)}"]
        if self.last.get("G") != code:
            text.append(code)
            self.last["G"] = code
        for letter, value in words.items():
            shown = f"{letter}{value:.3f}".rstrip("0")
            if letter in "IJ" or self.last.get(letter) != shown:
                text.append(shown)
                self.last[letter] = shown
        if feed and self.last.get("F") != feed:
            text.append(f"F{feed}")
            self.last["F"] = feed
        self.lines.append(" ".join(text))

    def word(self, text):
        self.lines.append(f"N{10 * (len(self.lines) + 1)} {text}")


def program(lines):
    w = Writer()
    w.lines.append("(surface, ball nose 6 mm)")
    for text in ("G21 G90 G17 G40 G49 G80 G94", "T1 M6", "S18000 M3", "M8", f"G54 G64 P{DEVIATION}"):
        w.word(text)
    w.move("G0", X=-10, Y=-10, Z=20)
    w.move("G0", Z=2)
    w.move("G1", feed=900, Z=-1)
    w.move("G1", feed=3000, X=125)  # the contour with rounded corners
    w.move("G3", X=130, Y=-5, I=0, J=5)
    w.move("G1", Y=30)
    w.move("G3", X=125, Y=35, I=-5, J=0)
    w.move("G1", X=-5)
    w.move("G3", X=-10, Y=30, I=0, J=-5)
    w.move("G1", Y=-10)
    w.move("G0", Z=20)
    first = True
    for points in passes(lines):
        x, y, z = points[0]
        if first:
            w.move("G0", X=x, Y=y)
            w.move("G0", Z=z + 2)
            w.move("G1", feed=1200, Z=z)
        else:
            w.move("G1", X=x, Y=y, Z=z)
        first = False
        for x, y, z in points[1:]:
            w.move("G1", feed=6000, X=x, Y=y, Z=z)
    w.move("G0", Z=30)
    for text in ("M9", "M5", "M30"):
        w.word(text)
    return "\n".join(w.lines) + "\n"


def main():
    lines = int(sys.argv[2]) if len(sys.argv) > 2 else 30000
    Path(sys.argv[1]).write_text(program(lines), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
