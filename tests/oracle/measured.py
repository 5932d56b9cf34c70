#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measured cams: closed forms of known laws, with the error of an encoder.

Writes measured.json and examples/measured-cam/measured.csv (--check: exit status 1 if they differ from what this
makes). The laws are their formulas in VDI 2143 and in Norton's handbook, not the library's segments. The error of each
point is uniform; the sum is then rounded to the resolution of the encoder. The generator is the linear congruential one
of Numerical Recipes, so the files are the same with every version of Python. `truth` is the cam without error, at
places that are no points.
"""
import json
import os
import sys
from math import cos, floor, pi, sin

HERE = os.path.dirname(os.path.abspath(__file__))
EXAMPLE = os.path.join(HERE, "..", "..", "examples", "measured-cam", "measured.csv")


class Noise:
    def __init__(self, seed):
        self.state = seed

    def uniform(self, amplitude):
        self.state = (1664525 * self.state + 1013904223) % 2**32
        return amplitude * (2 * self.state / 2**32 - 1)


def modified_sine(z):
    k = 1 / (4 + pi)
    if z < 1 / 8:
        return k * (pi * z - sin(4 * pi * z) / 4)
    if z < 7 / 8:
        return k * (2 + pi * z - 9 / 4 * sin((4 * pi * z + pi) / 3))
    return k * (4 + pi * z - sin(4 * pi * z) / 4)


LAWS = {
    "poly345": lambda z: z**3 * (10 - 15 * z + 6 * z * z),
    "poly4567": lambda z: z**4 * (35 - 84 * z + 70 * z * z - 20 * z**3),
    "inclined_sine": lambda z: z - sin(2 * pi * z) / (2 * pi),
    "simple_sine": lambda z: (1 - cos(pi * z)) / 2,
    "modified_sine": modified_sine,
    "dwell": lambda z: 0,
    "line": lambda z: z,
}


NAMES = {"poly345": "345", "poly4567": "4567", "joined": "345"}  # words of the spec


def entering(z):
    """Degree 5 with the slope 1 at 0 and no other value at its ends."""
    return z - 6 * z**3 + 8 * z**4 - 3 * z**5


def joined(z, v0, v1, length, stroke):
    """Degree 5 from 0 to stroke, with the velocities v0 and v1 and without acceleration at both ends."""
    return stroke * LAWS["poly345"](z) + v0 * length * entering(z) - v1 * length * entering(1 - z)


def inflected(law, share):
    """The law with its velocity peak at this share."""
    return lambda z: (2 * share * law(z / (2 * share)) if z < share
                      else 1 - 2 * (1 - share) * law((1 - z) / (2 * (1 - share))))


class Piecewise:
    """Segments [law, end master, end slave]; "joined" has the velocities of the lines beside it."""

    def __init__(self, segments, start=(0, 0)):
        self.parts = []
        master, slave = start
        ends = [start] + [(s[1], s[2]) for s in segments]
        slopes = [(b[1] - a[1]) / (b[0] - a[0]) for a, b in zip(ends, ends[1:])]
        for i, segment in enumerate(segments):
            law = segment[0]
            straight = lambda k: slopes[k % len(segments)] if segments[k % len(segments)][0] == "line" else 0
            self.parts.append((master, segment[1], slave, segment[2], law, straight(i - 1), straight(i + 1)))
            master, slave = segment[1], segment[2]

    def __call__(self, x):
        for a, b, p, q, law, v0, v1 in self.parts:
            if x <= b:
                z = (x - a) / (b - a)
                if law == "joined":
                    return p + joined(z, v0, v1, b - a, q - p)
                shape = LAWS[law] if isinstance(law, str) else law
                return p + (q - p) * shape(z)
        raise ValueError(x)


def case(name, f, end, points, noise, resolution, tolerance, seed, knots, laws, periodic=True, wrap=True):
    rng = Noise(seed)
    rows = []
    for i in range(points + 1):
        x = end * i / points
        y = f(x) + rng.uniform(noise)
        if resolution:
            y = floor(y / resolution + 0.5) * resolution
        rows.append([x, y])
    if periodic and wrap:
        rows[-1][1] = rows[0][1]
    truth = [[x, f(x)] for x in (end * (k + 0.37) / 251 for k in range(251))]
    return {"name": name, "points": rows, "tolerance": tolerance, "periodic": periodic, "truth": truth,
            "knots": knots, "laws": laws}


def made():
    all_cases = []

    def law_cam(name, segments, knots=None, **kwargs):
        f = Piecewise(segments, kwargs.pop("start", (0, 0)))
        laws = [s[0] if isinstance(s[0], str) else kwargs.get("named") for s in segments]
        kwargs.pop("named", None)
        laws = [NAMES.get(law, law) for law in laws]
        all_cases.append(case(name, f, segments[-1][1], knots=[[s[1], s[2]] for s in segments], laws=laws, **kwargs))

    encoder = {"points": 720, "noise": 0.008, "resolution": 0.001, "tolerance": 0.02}
    law_cam("two dwells", [["modified_sine", 120, 50], ["dwell", 180, 50], ["inclined_sine", 300, 0], ["dwell", 360, 0]],
            seed=1, **encoder)
    law_cam("odd knots", [["dwell", 21.7, 0], ["poly345", 133.3, 37.5], ["dwell", 190, 37.5], ["modified_sine", 287.9, 0],
                          ["dwell", 360, 0]], seed=2, **encoder)
    law_cam("without noise", [["poly4567", 150, 80], ["dwell", 200, 80], ["poly345", 360, 0]], seed=3, points=360, noise=0,
            resolution=0, tolerance=0.01)
    law_cam("reversal", [["poly345", 150, 40], ["inclined_sine", 300, 0], ["dwell", 360, 0]], seed=4, **encoder)
    law_cam("eccentric", [["simple_sine", 180, 30], ["simple_sine", 360, 0]], seed=5, **encoder)
    law_cam("line", [["dwell", 40, 0], ["joined", 90, 12], ["line", 210, 72], ["joined", 260, 84], ["dwell", 270, 84],
                     ["poly345", 360, 0]], seed=6, **encoder)
    law_cam("inflection", [["dwell", 60, 0], [inflected(LAWS["poly345"], 0.35), 200, 60], ["dwell", 240, 60],
                           ["inclined_sine", 360, 0]], seed=7, named="345", **encoder)
    law_cam("not periodic", [["dwell", 10, 5], ["modified_sine", 70, 25], ["dwell", 90, 25]], seed=8, start=(0, 5), periodic=False,
            points=360, noise=0.008, resolution=0.001, tolerance=0.02)
    knife = Piecewise([["line", 60, 60], ["joined", 300, 240], ["line", 360, 300]])
    all_cases.append(case("knife", knife, 360, knots=[[60, 60], [300, 240], [360, 300]], laws=["line", "345", "line"],
                          seed=9, wrap=False, **encoder))
    free = lambda x: 20 * sin(pi * x / 180 + 0.3) + 4 * sin(2 * pi * x / 180) + 1.5 * cos(3 * pi * x / 180)
    all_cases.append(case("no law", free, 360, knots=None, laws=None, seed=10, **encoder))
    return all_cases


def check_laws():
    """Each law goes from 0 to 1, and its slope is 0 at both ends and continuous."""
    for name, law in LAWS.items():
        if name in ("dwell", "line"):
            continue
        assert abs(law(0)) < 1e-15 and abs(law(1) - 1) < 1e-14, name
        step = 1e-6
        slopes = [(law(z + step) - law(z - step)) / (2 * step) for z in [k / 1000 for k in range(1, 1000)]]
        assert all(abs(a - b) < 0.02 for a, b in zip(slopes, slopes[1:])), name
        assert abs(law(step) - law(0)) / step < 1e-4 and abs(law(1) - law(1 - step)) / step < 1e-4, name


def example():
    """The case "odd knots" with a point per degree, as a measuring machine writes it."""
    rows = next(c for c in made() if c["name"] == "odd knots")["points"][::2]
    return "# cam of an unknown feeder, encoder of 1 um\nmaster [deg],slave [mm]\n" + "".join(
        f"{x:g},{y:.3f}\n" for x, y in rows)


if __name__ == "__main__":
    check_laws()
    text = json.dumps(made(), indent=None, separators=(",", ":")).replace('{"name"', '\n{"name"') + "\n"
    files = {os.path.join(HERE, "measured.json"): text, EXAMPLE: example()}
    if "--check" in sys.argv:
        same = all(open(path).read() == content for path, content in files.items())
        print("the files are what measured.py makes" if same else "measured.json or measured.csv differs")
        sys.exit(0 if same else 1)
    for path, content in files.items():
        open(path, "w").write(content)
