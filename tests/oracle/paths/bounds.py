# SPDX-License-Identifier: Apache-2.0
"""Two times that a plan lies between: with a stop at every corner, and along its curve without limits of jerk."""
import math

from paths import bernstein as bn
from paths.job import Line


# ------------------------------------------------------------------------------------- stop at each corner

def ramp(change, a, j):
    """Least time to change the speed, without acceleration at both ends."""
    if math.isinf(j):
        return change / a
    return 2 * math.sqrt(change / j) if change <= a * a / j else change / a + a / j


def rest_to_rest(length, v, a, d, j):
    if math.isinf(v):
        v = math.sqrt(2 * length * a) if not math.isinf(a) else 4 * (length * length * j) ** (1 / 3)
    if math.isinf(v):
        return 0.0  # nothing is limited
    need = lambda peak: peak / 2 * (ramp(peak, a, j) + ramp(peak, d, j))
    if need(v) <= length:
        return ramp(v, a, j) + ramp(v, d, j) + (length - need(v)) / v
    low, high = 0.0, v
    for _ in range(200):
        peak = (low + high) / 2
        low, high = (peak, high) if need(peak) < length else (low, peak)
    return ramp(high, a, j) + ramp(high, d, j)


def along_line(job, shape, feed):
    def limit(key, fallback=None):
        own = [(axis.get(key, axis.get(fallback, math.inf)) if fallback else axis.get(key, math.inf)) / abs(u)
               for axis, u in zip(job.axes, shape.direction) if u]
        in_space = job.path.get(key, job.path.get(fallback, math.inf) if fallback else math.inf)
        return min([in_space, *own])
    v, a, d, j = min(limit("velocity"), feed), limit("acceleration"), limit("deceleration", "acceleration"), limit("jerk")
    a, d = min(a, job.path.get("total_acceleration", a)), min(d, job.path.get("total_acceleration", d))
    return rest_to_rest(shape.length, v, a, d, min(j, job.path.get("total_jerk", j)))


def along_arc(job, shape, feed):
    """The best of the boxes a + v²/R <= A, j + 3 v a / R + v³/R² <= J, R the radius of curvature."""
    least = lambda key, space=(): min([a.get(key, math.inf) for a in job.axes] + [job.path.get(k, math.inf) for k in space])
    radius = shape.length**2 / (shape.radius * shape.sweep**2)
    top = min(least("velocity", ("velocity",)), feed)
    total = min(least("acceleration", ("total_acceleration",)), least("deceleration"))
    jerk, path = least("jerk", ("total_jerk",)), min(job.path.get("acceleration", math.inf), job.path.get("deceleration", math.inf))
    best = math.inf
    for i in range(1, 400):
        v = min(top, job.path.get("normal_acceleration", math.inf) ** 0.5 * radius**0.5)
        if math.isinf(total):
            a = path
        else:
            a = min(total * i / 400, path)
            v = min(v, math.sqrt((total - a) * radius))
        if not math.isinf(jerk):
            rest = lambda x: jerk - 3 * x * a / radius - x**3 / radius**2
            low, high = 0.0, v
            for _ in range(60):
                middle = (low + high) / 2
                low, high = (middle, high) if rest(middle) > jerk / 20 else (low, middle)
            options = [(low * k / 16, rest(low * k / 16)) for k in range(1, 17)]
        else:
            options = [(v, math.inf)]
        best = min([best] + [rest_to_rest(shape.length, x, a, a, j) for x, j in options if x > 0 and j > 0])
    return best


def stop_time(job):
    """Rest at every corner. Lines that go on in the same direction, to 1e-9 rad, are one; arcs count as they are."""
    whole = []
    for piece, shape in zip(job.pieces, job.shapes):
        feed = piece.get("feed", math.inf)
        if whole and not piece.get("stop") and whole[-1][1] == feed and isinstance(shape, Line) and \
                isinstance(whole[-1][0], Line) and math.dist(whole[-1][0].direction, shape.direction) < 1e-9:
            whole[-1] = Line(whole[-1][0].start, shape.end), feed
        else:
            whole.append((shape, feed))
    times = {}
    for shape, feed in whole:
        key = (type(shape), shape.length, tuple(map(abs, shape.begins)) if isinstance(shape, Line) else shape.radius, feed)
        if key not in times:
            times[key] = [(along_line if isinstance(shape, Line) else along_arc)(job, shape, feed), 0]
        times[key][1] += 1
    return math.fsum(t * n for t, n in times.values())


# --------------------------------------------------------------------------------- without limits of jerk

class Station:
    """A place on the curve: tangent, curvature vector by arc length, and what they allow for B = speed²."""

    def __init__(self, job, v, a, slow):
        speed = math.sqrt(sum(x * x for x in v))
        self.tangent = [x / speed for x in v]
        pull = sum(x * y for x, y in zip(self.tangent, a))
        self.bend = [0.0] * len(v) if speed < slow else [(y - pull * x) / speed**2 for x, y in zip(self.tangent, a)]
        path, axes = job.path, job.axes
        self.most = [max(x.get("acceleration", math.inf), x.get("deceleration", 0.0)) for x in axes]
        caps = [path.get("velocity", math.inf) ** 2]
        caps += [(x["velocity"] / abs(u)) ** 2 for x, u in zip(axes, self.tangent) if u and "velocity" in x]
        for i, m in enumerate(self.most):  # some acceleration must satisfy both axes
            for k in range(i):
                across = abs(self.bend[i] * self.tangent[k] - self.bend[k] * self.tangent[i])
                if across and not math.isinf(m + self.most[k]):
                    caps.append((m * abs(self.tangent[k]) + self.most[k] * abs(self.tangent[i])) / across)
        curvature = math.sqrt(sum(x * x for x in self.bend))
        for key in ("normal_acceleration", "total_acceleration"):
            if key in path and curvature:
                caps.append(path[key] / curvature)
        self.cap = min(caps)
        self.path_a = min(max(path.get("acceleration", math.inf), path.get("deceleration", 0.0)),
                          path.get("total_acceleration", math.inf))

    def gain(self, b, way):
        """Greatest acceleration (way 1) or deceleration (way -1) along the path at B = b."""
        return max(0.0, min([self.path_a] + [(m - way * math.copysign(k, u * k) * b) / abs(u)
                                             for m, u, k in zip(self.most, self.tangent, self.bend) if u]))


class Cell:
    """A grid cell: its length, the weakest of its stations, and how far B gets through it."""

    def __init__(self, length, stations):
        self.length, self.stations = length, stations
        self.cap = max(s.cap for s in stations)

    def gain(self, b, way):
        return max(s.gain(b, way) for s in self.stations)

    def reach(self, b, way):
        """Greatest B after the cell from at most b: the gain may be greater where B is less."""
        if math.isinf(self.gain(0.0, way)) or math.isinf(b):
            return math.inf
        return max(x + 2 * self.length * self.gain(x, way) for x in (b * i / 8 for i in range(9)))

    def time(self, b0, b1):
        """Least time from at most b0 to at most b1, with the greater gain of both ends and of half their mean."""
        if math.isinf(self.cap) and math.isinf(b0 + b1):
            return 0.0
        b0, b1 = min(b0, self.cap), min(b1, self.cap)
        gain = max(self.gain(x, way) for x in (b0, b1, (b0 + b1) / 4) for way in (1, -1))
        if math.isinf(gain):
            return 0.0 if math.isinf(self.cap) else self.length / math.sqrt(self.cap)
        if gain == 0.0:
            return 2 * self.length / (math.sqrt(b0) + math.sqrt(b1)) if b0 + b1 > 0 else 0.0
        peak = min(self.cap, (b0 + b1) / 2 + gain * self.length)
        up, down = max(0.0, (peak - b0) / (2 * gain)), max(0.0, (peak - b1) / (2 * gain))
        flat, root = max(0.0, self.length - up - down), math.sqrt(peak)
        over = lambda d, b: 2 * d / (math.sqrt(b) + root) if d else 0.0
        return over(up, b0) + over(down, b1) + (flat / root if flat and root else 0.0)


def second_order_bound(job, nodes=600):
    """Least time along this very curve if the jerk is not limited, by reachability on a grid; rounded down by 0.1 %.

    Every constraint is the weakest of three places of a grid cell, so that the grid can only shorten the time.
    Curvature is ignored where the plan is slower than 0.1 % of its greatest speed: there it is lost in rounding.
    """
    samples, v_top = [], 0.0
    cuts = min(64, max(4, nodes // len(job.cells)))
    for _, h, cell in job.cells:
        n = cuts if any(abs(x) > 0 for c in cell for x in c[1:]) else 1
        d1, d2 = [bn.derivative(c, h) for c in cell], [bn.derivative(bn.derivative(c, h), h) for c in cell]
        for i in range(n):
            group = []
            for s in (i / n, (i + 0.5) / n, (i + 1) / n):
                v = [bn.value(c, s) for c in d1]
                group.append((v, [bn.value(c, s) for c in d2], [bn.value(c, s) for c in cell]))
                v_top = max(v_top, math.sqrt(sum(x * x for x in v)))
            samples.append(group)
    cells, stops, before = [], {0}, None
    for group in samples:
        moving = [g for g in group if math.sqrt(sum(x * x for x in g[0])) > 1e-9 * v_top]
        if not moving:
            continue
        stations = [Station(job, v, a, 1e-3 * v_top) for v, a, _ in moving]
        if before and math.dist(before, stations[0].tangent) > 1e-3 and len(moving) < 3:
            stops.add(len(cells))  # the curve has a corner here: no law passes it moving
        before = stations[-1].tangent
        cells.append(Cell(math.dist(group[0][2], group[1][2]) + math.dist(group[1][2], group[2][2]), stations))
    n = len(cells)
    node = [0.0 if k in stops else min(math.inf, *(c.cap for c in cells[k - 1:k + 1])) for k in range(n)] + [0.0]
    for k in range(n):
        node[k + 1] = min(node[k + 1], cells[k].reach(node[k], 1))
    for k in reversed(range(n)):
        node[k] = min(node[k], cells[k].reach(node[k + 1], -1))
    return 0.999 * math.fsum(c.time(node[k], node[k + 1]) for k, c in enumerate(cells))
