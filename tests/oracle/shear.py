#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Flying shears with 40 digits, from the speed of the carriage over the line and nothing else.

usage: shear.py           writes shear.json beside it
       shear.py --check   exit status 1 if shear.json is not what the script makes

Units as the cases have them. Every law is given by its acceleration; velocity and position are its exact
integrals, its peaks are found numerically. The least cut length and the fastest line are bisected for with a
predicate that builds the whole cycle at that length or speed and looks at its peaks.
"""
import json
import os
import random
import sys

from mpmath import cos, inf, mp, mpf, pi, polyroots, polyval, sin, sqrt

mp.dps = 40


class Polynomial:
    """Rest to rest, degree 2n - 1: f' = c z^(n-1) (1-z)^(n-1)."""

    def __init__(self, n):
        slope = [mpf(1)]
        for _ in range(n - 1):
            slope = self.times(slope, [mpf(-1), mpf(1), mpf(0)])
        f = self.integral(slope)
        whole = polyval(f, 1)
        self.f = [c / whole for c in f]
        self.d = [self.f]
        for _ in range(4):
            self.d.append(self.derivative(self.d[-1]))
        self.peaks = [None] + [self.found_peak(order) for order in (1, 2, 3)]

    @staticmethod
    def times(a, b):
        out = [mpf(0)] * (len(a) + len(b) - 1)
        for i, x in enumerate(a):
            for j, y in enumerate(b):
                out[i + j] += x * y
        return out

    @staticmethod
    def integral(p):
        n = len(p)
        return [c / (n - i) for i, c in enumerate(p)] + [mpf(0)]

    @staticmethod
    def derivative(p):
        n = len(p) - 1
        return [c * (n - i) for i, c in enumerate(p[:-1])]

    def at(self, z, order=0):
        return polyval(self.d[order], z)

    def area(self, z):
        return polyval(self.integral(self.f), z)

    def peak(self, order):
        return self.peaks[order]

    def found_peak(self, order):
        if any(abs(self.at(z, k)) > 1e-30 for z in (0, 1) for k in range(1, order)):
            return inf
        zeros = [r.real for r in polyroots(self.d[order + 1], maxsteps=500, extraprec=400)
                 if abs(r.imag) < 1e-20 and 0 <= r.real <= 1]
        return max(abs(self.at(z, order)) for z in zeros + [mpf(0), mpf(1)])


class Line:
    def at(self, z, order=0):
        return [z, mpf(1), mpf(0), mpf(0)][order]

    def area(self, z):
        return z * z / 2

    def peak(self, order):
        return [None, mpf(1), inf, inf][order]


class Sine:
    """Simple sine: f'' = pi^2/2 cos pi z."""

    def at(self, z, order=0):
        return [(1 - cos(pi * z)) / 2, pi / 2 * sin(pi * z), pi**2 / 2 * cos(pi * z)][order]

    def area(self, z):
        return z / 2 - sin(pi * z) / (2 * pi)

    def peak(self, order):
        return [None, pi / 2, pi**2 / 2, inf][order]


class Cycloid:
    def at(self, z, order=0):
        return [z - sin(2 * pi * z) / (2 * pi), 1 - cos(2 * pi * z), 2 * pi * sin(2 * pi * z)][order]

    def peak(self, order):
        return [None, mpf(2), 2 * pi, 4 * pi**2][order]


class Trapezoid:
    """1/4 acceleration, 1/2 constant speed, 1/4 braking."""

    def at(self, z, order=0):
        if z > mpf(3) / 4:
            return [1 - self.at(1 - z), self.at(1 - z, 1)][order] if order < 2 else -self.at(1 - z, 2)
        a = mpf(16) / 3
        if z <= mpf(1) / 4:
            return [a * z * z / 2, a * z, a][order]
        return [a / 32 + a / 4 * (z - mpf(1) / 4), a / 4, mpf(0)][order]

    def peak(self, order):
        return [None, mpf(4) / 3, mpf(16) / 3, inf][order]


RAMPS = {"line": Line(), "simple_sine": Sine(), "345": Polynomial(3), "4567": Polynomial(4),
         "56789": Polynomial(5)}
RETURNS = {"345": RAMPS["345"], "4567": RAMPS["4567"], "56789": RAMPS["56789"],
           "inclined_sine": Cycloid(), "trapezoid": Trapezoid()}


def exact(case):
    return {k: v if isinstance(v, str) else mpf(v) for k, v in case.items()}



def ramp_length(c, v):
    """The shortest run-up whose peaks are within the limits, times the safety."""
    law, k, least = RAMPS[c["ramp"]], ratio(c), mpf(0)
    if "acceleration" in c:
        least = max(least, law.peak(1) * k * v**2 / c["acceleration"])
    if "jerk" in c:
        least = max(least, sqrt(law.peak(2) * k * v**3 / c["jerk"]))
    return c.get("safety", mpf(1)) * least


def ratio(c):
    return c.get("ratio", mpf(1)) / cos(c.get("angle", mpf(0)))


def cycle(c, v):
    xa = c["acceleration_length"] if "acceleration_length" in c else ramp_length(c, v)
    xd = c.get("deceleration_length", xa)
    xs = c["sync_length"] if "sync_length" in c else v * c["sync_time"]
    stroke = ratio(c) * ((xa + xd) * RAMPS[c["ramp"]].area(mpf(1)) + xs)
    return xa, xs, xd, stroke


def feasible(c, v, length):
    xa, xs, xd, stroke = cycle(c, v)
    k, ramp, back = ratio(c), RAMPS[c["ramp"]], RETURNS[c["return_law"]]
    rest = length - xa - xs - xd
    if rest <= 0 or ("stroke" in c and stroke > c["stroke"]):
        return False
    if "velocity" in c and max(k * v, back.peak(1) * stroke * v / rest) > c["velocity"]:
        return False
    if "acceleration" in c:
        peak = max(ramp.peak(1) * k * v**2 / min(xa, xd), back.peak(2) * stroke * v**2 / rest**2)
        if peak > c["acceleration"] * (1 + mpf(10)**-35):
            return False
    if "jerk" in c:
        peak = max(ramp.peak(2) * k * v**3 / min(xa, xd)**2, back.peak(3) * stroke * v**3 / rest**3)
        if peak > c["jerk"] * (1 + mpf(10)**-35):
            return False
    return True


def bisect(good, bad, holds):
    for _ in range(130):
        mid = (good + bad) / 2
        good, bad = (mid, bad) if holds(mid) else (good, mid)
    return good


def slave(c, x):
    """Position and slope of the carriage where the line is x further."""
    v, k = c["line_speed"], ratio(c)
    xa, xs, xd, stroke = cycle(c, v)
    ramp, back = RAMPS[c["ramp"]], RETURNS[c["return_law"]]
    rest = c.get("return_length", c["cut_length"] - xa - xs - xd)
    if x <= xa:
        return k * xa * ramp.area(x / xa), k * ramp.at(x / xa)
    if x <= xa + xs:
        return k * (xa / 2 + x - xa), k
    if x <= xa + xs + xd:
        z = (x - xa - xs) / xd
        return stroke - k * xd * (ramp.area(mpf(1)) - z + ramp.area(z)), k * (1 - ramp.at(z))
    z = (x - xa - xs - xd) / rest
    if z >= 1:
        return mpf(0), mpf(0)
    return stroke * (1 - back.at(z)), -stroke / rest * back.at(z, 1)


def solved(case):
    c = exact(case)
    v, length = c["line_speed"], c["cut_length"]
    xa, xs, xd, stroke = cycle(c, v)
    rest = length - xa - xs - xd
    back = RETURNS[c["return_law"]]
    out = {"spec": case, "accelerate": xa, "sync": xs, "decelerate": xd, "stroke": stroke}
    out["feasible"] = feasible(c, v, length)
    if out["feasible"] or "return_length" in c:
        rest = c.get("return_length", rest)
        out["back"] = rest
        out["return_velocity"] = back.peak(1) * stroke * v / rest
        out["return_acceleration"] = back.peak(2) * stroke * v**2 / rest**2
        out["points"] = [[x, *slave(c, x)] for x in (length * mpf(i) / 16 for i in range(1, 16))]
    if "return_length" not in c:
        far = length * 1000
        if feasible(c, v, far):
            out["least_cut_length"] = bisect(far, mpf(0), lambda x: feasible(c, v, x))
        slow, fast = v / 1000, v * 1000
        if feasible(c, slow, length) and not feasible(c, fast, length):
            out["greatest_line_speed"] = bisect(slow, fast, lambda w: feasible(c, w, length))
    return out


def rounded(value):
    if isinstance(value, mpf):
        return float(value)
    if isinstance(value, dict):
        return {k: rounded(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(v) for v in value]
    return value


def random_case(rng):
    v = round(rng.uniform(0.2, 3), 3)
    case = {"cut_length": round(rng.uniform(0.5, 6), 3), "line_speed": v,
            "acceleration": round(rng.uniform(2, 30), 2), "velocity": round(v * rng.uniform(0.9, 4), 3),
            "ramp": rng.choice(sorted(RAMPS)), "return_law": rng.choice(sorted(RETURNS))}
    case["sync_time" if rng.random() < 0.5 else "sync_length"] = round(rng.uniform(0.02, 0.3), 3)
    if rng.random() < 0.3:
        case["stroke"] = round(rng.uniform(0.1, 2), 3)
    if rng.random() < 0.3:
        case["safety"] = round(rng.uniform(1, 2), 2)
    if rng.random() < 0.3:
        case["angle"] = round(rng.uniform(-1, 1), 3)
    smooth = case["ramp"] != "line" and case["return_law"] not in ("trapezoid",)
    if smooth and rng.random() < 0.4:
        case["jerk"] = round(rng.uniform(50, 3000), 1)
    return case


def main():
    shear2 = {"cut_length": 1.0, "line_speed": 1.0, "acceleration": 10.0, "sync_time": 0.15}
    cases = {
        "lubieml": {"cut_length": 36.0, "line_speed": 30.0, "acceleration": 300.0, "sync_time": 0.1,
                    "safety": 1.5, "ramp": "line", "return_law": "trapezoid"},
        "case_2": {**shear2, "ramp": "345", "return_law": "345"},
        "case_2_power7": {**shear2, "ramp": "4567", "return_law": "4567"},
        "trio": {"cut_length": 160.0, "line_speed": 1.0, "acceleration_length": 0.6, "sync_length": 0.4,
                 "return_length": 8.4, "ramp": "line", "return_law": "345"},
    }
    first = solved(cases["lubieml"])
    for key, printed in {"stroke": 7.5, "back": 24, "return_velocity": 12.5, "return_acceleration": 62.5}.items():
        assert abs(first[key] - printed) < 1e-13, key
    assert not solved(cases["case_2_power7"])["feasible"] and solved(cases["case_2"])["feasible"]
    rng = random.Random(52)
    for i in range(80):
        cases[f"random_{i + 1}"] = random_case(rng)
    lines = [f"{json.dumps(name)}: {json.dumps(rounded(solved(case)), sort_keys=True)}" for name, case in cases.items()]
    text = "{\n" + ",\n".join(lines) + "\n}\n"
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "shear.json")
    if "--check" in sys.argv:
        sys.exit(0 if open(path, encoding="utf-8").read() == text else 1)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


main()
