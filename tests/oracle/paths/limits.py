# SPDX-License-Identifier: Apache-2.0
"""Limits of an axis, its joints, and limits of the motion in space, by exact extrema."""
import math

from paths import bernstein as bn

RELATIVE = 1e-12
DERIVATIVES = ("position", "velocity", "acceleration", "jerk")
EPS = 2.0**-52


def rounding(c, h, order):
    """The greatest change of a derivative by the last digits of the coefficients, anywhere on the piece."""
    return 8 * EPS * sum(math.perm(k, order) * abs(x) for k, x in enumerate(c) if k >= order) / h**order


def derived(c, h, order):
    for _ in range(order):
        c = bn.derivative(c, h)
    return c


class Report:
    def __init__(self):
        self.violations, self.notes = [], {}

    def violation(self, kind, what, value, limit, time, line=None):
        for v in self.violations:  # the worst of each kind and place is enough
            if v["kind"] == kind and v["what"] == what and v["line"] == line:
                if value > v["value"]:
                    v.update(value=value, limit=limit, time=time)
                return
        self.violations.append({"kind": kind, "what": what, "value": value, "limit": limit, "time": time, "line": line})

    def text(self):
        rows = []
        for v in self.violations:
            line = f"line {v['line']}: " if v["line"] is not None else ""
            rows.append(f"{line}{v['kind']}: {v['what']} is {v['value']:.12g}, limit {v['limit']:.12g}, at {v['time']:.9g} s")
        return rows + [f"{k}: {v}" for k, v in self.notes.items()]


# -------------------------------------------------------------------------------------- limits of an axis

def check_limits(report, name, curve, limits):
    for order, key in ((1, "velocity"), (2, "acceleration"), (3, "jerk")):
        limit, peak = limits.get(key), 0.0
        slower = limits.get("deceleration", limit) if order == 2 else limit
        if limit is None:
            continue
        for t, h, c in curve.pieces:
            d, noise = derived(c, h, order), rounding(c, h, order)
            for sign in (1, -1):
                top, at = bn.greatest(bn.scale(sign, d), floor=peak)
                peak = max(peak, top)
                if top > max(limit, slower) * (1 + RELATIVE) + noise:
                    report.violation("limit", f"{key} of {name}", top, max(limit, slower), t + at * h)
            if limit != slower:
                check_signed(report, name, t, h, c, limit, slower, noise)
        report.notes[f"{name} {key}"] = f"{peak:.12g} of {limit:.12g}"


def check_signed(report, name, t, h, c, faster, slower, noise):
    """Different limits while the speed grows and falls: intervals by the sign of the velocity."""
    cuts = [0.0, *bn.sign_changes(bn.derivative(c, h)), 1.0]
    for s0, s1 in zip(cuts, cuts[1:]):
        if s1 - s0 < 1e-9:
            continue
        piece = bn.part(c, s0, s1)
        way = math.copysign(1, bn.value(bn.derivative(piece), 0.5))
        a = derived(piece, h * (s1 - s0), 2)
        for sign, limit, key in ((way, faster, "acceleration"), (-way, slower, "deceleration")):
            top, at = bn.greatest(bn.scale(sign, a))
            if top > limit * (1 + RELATIVE) + noise:
                report.violation("limit", f"{key} of {name}", top, limit, t + (s0 + at * (s1 - s0)) * h)


def check_joints(report, name, curve, limits, steps=()):
    """Jumps between pieces, and rest outside the curve.

    `steps`: (time, width, jump) where the acceleration may jump, from `width` before the time to `width` after it.
    """
    highest = 2 if limits.get("jerk") is not None else 1
    places = [x for _, _, c in curve.pieces for x in (c[0], sum(c))]
    peaks = [max(places) - min(places)]
    for order, key in ((1, "velocity"), (2, "acceleration")):
        reached = max(max(abs(bn.value(derived(c, h, order), s)) for s in (0, 0.5, 1)) for _, h, c in curve.pieces)
        peaks.append(limits.get(key) or reached)
    first, last = curve.pieces[0], curve.pieces[-1]
    outside = [(curve.begin, 1.0, [first[2][0]]), *curve.pieces, (curve.end, 1.0, [sum(last[2])])]
    for (_, h0, c0), (t, h1, c1) in zip(outside, outside[1:]):
        for order in range(highest + 1):
            jump = abs(bn.value(derived(c0, h0, order), 1.0) - bn.value(derived(c1, h1, order), 0.0))
            noise = rounding(c0, h0, order) + rounding(c1, h1, order)
            allowed = noise + (1e-12 if order == 0 else 1e-9) * peaks[order]
            if order == 2:
                allowed += max((step for at, width, step in steps if abs(t - at) <= width), default=0.0)
            if jump > allowed:
                report.violation("continuity", f"jump of the {DERIVATIVES[order]} of {name}", jump, allowed, t)


# ------------------------------------------------------------------------------------- limits in space

def check_space(report, job):
    limits = job.path
    for t, h, cell in job.cells:
        v, a, j = ([derived(c, h, n) for c in cell] for n in (1, 2, 3))
        noise = [math.sqrt(sum(rounding(c, h, n) ** 2 for c in cell)) for n in range(4)]
        speed, pull = bn.squares(v), None

        def below(what, polynomial, limit, slack):
            """polynomial <= limit², both squared magnitudes."""
            top, at = bn.greatest(polynomial, floor=limit * limit)
            if top > (limit * (1 + RELATIVE) + slack) ** 2:
                report.violation("path limit", what, math.sqrt(top), limit, t + at * h)

        if "velocity" in limits:
            below("speed", speed, limits["velocity"], noise[1])
        if "total_acceleration" in limits:
            below("total acceleration", bn.squares(a), limits["total_acceleration"], noise[2])
        if "total_jerk" in limits:
            below("total jerk", bn.squares(j), limits["total_jerk"], noise[3])
        top = math.sqrt(max(0.0, bn.greatest(speed)[0]))
        if top <= 1e-9 * max(1e-300, limits.get("velocity", top)):
            continue
        if "acceleration" in limits or "normal_acceleration" in limits:
            pull = bn.multiply([1.0], [0.0])
            for x, y in zip(v, a):
                pull = bn.add(pull, bn.multiply(x, y))
        if "acceleration" in limits:
            slower = limits.get("deceleration", limits["acceleration"])
            check_along(report, t, h, speed, pull, limits["acceleration"], slower, noise[2], top)
        if "normal_acceleration" in limits:  # |v|² |a|² - (v a)² <= N² |v|²
            normal = bn.add(bn.multiply(speed, bn.squares(a)), bn.scale(-1, bn.multiply(pull, pull)))
            check_ratio(report, "normal acceleration", t, h, normal, speed, limits["normal_acceleration"], noise[2], top)


def check_along(report, t, h, speed, pull, faster, slower, noise, top):
    """(v a)² <= A² |v|², with the sign of v a."""
    cuts = [0.0, *bn.sign_changes(pull), 1.0] if faster != slower else [0.0, 1.0]
    for s0, s1 in zip(cuts, cuts[1:]):
        if s1 - s0 < 1e-9:
            continue
        p, v = bn.part(pull, s0, s1), bn.part(speed, s0, s1)
        grows = bn.value(p, 0.5) > 0
        what, limit = ("path acceleration", faster) if grows or faster == slower else ("path deceleration", slower)
        check_ratio(report, what, t + s0 * h, h * (s1 - s0), bn.multiply(p, p), v, limit, noise, top)


def check_ratio(report, what, t, h, numerator, speed, limit, noise, top):
    """numerator <= limit² |v|² where the speed is not tiny; near rest both vanish, and the axes' limits hold."""
    excess = bn.add(numerator, bn.scale(-(limit * (1 + 1e-11) + noise) ** 2, speed))
    worst, at = bn.greatest(excess)
    squared = bn.value(speed, at)
    if worst > 1e-13 * (limit * top) ** 2 and squared > 1e-12 * top * top:
        report.violation("path limit", what, math.sqrt(max(0.0, bn.value(numerator, at)) / squared), limit, t + at * h)
