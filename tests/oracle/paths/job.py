# SPDX-License-Identifier: Apache-2.0
"""A plan as path_judge.py reads it: curves of the axes, and the programmed shapes.

A job is a JSON object:

    jounce_path_job  1
    axes             one object an axis: name; velocity, acceleration, deceleration, jerk: limits, each may be absent
                     (deceleration: as acceleration)
    path             limits of the motion in space, each may be absent: velocity, acceleration (along the path, speed
                     grows), deceleration, normal_acceleration, total_acceleration, total_jerk
    law              limits of the curve "law", q(t): velocity, acceleration, deceleration, jerk
    start            the first position, one number an axis
    pieces           the program: type "line" or "arc", to, and
                       line       line of the source, for messages
                       deviation  how far the curve may pass the corner at the end of this piece (0: through it)
                       stop       true: the motion rests at the end of this piece
                       feed       greatest speed in space on this piece
                     an arc has center (two numbers; three with `normal`), clockwise, extra_turns; in three axes
                     `normal` gives its plane, counterclockwise about it. Axes outside the plane follow the angle.
    tolerance        absolute error of positions that is accepted; default 1e-12 of the path's extent, for exact plans;
                     a plan that fits arcs by polynomials needs the error of its certificate here
    partial          true: the curve comes to rest anywhere on the program (a hold); its end and times are not judged
    curves           axis (or "law") -> a curve: the JSON of `jounce design --curve`, or
                       {"file": F}     that JSON, or a table: CSV of `jounce design -o`, relative to the job
                       {"samples": [[t, p], [t, p, v] or [t, p, v, a], ...]}   linear, cubic, quintic between them
"""
import csv
import json
import math
from pathlib import Path
from typing import NamedTuple

from paths import bernstein as bn


class BadJob(Exception):
    pass


class Curve:
    """Pieces (start time, length, power coefficients in s = (t - start) / length)."""

    def __init__(self, pieces):
        if not pieces:
            raise BadJob("a curve without pieces")
        self.pieces = pieces
        self.begin, self.end = pieces[0][0], pieces[-1][0] + pieces[-1][1]

    @classmethod
    def of_json(cls, document):
        t, pieces = document["start"], []
        for segment in document["segments"]:
            parts = bn.of_sines(segment["polynomial"], segment["sines"])
            h = segment["length"] / len(parts)
            if not h > 0:
                raise BadJob(f"a segment of length {segment['length']}")
            pieces += [(t + i * h, h, p) for i, p in enumerate(parts)]
            t += segment["length"]
        return cls(pieces)

    @classmethod
    def of_samples(cls, rows):
        pieces = []
        for a, b in zip(rows, rows[1:]):
            if not b[0] > a[0]:
                raise BadJob(f"times do not increase at {b[0]}")
            pieces.append((a[0], b[0] - a[0], bn.hermite(b[0] - a[0], a[1:], b[1:])))
        return cls(pieces)

    @classmethod
    def read(cls, source, folder):
        if "samples" in source:
            return cls.of_samples(source["samples"])
        if "file" not in source:
            return cls.of_json(source)
        text = (Path(folder) / source["file"]).read_text(encoding="utf-8")
        if text.lstrip().startswith("{"):
            return cls.of_json(json.loads(text))
        rows = [row for row in csv.reader(line for line in text.splitlines() if line and line[0] != "#")]
        return cls.of_samples([[float(x) for x in row] for row in rows[1:]])

    def scaled(self, factor):
        """The same positions at times multiplied by `factor`."""
        return Curve([(t * factor, h * factor, c) for t, h, c in self.pieces])


def cells(curves):
    """All axes over common pieces: (start, length, [coefficients an axis])."""
    begin, end = curves[0].begin, curves[0].end
    close = 1e-12 * (end - begin)
    cuts = []
    for t in sorted({t for c in curves for t, _, _ in c.pieces} | {end}):
        if not cuts or t - cuts[-1] > close:
            cuts.append(t)
    cuts[-1] = end
    out, at = [], [0] * len(curves)
    for t0, t1 in zip(cuts, cuts[1:]):
        row, middle = [], (t0 + t1) / 2
        for k, curve in enumerate(curves):
            while at[k] + 1 < len(curve.pieces) and curve.pieces[at[k] + 1][0] <= middle:
                at[k] += 1
            t, h, c = curve.pieces[at[k]]
            s0, s1 = (t0 - t) / h, (t1 - t) / h
            row.append(c if s0 == 0 and s1 == 1 else bn.part(c, s0, s1))
        out.append((t0, t1 - t0, row))
    return out


# ---------------------------------------------------------------------------------------------- shapes

def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def combine(polynomials, weights, offset=0.0):
    """sum of weight * (polynomial) - offset."""
    total = [-offset]
    for p, w in zip(polynomials, weights):
        if w:
            total = bn.add(total, bn.scale(w, p))
    return total


def local(cell, origin):
    return [[c[0] - o, *c[1:]] for c, o in zip(cell, origin)]


class Turned(NamedTuple):
    """An angle along a cell: at its start, in (-pi, pi], and from there the total, least and greatest change."""
    first: float
    total: float
    least: float
    most: float


class Line:
    def __init__(self, start, end):
        self.start, self.end = start, end
        self.length = math.dist(start, end)
        self.direction = [(b - a) / self.length for a, b in zip(start, end)] if self.length else [0.0] * len(start)
        self.begins = self.ends = self.direction

    def turned(self, _):
        return Turned(0.0, 0.0, 0.0, 0.0)

    def curvature(self, _):
        return [0.0] * len(self.start)

    sweep = 0.0

    def middle(self, cell):
        """A polynomial that goes through zero at the middle of the piece."""
        return combine(local(cell, self.start), self.direction, self.length / 2)

    def is_middle(self, _):
        return True

    def off(self, cell):
        """Bernstein forms whose bounds give the distance; `bound` reads them."""
        r = local(cell, self.start)
        foot = combine(r, self.direction)
        rejection = bn.squares([bn.add(p, bn.scale(-u, foot)) for p, u in zip(r, self.direction)])
        return [bn.bernstein(foot), bn.bernstein(rejection)]

    def bound(self, forms):
        """An upper bound of the distance over the interval; exact for an interval of no length."""
        foot, rejection = forms
        over = max(0.0, -min(foot), max(foot) - self.length)
        return math.sqrt(max(0.0, max(rejection)) + over * over)


class Arc:
    def __init__(self, start, end, piece):
        self.start, self.end, n = start, end, len(start)
        if "normal" in piece:
            center = list(piece["center"])
            ray = [s - c for s, c in zip(start, center)]
            self.radius = math.sqrt(dot(ray, ray))
            size = math.sqrt(dot(piece["normal"], piece["normal"]))
            k = [x / size for x in piece["normal"]]
            ex = [x / self.radius for x in ray]
            ey = [k[1] * ex[2] - k[2] * ex[1], k[2] * ex[0] - k[0] * ex[2], k[0] * ex[1] - k[1] * ex[0]]
        else:
            center = [*piece["center"], *start[2:]]
            self.radius = math.hypot(start[0] - center[0], start[1] - center[1])
            ex = [(start[0] - center[0]) / self.radius, (start[1] - center[1]) / self.radius] + [0.0] * (n - 2)
            ey = [-ex[1], ex[0]] + [0.0] * (n - 2)
        if piece.get("clockwise"):
            ey = [-y for y in ey]
        self.center, self.ex, self.ey = center, ex, ey
        ray = [e - c for e, c in zip(end, center)]
        angle = math.atan2(dot(ray, ey), dot(ray, ex))
        if angle <= 1e-12:
            angle += 2 * math.pi
        self.sweep = angle + 2 * math.pi * piece.get("extra_turns", 0)
        self.rise = [r - x * dot(ray, ex) - y * dot(ray, ey) for r, x, y in zip(ray, ex, ey)]
        self.flat = max(map(abs, self.rise)) <= 1e-12 * self.radius
        climb = math.sqrt(dot(self.rise, self.rise))
        self.length = math.hypot(self.radius * self.sweep, climb)
        self.begins, self.ends = self.tangent(0.0), self.tangent(self.sweep)

    def tangent(self, angle):
        k = self.radius * self.sweep / self.length
        return [k * (y * math.cos(angle) - x * math.sin(angle)) + r / self.length
                for x, y, r in zip(self.ex, self.ey, self.rise)]

    def curvature(self, angle):
        """The second derivative of the position by the length."""
        k = self.radius * (self.sweep / self.length) ** 2
        return [-k * (x * math.cos(angle) + y * math.sin(angle)) for x, y in zip(self.ex, self.ey)]

    def at(self, angle):
        return [c + self.radius * (x * math.cos(angle) + y * math.sin(angle)) + r * angle / self.sweep
                for c, x, y, r in zip(self.center, self.ex, self.ey, self.rise)]

    def turned(self, cell):
        """How the angle changes within a cell; it is unwrapped by samples less than a radian apart."""
        r = local(cell, self.center)
        x, y = combine(r, self.ex), combine(r, self.ey)
        way = sum(abs(c) for p in (x, y) for c in p[1:])
        n = 2 + math.ceil(2 * way / self.radius)
        angles = [math.atan2(bn.value(y, i / n), bn.value(x, i / n)) for i in range(n + 1)]
        way = [0.0]
        for a, b in zip(angles, angles[1:]):
            way.append(way[-1] + (b - a + math.pi) % (2 * math.pi) - math.pi)
        return Turned(angles[0], way[-1], min(way), max(way))

    def middle(self, cell):
        half = self.sweep / 2
        return combine(local(cell, self.center), [y * math.cos(half) - x * math.sin(half) for x, y in zip(self.ex, self.ey)])

    def is_middle(self, point):
        half = self.sweep / 2
        return dot([p - c for p, c in zip(point, self.center)],
                   [x * math.cos(half) + y * math.sin(half) for x, y in zip(self.ex, self.ey)]) > 0

    def off(self, cell):
        r = local(cell, self.center)
        x, y = combine(r, self.ex), combine(r, self.ey)
        rest = [bn.add(p, bn.add(bn.scale(-a, x), bn.scale(-b, y))) for p, a, b in zip(r, self.ex, self.ey)]
        return [bn.bernstein(bn.squares([x, y])), bn.bernstein(bn.squares(rest) if self.flat else [0.0])]

    def bound(self, forms):
        around, rest = forms
        out = math.sqrt(max(0.0, max(around))) - self.radius
        inside = self.radius - math.sqrt(max(0.0, min(around)))
        return math.hypot(max(out, inside), math.sqrt(max(0.0, max(rest))))

    def off_point(self, point, angle):
        """Distance from the helix near an unwrapped angle; for arcs that climb, by sampling."""
        best = min((angle + d * 0.02 / 16 for d in range(-16, 17)), key=lambda a: math.dist(point, self.at(a)))
        low, high = best - 0.00125, best + 0.00125
        for _ in range(60):
            a, b = low + (high - low) / 3, high - (high - low) / 3
            low, high = (low, b) if math.dist(point, self.at(a)) < math.dist(point, self.at(b)) else (a, high)
        return math.dist(point, self.at((low + high) / 2))


class Job:
    def __init__(self, document, folder="."):
        if document.get("jounce_path_job") != 1:
            raise BadJob("jounce_path_job must be 1")
        self.axes = document["axes"]
        self.path, self.law_limits = document.get("path", {}), document.get("law", {})
        self.start = [float(x) for x in document["start"]]
        self.pieces, self.shapes = [], []
        at = self.start
        for piece in document["pieces"]:
            to = [float(x) for x in piece["to"]]
            shape = Line(at, to) if piece["type"] == "line" else Arc(at, to, piece)
            if shape.length > 0:
                self.pieces.append(piece)
                self.shapes.append(shape)
            elif piece.get("stop") and self.pieces:
                self.pieces[-1] = {**self.pieces[-1], "stop": True}
            at = to
        self.goal = at
        points = [self.start] + [s.end for s in self.shapes]
        points += [s.at(s.sweep * i / 8) for s in self.shapes if isinstance(s, Arc) for i in range(8)]
        self.extent = math.sqrt(sum((max(c) - min(c)) ** 2 for c in zip(*points)))
        far = max(abs(x) for p in points for x in p)
        self.tolerance = document.get("tolerance", 1e-12 * self.extent) + 4 * math.ulp(far)
        self.partial = document.get("partial", False)
        sources = document.get("curves", {})
        missing = [a["name"] for a in self.axes if a["name"] not in sources]
        if missing:
            raise BadJob(f"no curve for axis {', '.join(missing)}")
        self.curves = [Curve.read(sources[a["name"]], folder) for a in self.axes]
        self.law = Curve.read(sources["law"], folder) if "law" in sources else None
        begin, end = self.curves[0].begin, self.curves[0].end
        for a, c in zip(self.axes, self.curves):
            if abs(c.begin - begin) > 1e-12 * (end - begin) or abs(c.end - end) > 1e-12 * (end - begin):
                raise BadJob(f"axis {a['name']} lasts from {c.begin} to {c.end}, the first one from {begin} to {end}")
        self.cells = cells(self.curves)
        self.time = end - begin
