# SPDX-License-Identifier: Apache-2.0
"""Random cases of arcs, blends and ramps, and the benchmark paths with a stop at each corner."""
import exact
from exact import check_equal
from mpmath import cbrt, cos, inf, mp, mpf, pi, sin, sqrt
from paths import formulas
from paths.ramps import along, corner_speed, leg, ramp_length, ramp_time, reach
from paths.shapes import (POLYNOMIAL_TURNS, HermiteBlend, TBlend, arc, by_center, by_radius, by_three_points, by_turns,
                          ellipse_length, greatest, helix, in_space, minus, nearest_center, norm, plus, trim_for,
                          turn_shape, unit)
from paths.study import A, J, V, X, Y, floats, given, study


def draw(rng, low, high, digits=3):
    return round(rng.uniform(low, high), digits)


def make_arcs(rng):
    cases = []
    for i in range(24):
        center = [draw(rng, -100, 100), draw(rng, -100, 100)]
        start = [draw(rng, -100, 100), draw(rng, -100, 100)]
        degrees = draw(rng, 5, 355, 1) * (1 if i % 2 else -1)
        made = arc(given(start), given(center), pi * exact.exact(degrees) / 180)
        end = floats(made["points"][-1])  # rounded to doubles: the definitions below start from these
        case = {"start": start, "end": end}
        if i % 4 == 0:
            extra = rng.randrange(3)
            moved = nearest_center(given(start), given(end), given(center))
            result = by_center(given(start), given(end), moved["center"], degrees < 0, extra)
            case |= {"definition": "center", "center": center, "clockwise": degrees < 0, "extra_turns": extra}
        elif i % 4 == 1:
            radius = round(float(made["radius"]), 3) + 0.5
            radius *= -1 if abs(degrees) > 180 else 1
            result = by_radius(given(start), given(end), exact.exact(radius), degrees < 0)
            case |= {"definition": "radius", "radius": radius, "clockwise": degrees < 0}
        elif i % 4 == 2:
            case["via"] = floats(arc(given(start), given(center), pi * mpf(degrees) / 180 * mpf(rng.uniform(0.2, 0.8)))["points"][-1])
            result = by_three_points(given(start), given(case["via"]), given(end))
            case["definition"] = "three_points"
        else:
            result = made
            case |= {"definition": "angle", "center": center, "angle_deg": degrees}
            del case["end"]
        cases.append({"case": case, "result": result})
    space = []
    for _ in range(8):
        points = [[draw(rng, -50, 50) for _ in range(3)] for _ in range(3)]
        space.append({"start": points[0], "via": points[1], "end": points[2], "result": in_space(*map(given, points))})
    misfits = []
    for size in (1e-9, 1e-4, 0.01, 1.0):
        start, end = [50.0, 0.0], [0.0, 50.0]
        misfits.append({"start": start, "end": end, "center": [size, size / 2],
                        "result": nearest_center(given(start), given(end), given([size, size / 2]))})
    turns = []
    for n in range(-3, 4):
        for end in ([0.0, 50.0], [0.0, -50.0], [50.0, 0.0]):
            turns.append({"start": [50.0, 0.0], "end": end, "center": [0.0, 0.0], "turns": n,
                          "sweep": by_turns(given((50, 0)), given(end), given((0, 0)), n)})
    ellipses = []
    for _ in range(8):
        a, b = draw(rng, 10, 100), draw(rng, 1, 100)
        t0 = draw(rng, 0, 6)
        t1 = round(t0 + rng.uniform(0.1, 7), 3)
        ellipses.append({"half_axes": [a, b], "from": t0, "to": t1,
                         "length": ellipse_length(*map(exact.exact, (a, b, t0, t1)))})
    helices = [{"radius": r, "pitch": p, **helix(exact.exact(r), exact.exact(p))} for r, p in
               ((50.0, 20.0), (50.0, 25.0), (1.0, 0.1), (3.5, -7.0), (1000.0, 1e-3))]
    return {"planar": cases, "in_space": space, "misfits": misfits, "turns": turns, "ellipses": ellipses, "helices": helices}


def make_t_blends(rng):
    cases = []
    while len(cases) < 40:
        before, corner, after = ([draw(rng, -50, 50) for _ in range(3)] for _ in range(3))
        if len(cases) % 3 == 0:
            before[2] = corner[2] = after[2] = 0.0
        u, w = unit(minus(given(corner), given(before))), unit(minus(given(after), given(corner)))
        turn = norm(minus(w, u))
        share = (0.0, 0.5, 0.25, 0.1)[len(cases) % 4]
        e = draw(rng, 0.001, 2)
        blend = TBlend(u, w, turn_shape(exact.exact(share)))
        length = blend.length_for(exact.exact(e))
        room = min(norm(minus(given(corner), given(before))), norm(minus(given(after), given(corner)))) / 2
        if length / 2 > room:
            continue
        half = mp.asin(turn / 2)
        kappa = blend.curvature(mpf(1) / 2, length)
        check_equal("T-blend: peak curvature", kappa, turn * blend.rate(mpf(1) / 2) / (length * cos(half) ** 2), mpf(10) ** -40)
        for x in range(65):  # the middle has the peak, the curve leaves the legs by at most e cos(phi/2)
            assert blend.curvature(mpf(x) / 64, length) <= kappa * (1 + mpf(10) ** -40)
            assert blend.off_path(mpf(x) / 64, length) <= exact.exact(e) * cos(half) * (1 + mpf(10) ** -40)
        check_equal("T-blend: middle leaves the legs by e cos(phi/2)", blend.off_path(mpf(1) / 2, length), exact.exact(e) * cos(half))
        v, a, j = ([draw(rng, 50, 200, 1) for _ in range(3)], [draw(rng, 200, 3000, 0) for _ in range(3)],
                   [draw(rng, 2000, 50000, 0) for _ in range(3)])
        best = corner_speed(u, w, lambda b: TBlend(u, w, turn_shape(b)).length_for(exact.exact(e)), room,
                            *(given(x) for x in (v, a, j)))
        cases.append({"before": before, "corner": corner, "after": after, "share": share, "deviation": e,
                      "deflection": 2 * half, "half_area": blend.half, "length": length, "trim": length / 2,
                      "curvature": kappa, "off_path": exact.exact(e) * cos(half),
                      "points": [plus(given(corner), blend.at(mpf(x) / 8, length)) for x in range(9)],
                      "limits": {"velocity": v, "acceleration": a, "jerk": j},
                      "best": {"speed": best[0], "share": best[1], "length": best[2]}})
    table = []
    for name, shape in [(f"share {b}", turn_shape(exact.exact(b))) for b in (0.0, 0.1, 0.25, 0.5)] + list(POLYNOMIAL_TURNS.items()):
        blend = TBlend(X, Y, shape)  # e / (d S) = 4 i, and the curvature e C^2 / S^2 at e = 1
        table.append({"shape": name, "half_area": blend.half, "e_by_dS": 4 * blend.half,
                      "curvature_e": blend.curvature(mpf(1) / 2, blend.length_for(mpf(1)))})
    printed = (("1/8", "1/2", "1/2"), None, None, ("1/12", "1/3", "2/3"), ("3/32", "3/8", "9/16"), ("5/64", "5/16", "75/128"))
    for row, fractions in zip(table, printed):
        if fractions:
            for key, text in zip(("half_area", "e_by_dS", "curvature_e"), fractions):
                top, bottom = text.split("/")
                check_equal(f"2.1 {row['shape']} {key}", row[key], mpf(top) / mpf(bottom))
    return {"table": table, "corners": cases}


def make_hermite(rng):
    """Line and arc, arc and arc, in the plane: the corner at the origin, directions and signed radii (left > 0)."""
    cases = []
    while len(cases) < 24:
        angles = [draw(rng, -180, 180, 1), draw(rng, -150, 150, 1)]
        radii = [None, draw(rng, 20, 80, 1) * rng.choice((-1, 1))]
        if len(cases) % 3 == 1:
            radii = radii[::-1]
        elif len(cases) % 3 == 2:
            radii[0] = draw(rng, 20, 80, 1) * rng.choice((-1, 1))
        orders = 3 if len(cases) % 2 else 4
        e = draw(rng, 0.01, 1.5)
        u = [cos(pi * exact.exact(angles[0]) / 180), sin(pi * exact.exact(angles[0]) / 180)]
        heading = pi * (exact.exact(angles[0]) + exact.exact(angles[1])) / 180
        w = [cos(heading), sin(heading)]
        inputs = (u, radii[0] and exact.exact(radii[0]), w, radii[1] and exact.exact(radii[1]))
        most = min([mpf(30)] + [abs(r) for r in inputs[1::2] if r])
        d = trim_for(exact.exact(e), *inputs, orders, most)
        if d is None or abs(angles[1]) < 10:
            continue
        curve = HermiteBlend(*inputs, d, orders)
        cases.append({"heading_deg": angles[0], "deflection_deg": angles[1], "radius_before": radii[0], "radius_after": radii[1],
                      "degree": 2 * orders - 1, "deviation": e, "trim": d,
                      "curvature": float(mp.nstr(greatest(curve.curvature, mpf(0), 2 * d), 14)),
                      "off_path": float(mp.nstr(greatest(curve.off_path, mpf(0), 2 * d), 14)),
                      "points": [curve.at(2 * d * i / 8) for i in range(9)]})
    return cases


def make_ramps(rng):
    ramps, reaches, stops = [], [], []
    for _ in range(24):
        a, j, low = draw(rng, 100, 5000, 0), draw(rng, 1000, 100000, 0), draw(rng, 0, 100)
        change = draw(rng, 0.001, 300)
        args = [exact.exact(x) for x in (low, change, a, j)]
        ramps.append({"acceleration": a, "jerk": j, "from": low, "change": change, "time": ramp_time(*args[1:]),
                      "length": ramp_length(args[0], args[0] + args[1], *args[2:])})
    rows = [(0.0, 1.0), (5.0, 1.0), (20.0, 1.0), (1e-6, 1e-9), (1000.0, 1e-6), (100.0, 1e-3), (0.0, 1e-12), (1e4, 1e3)]
    rows += [(draw(rng, 0, 200), float(f"{10 ** rng.uniform(-6, 3):.6g}")) for _ in range(40)]
    for i, (low, length) in enumerate(rows):
        a = None if i % 2 == 0 else draw(rng, 100, 5000, 0)
        top = reach(exact.exact(low), exact.exact(length), inf if a is None else exact.exact(a), J)
        reaches.append({"from": low, "length": length, "acceleration": a, "jerk": float(J), "speed": top,
                        "gain": top - exact.exact(low)})
    least = bisect_least_reach()
    for _ in range(24):
        case = {"length": float(f"{10 ** rng.uniform(-3, 3):.6g}"), "velocity": draw(rng, 10, 300, 1),
                "acceleration": draw(rng, 100, 5000, 0), "deceleration": draw(rng, 100, 5000, 0), "jerk": draw(rng, 1000, 100000, 0)}
        l, v, a, d, j = (exact.exact(case[k]) for k in ("length", "velocity", "acceleration", "deceleration", "jerk"))
        time, peak = leg(l, mpf(0), mpf(0), v, a, j, d)
        stops.append(case | {"time": time, "peak": peak})
    return {"ramps": ramps, "reach": reaches, "reach_least": least, "rest_to_rest": stops}


def bisect_least_reach():
    """Where F(v; 1), A infinite, stops to fall: F = 3 v there."""
    slope = lambda v: mp.diff(lambda x: reach(x, mpf(1), inf, J), v)
    v = exact.bisect(lambda x: reach(x, mpf(1), inf, J) - 3 * x, mpf(1), mpf(20))
    assert abs(slope(v)) < mpf(10) ** -15, "F falls until it is three times v"
    return {"from": v, "speed": 3 * v}


def make_programs():
    """Time with a stop at each corner of the benchmark paths, with the axes' limits along each leg."""
    out, short = {}, lambda length, k: cbrt(32 * length / (k * J))  # a leg below A and V
    for length, k in ((mpf(1) / 10, mpf(1)), (mpf(2), mpf(6) / 5), (mpf(1) / 5, sqrt(mpf(2)))):
        check_equal("short leg", short(length, k), leg(length, mpf(0), mpf(0), V, k * A, k * J)[0])
    for name, points in formulas.benchmarks().items():
        for key, merged in (("stop", False), ("stop_merged", True)):
            times_of = []
            for length, direction in formulas.legs(points, merged):
                k, length = along(given(direction), inf, [mpf(1)] * 3), mpf(length)
                is_short = length <= min(2 * k * A**3 / J**2, sqrt(V**3 / (k * J)))
                times_of.append(short(length, k) if is_short else leg(length, mpf(0), mpf(0), V, k * A, k * J)[0])
            out.setdefault(name, {})[key] = float(mp.nstr(sum(times_of), 12))
            out[name]["legs" if key == "stop" else "legs_merged"] = len(times_of)
    for name, key, text in (("butterfly", "stop", "294.2"), ("chord_circle", "stop", "70.86"), ("hilbert", "stop_merged", "161.7"),
                            ("cut_line", "stop", "136.0")):
        study(f"4 {name}, {key}", text, mpf(out[name][key]))
    return out
