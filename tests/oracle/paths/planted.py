# SPDX-License-Identifier: Apache-2.0
"""Exact plans and planted violations of 1e-6, with the answer that path_judge.py must give."""
import copy
import math
import random

from paths import bernstein as bn
from paths import formulas
from paths.bounds import second_order_bound
from paths.job import Curve, Job
from paths.plans import (SLOWER, A, V, averaged, circle_from_rest, circle_on_the_fly, curve_json, job, random_blended,
                         square_with_blends, square_with_overlaps, square_with_stops, stopping, with_law)
from paths.random_programs import random_program


def peak(judge, document, axis, key):
    curve = Curve.of_json(document["curves"][axis])
    best = 0.0
    for _, h, c in curve.pieces:
        for _ in range(("velocity", "acceleration", "jerk").index(key) + 1):
            c = bn.derivative(c, h)
        best = max(best, bn.greatest(c)[0], bn.greatest(bn.scale(-1, c))[0])
    return best


def changed(document, change):
    twin = copy.deepcopy(document)
    change(twin)
    return twin


def segments(document, axis):
    return document["curves"][axis]["segments"]


def add_bump(document, axis, index, height):
    """s²(1-s)² of the given height on one segment: position and velocity stay continuous."""
    c = segments(document, axis)[index]["polynomial"]
    c += [0.0] * (5 - len(c))
    for k, x in ((2, 16.0), (3, -32.0), (4, 16.0)):
        c[k] += height * x


def hold(document, count):
    """Keeps the first segments alone, five a leg, as a plan that a hold ended."""
    document["partial"] = True
    for axis in "xy":
        del segments(document, axis)[count:]


def back_and_forth(turns, r=50.0):
    """A half circle at constant speed, by way of `turns` of it; the velocity jumps."""
    far, end = 2 * math.pi * turns, math.pi
    ways = [(far, 0.0), *([(end - far, far)] if far != end else [])]
    sines = lambda phase: [(abs(d), [0.0], [[r, d, a + phase]]) for d, a in ways]
    curves = [curve_json(sines(math.pi / 2)), curve_json(sines(0.0))]
    pieces = [{"type": "arc", "to": [-r, 0.0], "center": [0.0, 0.0], "line": 1, "deviation": 0.0}]
    return job(curves, pieces, [r, 0.0], {"acceleration": 1000.0}, tolerance=1e-9)


def planted(judge):
    """(name, job, kinds of violation that must be found, others that may be)."""
    stops, blends, overlaps = square_with_stops(), square_with_blends(), square_with_overlaps()
    trapezoid, fly = square_with_blends(0.05, 0.3), circle_on_the_fly()
    rest = with_law(circle_from_rest())
    for axis in "xy":  # the exact limits of the refitted circle are its own peaks
        for key in ("velocity", "acceleration", "jerk"):
            rest["axes"]["xy".index(axis)][key] = peak(judge, rest, axis, key)
    for key in ("velocity",):
        rest["path"][key] *= 1 + 1e-9
    helix = with_law(circle_from_rest(climb=20.0))
    for k, axis in enumerate("xyz"):
        for key in ("velocity", "acceleration", "jerk"):
            helix["axes"][k][key] = peak(judge, helix, axis, key)
    helix["path"]["velocity"] *= 1 + 1e-9
    exact_plans = {"square with stops": (stops, set()), "square with T-blends": (blends, set()),
                   "square with overlaps": (overlaps, set()), "square with tiny blends": (trapezoid, {SLOWER[0]}),
                   "circle on the fly": (fly, set()), "circle from rest": (rest, set()), "helix": (helix, set())}
    for name, (document, kinds) in exact_plans.items():
        yield name, document, kinds, set()
    less, more = 1 - 1e-6, 1 + 1e-6

    for name, (document, _) in exact_plans.items():
        for k, axis in enumerate(document["axes"]):
            for key in ("velocity", "acceleration", "jerk"):
                if key in axis:
                    top = peak(judge, document, axis["name"], key)
                    yield f"{name}: {key} of {axis['name']}", changed(document, lambda d: d["axes"][k].update({key: top * less})), \
                        {"limit"}, {*SLOWER}
        yield f"{name}: path speed", changed(document, lambda d: d["path"].update(velocity=80.0 * less if "law" in d else V * less)), \
            {"path limit"}, {*SLOWER}

    def low_deceleration(d):
        for axis in d["axes"]:
            axis["deceleration"] = A * less
    yield "deceleration", changed(stops, low_deceleration), {"limit"}, set()
    yield "deceleration alone", changed(stops, lambda d: [a.update(acceleration=A * 2, deceleration=A * less) for a in d["axes"]]), \
        {"limit"}, {*SLOWER}
    yield "acceleration alone", changed(stops, lambda d: [a.update(acceleration=A * less, deceleration=A * 2) for a in d["axes"]]), \
        {"limit"}, {*SLOWER}
    yield "deceleration allowed", changed(stops, lambda d: [a.update(deceleration=A * 1.5) for a in d["axes"]]), set(), {*SLOWER}
    yield "path acceleration", changed(stops, lambda d: d["path"].update(acceleration=A * less)), {"path limit"}, set()
    yield "path acceleration allowed", changed(stops, lambda d: d["path"].update(acceleration=A)), set(), set()
    yield "path deceleration", changed(stops, lambda d: d["path"].update(acceleration=A, deceleration=A * less)), {"path limit"}, set()
    yield "normal acceleration", changed(fly, lambda d: d["path"].update(normal_acceleration=V * V / 50 * less)), {"path limit"}, \
        {*SLOWER}
    yield "total acceleration", changed(stops, lambda d: d["path"].update(total_acceleration=A * less)), {"path limit"}, set()
    yield "law", changed(rest, lambda d: d["law"].update(jerk=5000.0 * less)), {"limit"}, {*SLOWER}

    for order, name in enumerate(("position", "velocity", "acceleration")):
        size = (100.0, V, A)[order] * 1e-6

        def jump(d, order=order, size=size):
            later = segments(d, "y")[12:]
            c, h = later[0]["polynomial"], later[0]["length"]
            c[order] += size * h**order / (1, 1, 2)[order]
            shift = size * h**order / (1, 1, 2)[order]
            for segment in later[1:]:
                segment["polynomial"][0] += shift
        yield f"jump of {name}", changed(stops, jump), {"continuity"}, {"end", "stop", "corner", "deviation", "limit", "path limit"}
    yield "no rest at the end", changed(stops, lambda d: [segments(d, n).pop() for n in "xy"]), {"continuity", "end"}, {"stop", "corner"}
    yield "end of the program", changed(stops, lambda d: d["pieces"][-1].update(to=[0.0, 1e-4])), {"end"}, \
        {"stop", "corner", "deviation", *SLOWER}
    yield "start of the program", changed(stops, lambda d: d.update(start=[1e-4, 0.0])), {"end"}, {"deviation", *SLOWER}

    yield "corner distance", changed(blends, lambda d: d["pieces"][0].update(deviation=less)), {"corner"}, set()
    yield "corner distance, overlaps", changed(overlaps, lambda d: d["pieces"][1].update(deviation=less)), {"corner"}, set()
    yield "corner distance allowed", changed(blends, lambda d: d["pieces"][0].update(deviation=1.0)), set(), set()
    yield "stop", changed(blends, lambda d: d["pieces"][1].update(stop=True, deviation=0.0)), {"stop"}, {"deviation"}
    halfway = {"type": "line", "to": [50.0, 0.0], "line": 9, "deviation": 0.0}
    yield "through a point of a leg", changed(stops, lambda d: d["pieces"].insert(0, halfway)), set(), set()
    yield "through a stop", changed(stops, lambda d: d["pieces"].insert(0, {**halfway, "stop": True})), {"stop"}, set()
    for axis, index in (("y", 2), ("x", 7)):  # in the middle of a leg
        for sign in (1, -1):
            bumpy = changed(stops, lambda d: add_bump(d, axis, index, sign * 0.01 * more))
            for piece in bumpy["pieces"]:
                piece["deviation"] = 0.01
            loose = {"limit", "continuity", "path limit", "faster than possible"}
            yield f"bump of {axis}, {sign}", bumpy, {"deviation"}, loose
            yield f"bump of {axis}, {sign}, allowed", changed(bumpy, lambda d: add_bump(d, axis, index, -sign * 0.01 * 2e-6)), set(), loose
    yield "radius", changed(fly, lambda d: d["pieces"][1].update(center=[100.0, 50.0 * more])), {"deviation"}, {*SLOWER}
    yield "sense", changed(fly, lambda d: d["pieces"][1].update(clockwise=True)), {"deviation"}, {*SLOWER}
    yield "a turn is missing", changed(fly, lambda d: d["pieces"][1].update(extra_turns=1)), {"deviation"}, {*SLOWER}
    yield "no turn asked for", changed(fly, lambda d: d["pieces"].pop(1)), {"deviation"}, {*SLOWER}
    yield "climb", changed(helix, lambda d: d["pieces"][0].update(to=[50.0, 0.0, 20.0 * more])), {"end"}, {"corner", "deviation", *SLOWER}
    yield "a leg is missing", changed(stops, lambda d: d["pieces"].insert(1, {"type": "line", "to": [120.0, 0.0], "stop": True})), \
        {"deviation"}, {"stop", "corner"}
    yield "other order", changed(stops, lambda d: d["pieces"].reverse()), {"deviation"}, {"end", "stop", "corner", *SLOWER}
    limited = changed(fly, lambda d: [axis.update(jerk=V**3 / 50**2 * more) for axis in d["axes"]])
    limited["axes"][0]["jerk"] = peak(judge, fly, "x", "jerk") * more
    yield "step of the curvature at a tangent joint", limited, set(), {*SLOWER}
    yield "step of the curvature at a joint to round", changed(limited, lambda d: d["pieces"][0].update(deviation=0.01)), \
        {"continuity"}, {*SLOWER}
    yield "feed", changed(stops, lambda d: [p.update(feed=V * less) for p in d["pieces"][:2]]), {"feed"}, set()
    yield "feed of the middle", changed(stops, lambda d: d["pieces"][1].update(feed=V * less)), {"feed"}, set()
    yield "feed allowed", changed(stops, lambda d: [p.update(feed=V) for p in d["pieces"]]), set(), set()

    for kind, turns in ((set(), 0.5), ({"deviation"}, 0.53)):  # a half circle, and one that goes too far and returns
        yield f"half circle through {turns} turns", back_and_forth(turns), {"continuity"} | kind, {*SLOWER}
    held = changed(stops, lambda d: hold(d, 10))
    yield "hold", held, set(), set()
    yield "hold, off the path", changed(held, lambda d: add_bump(d, "y", 2, 1e-4)), {"deviation"}, {"continuity", "limit", "path limit"}
    yield "hold, moving", changed(stops, lambda d: hold(d, 8)), {"continuity"}, set()

    def slower(d, factor):
        for axis in "xy":
            for segment in segments(d, axis):
                segment["length"] *= factor
    yield "slower than stopping", changed(stops, lambda d: slower(d, more)), {SLOWER[0]}, set()
    yield "faster than possible", changed(stops, lambda d: slower(d, 0.85)), {"faster than possible", "limit"}, {"path limit"}


def found_at_random(judge):
    """Random blends, and averaged polylines, whose corners have a closed form: the same triples as `planted`."""
    rng = random.Random(23)
    for i in range(16):
        document = random_blended(rng)
        yield f"random blends {i}", document, set(), {*SLOWER}
        corner = rng.randrange(len(document["pieces"]) - 1)

        def tighter(d):
            d["pieces"][corner]["deviation"] *= 1 - 1e-6
            d["pieces"][corner]["deviation"] -= 2 * d["tolerance"]
        yield f"random blends {i}, corner {corner}", changed(document, tighter), {"corner"}, {*SLOWER}
    for seed in range(30):  # zero lengths, reversals, tiny steps
        document = stopping(random_program(seed)[1])
        if document:
            yield f"random lines {seed}", document, set(), {*SLOWER}
    for name, points, window in (("stairs", formulas.zigzag(5, 20), 4.0), ("Hilbert", formulas.hilbert(3), 1.5)):
        plan = averaged(points, window)  # a corner alone in its window: the parabola, |w - u| window / 8
        for share, kinds in ((1.0, set()), (1 - 1e-6, {"corner"})):
            yield f"averaged {name}, {share}", changed(plan, lambda d: [
                p.update(deviation=math.sqrt(2) * window / 8 * share) for p in d["pieces"]]), kinds, {*SLOWER}
    circle = [[50 * math.cos(i / 100), 50 * math.sin(i / 100)] for i in range(200)]  # many corners within the window
    for name, points, window, allowed in (("circle", circle, 4.0, 0.02), ("walk", [p[:2] for p in formulas.random_walk(40)], 3.0, 0.75)):
        plan = averaged(points, window)
        yield f"averaged {name}", changed(plan, lambda d: [p.update(deviation=allowed) for p in d["pieces"]]), set(), {*SLOWER}
        yield f"averaged {name}, half", changed(plan, lambda d: [p.update(deviation=allowed / 2) for p in d["pieces"]]), {"corner"}, \
            {*SLOWER}


def wrong_bounds():
    """The bound without limits of jerk: 1.1 s a side with stops; 4.194 s with blends, approached from below."""
    stops, blends = (second_order_bound(Job(d), 2000) / 0.999 for d in (square_with_stops(), square_with_blends()))
    return [f"bound {x:.9g}, expected {text}" for x, ok, text in (
        (stops, abs(stops - 4.4) < 1e-9, "4.4"), (blends, 4.18 < blends < 4.194, "less than 1 % below 4.194")) if not ok]


def self_test(judge):
    wrong, count = wrong_bounds(), 0
    for name, document, must, may in (*planted(judge), *found_at_random(judge)):
        report = judge(document)
        kinds = {v["kind"] for v in report.violations}
        count += 1
        if not must <= kinds or not kinds <= must | may:
            wrong.append(f"{name}: found {sorted(kinds)}, expected {sorted(must)}")
            wrong += ["    " + row for row in report.text()]
    print(*wrong, f"{count} plans judged, {count - sum(not w.startswith(' ') for w in wrong)} as expected", sep="\n")
    return 1 if wrong else 0
