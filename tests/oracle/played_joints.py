#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Forward kinematics of the joints that `jounce design` makes of examples/kinematics: the tool must be on its path.

usage: played_joints.py JOUNCE EXAMPLES   exit status 1 if anything differs

The rules of the robots are written here anew, from their geometry: the positions of the two arms of a SCARA, the point of
three rods of one length (trilateration), the belt of CoreXY. The curves of the joints are read from the JSON of
`--curve` and evaluated with 40 digits. Every tool position must be on the lines and arcs of the spec, or within the
deviation of a corner, and equal the axes of the tool.
"""
import json
import subprocess
import sys
import tempfile
import tomllib
from bisect import bisect_right
from pathlib import Path

from mpmath import cos, mp, mpf, pi, sin, sqrt

mp.dps = 40


def scara(spec, joints):
    a, b = [mpf(x) for x in spec["arms"]]
    first, second = [j * pi / 180 for j in joints]
    return [a * cos(first) + b * cos(first + second), a * sin(first) + b * sin(first + second)]


def linear_delta(spec, joints):
    """The lower of the two points at distance `arm` from the three carriages, moved inwards by the plate's radius."""
    r = mpf(spec["outer_radius"]) - mpf(spec["inner_radius"])
    centers = []
    for k, h in enumerate(joints):
        angle = pi * (mpf(spec.get("first_rail", 0)) + 120 * k) / 180
        centers.append([r * cos(angle), r * sin(angle), h + mpf(spec.get("distance", 0))])
    minus = lambda u, v: [x - y for x, y in zip(u, v)]
    dot = lambda u, v: sum(x * y for x, y in zip(u, v))
    ex = minus(centers[1], centers[0])
    d = sqrt(dot(ex, ex))
    ex = [x / d for x in ex]
    w = minus(centers[2], centers[0])
    i = dot(ex, w)
    ey = [x - i * e for x, e in zip(w, ex)]
    j = sqrt(dot(ey, ey))
    ey = [x / j for x in ey]
    ez = [ex[1] * ey[2] - ex[2] * ey[1], ex[2] * ey[0] - ex[0] * ey[2], ex[0] * ey[1] - ex[1] * ey[0]]
    x = d / 2
    y = (i * i + j * j) / (2 * j) - i * x / j
    z = sqrt(mpf(spec["arm"]) ** 2 - x * x - y * y)
    points = [[c + x * a + y * b + s * z * e for c, a, b, e in zip(centers[0], ex, ey, ez)] for s in (1, -1)]
    return min(points, key=lambda p: p[2])


def corexy(spec, joints):
    a, b = joints
    return [(a + b) / 2, (a - b) / 2]


class Curve:
    """A curve of `--curve`: pieces of polynomials and sines over s = u / length."""

    def __init__(self, document):
        self.pieces = document["segments"]
        self.breaks = [mpf(document["start"])]
        for piece in self.pieces:
            self.breaks.append(self.breaks[-1] + mpf(piece["length"]))

    def __call__(self, t):
        k = min(max(bisect_right(self.breaks, t) - 1, 0), len(self.pieces) - 1)
        s = (t - self.breaks[k]) / mpf(self.pieces[k]["length"])
        value = sum(mpf(c) * s**i for i, c in enumerate(self.pieces[k]["polynomial"]))
        return value + sum(mpf(a) * sin(mpf(w) * s + mpf(phase)) for a, w, phase in self.pieces[k]["sines"])


TOOL = {"scara": scara, "linear_delta": linear_delta, "corexy": corexy}


def distance_to_line(p, a, b):
    u = [y - x for x, y in zip(a, b)]
    w = [y - x for x, y in zip(a, p)]
    share = sum(x * y for x, y in zip(u, w)) / sum(x * x for x in u)
    share = min(max(share, 0), 1)
    return sqrt(sum((x - share * y) ** 2 for x, y in zip(w, u)))


def distance_to_arc(p, center):
    """From the circle about a center in the plane of the first two axes; its radius is that of its end."""
    return lambda radius: abs(sqrt((p[0] - center[0]) ** 2 + (p[1] - center[1]) ** 2) - radius)


def distance(p, spec):
    at = [mpf(x) for x in spec["path"].get("start", [0] * len(p))]
    best = mp.inf
    for command in spec["command"]:
        if command["type"] == "dwell":
            continue
        to = [mpf(x) for x in command["to"]]
        if command["type"] == "line":
            best = min(best, distance_to_line(p, at, to))
        else:
            center = [mpf(x) for x in command["center"]]
            radius = sqrt((to[0] - center[0]) ** 2 + (to[1] - center[1]) ** 2)
            best = min(best, distance_to_arc(p, center)(radius))
        at = to
    return best


def judge(jounce, path, folder):
    spec = tomllib.loads(path.read_text(encoding="utf-8"))
    names = [a["name"] for a in spec["axis"]] + [j["name"] for j in spec["joint"]]
    curves = []
    for name in names:
        out = folder / f"{path.stem}-{name}.json"
        subprocess.run([jounce, "design", path, "--axis", name, "-o", folder / "table.csv", "--curve", out], check=True,
                       capture_output=True, timeout=100)
        curves.append(Curve(json.loads(out.read_text(encoding="ascii"))))
    n = len(spec["axis"])
    end = min(c.breaks[-1] for c in curves)
    deviation = mpf(spec["path"]["corner"]["deviation"])
    off = far = mpf(0)
    on = 0
    count = 400
    for k in range(count + 1):
        t = end * k / count
        values = [c(t) for c in curves]
        tool = TOOL[spec["kinematics"]["type"]](spec["kinematics"], values[n:])
        off = max([off] + [abs(a - b) for a, b in zip(tool, values)])
        away = distance(tool, spec)
        far = max(far, away)
        on += away < mpf(10) ** -7
    good = off < mpf(10) ** -7 and far <= deviation * (1 + mpf(10) ** -9) and on > count / 2
    print(f"{path.name}: the tool is {mp.nstr(off, 3)} from its axes, at most {mp.nstr(far, 6)} from the lines and arcs "
          f"(corners: {mp.nstr(deviation, 6)}), on them at {on} of {count + 1} times: {'right' if good else 'WRONG'}")
    return good


def main():
    jounce, examples = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as folder:
        results = [judge(jounce, path, Path(folder)) for path in sorted(Path(examples).glob("*.toml"))]
    return 0 if results and all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
