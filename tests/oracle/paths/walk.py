# SPDX-License-Identifier: Apache-2.0
"""The curve beside the program: distances in both directions in the order of the pieces, stops, feeds."""
import math

from paths import bernstein as bn
from paths.job import Arc, local
from paths.limits import RELATIVE, derived, rounding


def inside(shape, cell, s0, s1, allowed):
    """None if the curve stays within `allowed` of the shape over [s0, s1] of the cell, else (distance, s)."""
    piece = [bn.part(c, s0, s1) for c in cell] if (s0, s1) != (0.0, 1.0) else cell
    stack = [(shape.off(piece), 0.0, 1.0)]
    while stack:
        forms, s, d = stack.pop()
        if shape.bound(forms) <= allowed:
            continue
        for end in (0, -1):
            distance = shape.bound([[f[end]] for f in forms])
            if distance > allowed:
                return distance, s0 + (s + (d if end else 0)) * (s1 - s0)
        if d < 1e-9:
            continue
        split = [bn.halves(f) for f in forms]
        stack += [([f[1] for f in split], s + d / 2, d / 2), ([f[0] for f in split], s, d / 2)]
    return None


def inside_helix(shape, cell, s0, s1, allowed, angle):
    """The same by 33 samples; `angle` is the unwrapped one at s0."""
    base, n = shape.turned([bn.part(c, 0.0, s0) for c in cell]).total if s0 else 0.0, 32
    for i in range(n + 1):
        s = s0 + (s1 - s0) * i / n
        turned = shape.turned([bn.part(c, 0.0, s) for c in cell]).total if s else 0.0
        distance = shape.off_point([bn.value(c, s) for c in cell], angle + turned - base)
        if distance > allowed:
            return distance, s
    return None


class Walk:
    """Follows the program along the curve: each state is a place (cell, s) where a corner may be passed."""

    MOST = 6

    def __init__(self, report, job):
        self.report, self.job = report, job
        self.vmax = max((math.sqrt(max(0.0, bn.greatest(bn.squares([derived(c, h, 1) for c in cell]))[0]))
                         for _, h, cell in job.cells), default=0.0)
        self.corner_distance = 0.0

    def time(self, place):
        t, h, _ = self.job.cells[place[0]]
        return t + place[1] * h

    def point(self, place):
        return [bn.value(c, place[1]) for c in self.job.cells[place[0]][2]]

    def allowed(self, k):
        return self.job.pieces[k].get("deviation", 0.0) * (1 + 1e-9) + self.job.tolerance if k >= 0 else self.job.tolerance

    def at_rest(self, place):
        _, h, cell = self.job.cells[place[0]]
        noise = sum(rounding(c, h, 1) for c in cell)
        v = math.sqrt(sum(bn.value(bn.derivative(c, h), place[1]) ** 2 for c in cell))
        return v <= 1e-9 * self.vmax + noise

    def rate(self, index, s, corner):
        """How fast the square of the distance from the corner grows at a place of a cell."""
        _, h, cell = self.job.cells[index]
        return 2 * sum((bn.value(c, s) - x) * bn.value(bn.derivative(c, h), s) for c, x in zip(cell, corner))

    def minima(self, index, corner, s0, first):
        """Places in [s0, 1] of a cell where the distance from the corner stops to fall; s0 counts for the first cell."""
        found, slack = [], 4 * self.job.tolerance * self.vmax + 1e-30
        last = index + 1 == len(self.job.cells)
        ahead = lambda: last or self.rate(index + 1, 0.0, corner) >= -slack
        if first and (ahead() if s0 == 1.0 else self.rate(index, s0, corner) >= -slack):
            found.append(s0)
        slope = bn.derivative(bn.squares(local(self.job.cells[index][2], corner)))
        for s in bn.sign_changes(slope):
            if s0 < s < 1.0 and bn.value(slope, min(1.0, s + 1e-9)) > bn.value(slope, max(0.0, s - 1e-9)):
                found.append(s)
        if s0 < 1.0 and self.rate(index, 1.0, corner) <= slack and ahead():
            found.append(1.0)
        return found

    def passes(self, k, index, s0, first, outside, angle):
        """(distance, place, counts) where the curve is nearest to corner k in a cell, while it is on piece k.

        `outside`: None, or (distance, s) where the curve leaves the piece. A place counts if the corner may be passed
        there: at rest for a stop, at the end of the curve for the last corner.
        """
        cell, shape, last = self.job.cells[index][2], self.job.shapes[k], self.is_last(k)
        for s in self.minima(index, shape.end, s0, first):
            if outside is not None and s > outside[1]:
                return
            turned = angle + (shape.turned([bn.part(c, s0, s) for c in cell]).total if s > s0 else 0.0)
            if shape.sweep and abs(turned - shape.sweep) > math.pi:
                continue  # another turn of the arc
            place = index, s
            at_end = place == (len(self.job.cells) - 1, 1.0)
            yield math.dist(self.point(place), shape.end), place, at_end if last else not self.stops(k) or self.at_rest(place)

    def is_last(self, k):
        return k + 1 == len(self.job.shapes)

    def stops(self, k):
        return self.job.pieces[k].get("stop", False) and not self.is_last(k)

    def outside(self, k, cell, s0, angle, wide):
        """None while the curve is on piece k from s0 to the end of the cell, else (distance, s) of a place that is not."""
        shape = self.job.shapes[k]
        if isinstance(shape, Arc):
            turned = shape.turned([bn.part(c, s0, 1.0) for c in cell])
            beyond = shape.radius * max(angle + turned.most - shape.sweep, -(angle + turned.least))
            if beyond > 2 * wide + shape.radius * 1e-9 and wide < shape.radius / 2:
                return beyond, 1.0
            if not shape.flat:
                return inside_helix(shape, cell, s0, 1.0, wide, angle)
        return inside(shape, cell, s0, 1.0, wide)

    def step(self, k, start):
        """(distance, place) where corner k may be passed after `start`, and the violation if there is none."""
        shape = self.job.shapes[k]
        near = self.job.tolerance if self.stops(k) or self.is_last(k) else self.allowed(k)
        wide = max(self.allowed(k - 1), self.allowed(k))
        angle = shape.turned([[c] for c in self.point(start)]).first
        found, best, closest, outside = [], None, None, None
        for index in range(start[0], len(self.job.cells)):
            t, h, cell = self.job.cells[index]
            s0 = start[1] if index == start[0] else 0.0
            outside = self.outside(k, cell, s0, angle, wide)
            for distance, place, counts in self.passes(k, index, s0, index == start[0], outside, angle):
                closest = min(closest or (distance, place), (distance, place))
                if counts:
                    best = min(best or (distance, place), (distance, place))
                    found += [(distance, place)] if distance <= near else []
            if outside is not None:
                break
            angle += shape.turned([bn.part(c, s0, 1.0) for c in cell]).total
            gone = found and math.dist(self.point((index, 1.0)), shape.end) > 3 * near and not self.is_last(k)
            if gone or len(found) >= self.MOST:
                break
        else:
            if self.job.partial and not found:
                return [], None  # the curve ends on this piece
        if found:
            return found, None
        if outside is not None and (closest is None or self.is_last(k) or closest[0] > shape.length / 2):
            return [], ("deviation", "distance of the curve from its piece", outside[0], wide, t + outside[1] * h)
        if best is None and closest is not None and self.stops(k):
            return [], ("stop", "distance from the corner, without rest,", closest[0], 0.0, self.time(closest[1]))
        distance, place = best or closest or (math.inf, start)
        what = "distance of the place of rest from the corner" if self.stops(k) else "distance of the corner from the curve"
        return [], ("stop" if self.stops(k) else "corner", what, distance, near, self.time(place))

    def run(self):
        """The places where the corners are passed, or None after a violation."""
        states, history = {(0, 0.0): 0.0}, []  # place -> the greatest distance of a corner on the best way there
        for k, piece in enumerate(self.job.pieces):
            after, before, failures = {}, {}, []
            for place, greatest in states.items():
                found, failure = self.step(k, place)
                failures.append(failure)
                for distance, target in found:
                    if max(greatest, distance) < after.get(target, math.inf):
                        after[target], before[target] = max(greatest, distance), place
            if not after:
                if None in failures:
                    break
                self.report.violation(*failures[0], piece.get("line"))
                return None
            history.append(before)
            states = dict(sorted(after.items(), key=lambda item: item[1])[:self.MOST])
        place, self.corner_distance = min(states.items(), key=lambda item: item[1])
        places = []
        for before in reversed(history):
            places.append(place)
            place = before[place]
        return places[::-1]


def steps_of(walk, places):
    """Joints that are passed although their curvature steps: (time, width, jump of the acceleration by axis).

    These are tangent joints that may not be rounded: an exact path (G61) passes them (decision 0090).
    """
    job, steps = walk.job, []
    for place, piece, before, after in zip(places, job.pieces, job.shapes, job.shapes[1:]):
        if piece.get("stop") or piece.get("deviation") or math.dist(before.ends, after.begins) > 1e-9:
            continue
        _, h, cell = job.cells[place[0]]
        square = sum(bn.value(bn.derivative(c, h), place[1]) ** 2 for c in cell)
        if square > 0:
            turns = zip(before.curvature(before.sweep), after.curvature(0.0))
            jump = [(1 + 1e-6) * square * abs(b - a) for a, b in turns]
            steps.append((walk.time(place), (10 * job.tolerance + 1e-9 * job.extent) / math.sqrt(square), jump))
    return steps


def check_feeds(report, job, places):
    feeds = [p.get("feed", math.inf) for p in job.pieces]
    if min(feeds, default=math.inf) == math.inf:
        return
    begin = (0, 0.0)
    for k, (end, shape) in enumerate(zip(places, job.shapes)):
        most = max(feeds[max(0, k - 1):k + 2])
        for index in range(begin[0], end[0] + 1):
            t, h, cell = job.cells[index]
            s0, s1 = begin[1] if index == begin[0] else 0.0, end[1] if index == end[0] else 1.0
            if s1 - s0 < 1e-12:
                continue
            part = [bn.part(c, s0, s1) for c in cell]
            speed = bn.squares([derived(c, h * (s1 - s0), 1) for c in part])
            noise = sum(rounding(c, h, 1) for c in cell)
            top, at = bn.greatest(speed)
            if math.sqrt(max(0.0, top)) > most * (1 + RELATIVE) + noise:
                report.violation("feed", "speed", math.sqrt(top), most, t + (s0 + at * (s1 - s0)) * h, job.pieces[k].get("line"))
            for s in bn.sign_changes(shape.middle(part)):
                v = math.sqrt(max(0.0, bn.value(speed, s)))
                if shape.is_middle([bn.value(c, s) for c in part]) and v > feeds[k] * (1 + RELATIVE) + noise:
                    report.violation("feed", "speed at the middle of the piece", v, feeds[k], t + (s0 + s * (s1 - s0)) * h,
                                     job.pieces[k].get("line"))
        begin = end
