#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the drawing of a cam plate, examples/cam-plate/plate.dxf, from its motion.

The roller is placed by plain trigonometry, for each angle of the cam. Its rim touches the plate beside the velocity of
its center, at the distance of its radius. Arcs through three points of this curve become the polyline.

plate.py           writes the file
plate.py --check   compares the file with a new computation
"""
import cmath
import math
import pathlib
import sys

BASE, ROLLER, OFFSET = 25.0, 7.0, -4.0  # mm
CENTER, TURN = 100 + 80j, math.radians(30)  # place and direction of the plate in the drawing
RISE = 12.0  # mm


def smooth(z):
    """3-4-5 polynomial and its derivative."""
    return z**3 * (10 - 15 * z + 6 * z * z), 30 * z * z * (1 - z) ** 2


def cycloid(z):
    return z - math.sin(2 * math.pi * z) / (2 * math.pi), 1 - math.cos(2 * math.pi * z)


def lift(angle):
    """Lift (mm) and its derivative (mm/deg) at an angle of the cam in degrees."""
    if 20 <= angle <= 120:
        s, v = smooth((angle - 20) / 100)
        return RISE * s, RISE * v / 100
    if 120 < angle < 180:
        return RISE, 0.0
    if 180 <= angle <= 300:
        s, v = cycloid((angle - 180) / 120)
        return RISE * (1 - s), -RISE * v / 120
    return 0.0, 0.0


def profile(angle):
    """Point of the plate under the roller, in the frame of the cam (a complex number)."""
    s, v = lift(angle)
    height = math.sqrt((BASE + ROLLER) ** 2 - OFFSET**2) + s
    fixed = complex(OFFSET, height)
    # The roller passes the cam with the velocity of its slide minus that of the cam below it, per radian.
    motion = 1j * math.degrees(v) - 1j * fixed
    inward = 1j * motion / abs(motion)
    if (inward * fixed.conjugate()).real > 0:
        inward = -inward
    return (fixed + ROLLER * inward) * cmath.exp(-1j * math.radians(angle))


def drawn(point):
    return CENTER + point * cmath.exp(1j * TURN)


def bulge(a, m, b):
    return math.tan(cmath.phase((b - m) / (m - a)) / 2)


def group(code, value):
    return f"{code}\n{value}\n"


def circle(layer, center, radius):
    return (group(0, "CIRCLE") + group(8, layer) + group(10, f"{center.real:.9f}") + group(20, f"{center.imag:.9f}")
            + group(40, radius))


def text():
    out = group(0, "SECTION") + group(2, "HEADER") + group(9, "$INSUNITS") + group(70, 4) + group(0, "ENDSEC")
    out += group(0, "SECTION") + group(2, "ENTITIES")
    steps = 360
    out += group(0, "LWPOLYLINE") + group(8, "PLATE") + group(90, steps) + group(70, 1)
    for i in range(steps):
        a, m, b = (drawn(profile((i + k) % 360)) for k in (0, 0.5, 1))
        out += group(10, f"{a.real:.9f}") + group(20, f"{a.imag:.9f}") + group(42, f"{bulge(a, m, b):.12f}")
    out += circle("PLATE", CENTER, 10) + circle("PLATE", drawn(14j), 2)  # bore and pin
    out += group(0, "TEXT") + group(8, "NOTES") + group(10, 40) + group(20, 20) + group(40, 3) + group(1, "plate 7, steel")
    out += group(0, "LINE") + group(8, "NOTES") + group(10, 40) + group(20, 18) + group(11, 90) + group(21, 18)
    return out + group(0, "ENDSEC") + group(0, "EOF")


def main():
    path = pathlib.Path(__file__).resolve().parents[2] / "examples/cam-plate/plate.dxf"
    if "--check" in sys.argv:
        return 0 if path.read_text() == text() else print(f"{path} differs: run {sys.argv[0]}") or 1
    path.write_text(text())
    return 0


if __name__ == "__main__":
    sys.exit(main())
