# SPDX-License-Identifier: Apache-2.0
"""The examples of the manuals, recomputed: PMC600 volume 4, chapters 7 and 8; HIMC HMPL, chapter 8."""
from exact import check_equal
from mpmath import acos, cos, inf, mp, mpf, pi, sin, sqrt, tan
from paths.ramps import ideal_circle, leg
from paths.shapes import (POLYNOMIAL_TURNS, TBlend, arc, by_radius, by_three_points, by_turns, ellipse_from,
                          ellipse_length, helix, minus, norm, plus, turn, turn_shape)
from paths.study import V, X, Y, given, study


def trapezoid(length, v, a):
    return leg(mpf(length), 0, 0, mpf(v), mpf(a), inf)[0]


def ratio_example(length, v, a, changes):
    """A trapezoid whose speed is v times a ratio that changes at given times: integrated step by step."""
    way, speed, now = mpf(0), mpf(0), mpf(0)
    for (start, ratio), end in zip(changes, [c[0] for c in changes[1:]] + [inf]):
        goal = v * ratio
        ramp = min(abs(goal - speed) / a, end - now)
        after = speed + ramp * a * mp.sign(goal - speed)
        way, speed, now = way + (speed + after) / 2 * ramp, after, now + ramp
        if end != inf:
            way, now = way + speed * (end - now), end
    brake = speed / a
    return now + (length - way - speed * brake / 2) / speed + brake


def make_pmc600():
    out = {}
    lengths = [norm(given((500, 1000, 1000))), norm(given((1500, 500, 1000)))]
    out["8.1"] = {"lengths": lengths, "times": [trapezoid(s, 1000, 1000) for s in lengths]}
    study("P 8.1 first", "2.5", out["8.1"]["times"][0])
    study("P 8.1 second", "2.870829", out["8.1"]["times"][1])
    ratio = ratio_example(mpf(5000), mpf(3000), mpf(10000),
                          [(mpf(0), mpf(1) / 2), (mpf(1) / 5, mpf(3) / 2), (mpf(3) / 5, mpf(1))])
    out["8.2"] = {"time": study("P 8.2", "1.866667", ratio)}

    first = by_radius(given((0, 0)), given((10000, 0)), mpf(5000), True)
    second = by_radius(given((10000, 0)), given((30000, 0)), mpf(10000), False)
    half_ramp, half_time, half_speed = ideal_circle(mpf(5000), mpf(20000), mpf(10000))
    total = 2 * half_time + (5000 * pi - 2 * half_ramp) / half_speed
    big_ramp, big_time, big_speed = ideal_circle(mpf(10000), mpf(20000), mpf(10000))
    big = 2 * big_time + (10000 * pi - 2 * big_ramp) / big_speed
    out["8.3"] = {"arcs": [first, second], "times": [trapezoid(a["length"], 10000, 20000) for a in (first, second)],
                  "normal_acceleration": [mpf(10000) ** 2 / r for r in (5000, 10000)],
                  "times_total_acceleration": [total, big]}
    study("P 8.3 first", "2.070796", out["8.3"]["times"][0])
    study("P 8.3 second", "3.641593", out["8.3"]["times"][1])
    study("P 8.3 total acceleration", "2.096427", total)

    ellipses = []
    for start, center, angle, clockwise, middle in (((0, 0), (5000, 0), 0, True, (5000, 4000)),
                                                    ((10000, 0), (10000, 5000), 90, False, (14000, 5000))):
        major, minor, phase = ellipse_from(given(start), given(center), pi * angle / 180, mpf(4) / 5)
        at = phase + (-pi / 2 if clockwise else pi / 2)
        c, s = cos(pi * angle / 180), sin(pi * angle / 180)
        passes = [center[0] + major * cos(at) * c - minor * sin(at) * s, center[1] + major * cos(at) * s + minor * sin(at) * c]
        for got, want in zip(passes, middle):
            check_equal("P 8.4 passes", got, mpf(want), mpf(10) ** -40)
        length = ellipse_length(major, minor, phase, phase + pi)
        ellipses.append({"half_axes": [major, minor], "passes": passes, "length": length,
                         "time": trapezoid(length, 10000, 20000), "normal_acceleration": mpf(10) ** 8 * major / minor ** 2})
    out["8.4"] = ellipses
    study("P 8.4", "1.918083", ellipses[0]["time"])
    study("P 8.4 half perimeter", "14180.834", ellipses[0]["length"])
    study("P 8.4 normal acceleration", "31250", ellipses[0]["normal_acceleration"])

    plane = 7 * pi * 5000
    out["8.5"] = {"turns": mpf(7) / 2, "plane": plane, "length_z_10000": sqrt(plane ** 2 + mpf(10) ** 8),
                  "length_z_20000": sqrt(plane ** 2 + 4 * mpf(10) ** 8)}
    study("P 8.5 plane", "109955.743", plane)
    study("P 8.5 Z 10000", "110409.535", out["8.5"]["length_z_10000"])
    study("P 8.5 Z 20000", "111759.856", out["8.5"]["length_z_20000"])

    points = [given(p) for p in ((0, 0), (1000, 1000), (3000, 2000), (4000, 0))]
    legs = [minus(b, a) for a, b in zip(points, points[1:])]
    turns = [turn(a, b) for a, b in zip(legs, legs[1:])]
    fillets = {str(r): [{"trim": r * tan(abs(t) / 2), "deviation": r * (1 / cos(t / 2) - 1)} for t in turns] for r in (100, 50)}
    out["8.6"] = {"lengths": [norm(g) for g in legs], "turns_deg": [t * 180 / pi for t in turns],
                  "stop_slow": sum(trapezoid(norm(g), 1000, 2000) for g in legs),
                  "stop_fast": sum(trapezoid(norm(g), 10000, 20000) for g in legs), "fillets": fillets}
    study("P 8.6 slow", "7.386350", out["8.6"]["stop_slow"])
    study("P 8.6 fast", "1.869310", out["8.6"]["stop_fast"])
    study("P 8.6 trim", "16.2278", fillets["100"][0]["trim"])
    study("P 8.6 trim 2", "100.0", fillets["100"][1]["trim"])
    study("P 8.6 deviation", "1.3081", fillets["100"][0]["deviation"])
    study("P 8.6 deviation 2", "41.4214", fillets["100"][1]["deviation"])

    diagonal = norm(given((1000, 1000)))
    out["8.8"] = {"line": diagonal, "line_time": trapezoid(diagonal, 1000, 2000), "chords": [norm(given((0, -1000))), mpf(1000)],
                  "least_radius": mpf(500)}
    far = norm(given((50000, 50000)))
    out["8.9"] = {"length": far, "times": [trapezoid(far, 50000, 500000), trapezoid(far, 30000, 300000)]}
    study("P 8.9 first", "1.514214", out["8.9"]["times"][0])
    study("P 8.9 second", "2.457023", out["8.9"]["times"][1])
    # 7.3.1: the manual gives no numbers; with a blend the Y speed is that of r' = u + (w - u) T, hence continuous.
    out["7.3.1"] = {"turn_area_at_half": {name: TBlend(X, Y, turn_shape(b)).half for name, b in
                                          (("box", mpf(0)), ("half", mpf(1) / 4), ("triangle", mpf(1) / 2))}}
    return out


def himc_leg(length, v, a, smoothing):
    """HIMC 5.1: J = a / Ts and a ramp of Ta + Ts, also where Ta < Ts: a trapezoid averaged over Ts."""
    return trapezoid(length, v, a) + mpf(smoothing)


def make_himc():
    out = {}
    diagonal = norm(given((100, 100)))
    out["8.1.6_1"] = {"length": diagonal, "time": himc_leg(diagonal, 100, 5000, mpf(1) / 5),
                      "least_time_with_that_jerk": leg(diagonal, mpf(0), mpf(0), V, mpf(5000), mpf(25000))[0]}
    study("H Ex 1", "1.634214", out["8.1.6_1"]["time"])
    out["8.1.6_2"] = {"arc": 50 * pi}
    study("H Ex 2 arc", "157.08", out["8.1.6_2"]["arc"])

    theta, rows = pi / 2, []
    s, c = sin(theta / 2), cos(theta / 2)
    curves = {"parabola": turn_shape(mpf(0)), "quartic": POLYNOMIAL_TURNS["quartic"], "triangle": turn_shape(mpf(1) / 2)}
    printed = {"parabola": ("14.142136", "11.313708"), "quartic": ("10.606602", "15.084945"),
               "triangle": ("9.428090", "16.970563")}
    for name, shape in curves.items():
        blend = TBlend(X, Y, shape)
        e_of_40 = norm(blend.turn) * 80 * blend.half
        d_of_4 = blend.length_for(mpf(4)) / 2
        one = blend.curvature(mpf(1) / 2, mpf(2))  # trim 1; the curvature falls with 1 / trim
        d_of_k = one / mpf("0.04")
        rows.append({"curve": name, "deviation_of_d_40": e_of_40, "trim_of_e_4": d_of_4, "trim_of_k_0.04": d_of_k,
                     "fits_half_a_side": bool(d_of_k <= 50)})
        study(f"H row 13 d 40 {name}", printed[name][0], e_of_40)
        study(f"H row 13 e 4 {name}", printed[name][1], d_of_4)
    least_curvature = 6 * sin(theta) / (100 * (2 - 2 * cos(theta)) ** (mpf(3) / 2))
    check_equal("H: the curvature rule is the quartic", least_curvature,
                TBlend(X, Y, POLYNOMIAL_TURNS["quartic"]).curvature(mpf(1) / 2, mpf(200)))
    out["8.1.6_3-1"] = {"curves": rows, "greatest_deviation": mpf(40) * c / 2, "least_curvature": least_curvature}
    study("H Ex 3-1 greatest e", "14.142", out["8.1.6_3-1"]["greatest_deviation"])
    study("H Ex 3-1 least k", "0.0212", least_curvature)
    check_equal("H: the deviation rule is the parabola", rows[0]["deviation_of_d_40"], 40 * s / 2)

    out["8.1.6_4"] = {"radius": norm(given((0, 50))),
                      "revolutions": {str(n): {**helix(mpf(50), mpf(100) / n), "length": n * helix(mpf(50), mpf(100) / n)["turn"]}
                                      for n in (4, 5)}}

    def frame(p, origin, degrees=0):
        angle = pi * mpf(degrees) / 180
        return [origin[0] + p[0] * cos(angle) - p[1] * sin(angle), origin[1] + p[0] * sin(angle) + p[1] * cos(angle)]

    point, bases = given((10, 10)), {"WCS1": (400, 400), "WCS2": (600, 0), "WCS3": (800, -400)}
    out["8.1.6_5-1"] = frame(point, (400, 200), 45)
    out["8.1.6_5-2"] = {k: frame(frame(point, (100, 50), 45), b) for k, b in bases.items()}
    out["8.1.6_5-3"] = {k: plus(v, given((0, -100))) for k, v in out["8.1.6_5-2"].items()}
    study("H Ex 5-1", "214.1421", out["8.1.6_5-1"][1])
    for k, text in (("WCS1", "464.1421"), ("WCS2", "64.1421"), ("WCS3", "-335.8579")):
        study(f"H Ex 5-2 {k}", text, out["8.1.6_5-2"][k][1])

    caps = []  # 8.1.4: corner A dT / (1 - cos), arc sqrt(A r), chord 2 r phi / dT with the half angle phi of the chord
    for degrees in (10, 45, 90, 135, 180):
        caps.append({"turn_deg": degrees, "acceleration": mpf(5000), "cycle": mpf(1) / 4000,
                     "corner": mpf(5000) / 4000 / (1 - cos(pi * mpf(degrees) / 180))})
    out["8.1.4"] = {"corners": caps, "arc": sqrt(mpf(100) * 50),
                    "chord_1_um": 2 * mpf(50) * acos(1 - mpf("0.001") / 50) * 4000}
    out["row_6"] = arc(given((0, 0)), given((10, 10)), pi / 4)
    check_equal("H row 6", out["row_6"]["points"][-1][1], 10 - 10 * sqrt(mpf(2)))
    sweeps = []
    for turns, want in ((-2, -510), (-1, -150), (0, 210), (1, 210), (2, 570)):
        end = [cos(pi * 210 / 180), sin(pi * 210 / 180)]
        sweep = by_turns(X, end, given((0, 0)), turns) * 180 / pi
        check_equal("H row 7", sweep, mpf(want), mpf(10) ** -40)
        sweeps.append({"turns": turns, "sweep_deg": mpf(want)})
    out["row_7"] = sweeps
    out["row_8"] = arc(given((0, 0)), given((100, 0)), by_turns(given((0, 0)), given((200, 0)), given((100, 0)), 1))
    check_equal("H row 8", out["row_8"]["points"][2][1], mpf(-100))
    out["row_9"] = by_three_points(given((0, 0)), given((100, 100)), given((200, 0)))
    check_equal("H row 9", out["row_9"]["sweep"], -pi)
    out["row_10"] = plus(given((100, 200)), given((100, 100)))
    out["row_20"] = study("H row 20", "70.71", sqrt(mpf(100) * 50))
    return out
