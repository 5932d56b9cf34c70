# SPDX-License-Identifier: Apache-2.0
"""The rows 1 to 13 of the study: V = 100 mm/s along the path, A = 1000 mm/s² and J = 10000 mm/s³ on every axis."""
import exact
from exact import check_equal
from mpmath import acos, cbrt, inf, mp, mpf, pi, sqrt
from paths.ramps import corner_speed, ideal_circle, leg, overlap_time, reach
from paths.shapes import POLYNOMIAL_TURNS, HermiteBlend, TBlend, greatest, helix, trim_for, turn_shape
from paths.study import A, J, V, X, Y, study


def square(side, deviation, v, a, j):
    """The square with T-blends at constant corner speed, from rest to rest at the corner where it begins."""
    blend = lambda share: TBlend(X, Y, turn_shape(share)).length_for(deviation)
    speed, share, length = corner_speed(X, Y, blend, side / 2, [v, v], [a, a], [j, j])
    ends = leg(side - length / 2, mpf(0), speed, v, a, j)[0]
    inner = leg(side - length, speed, speed, v, a, j)[0]
    return {"deviation": deviation, "corner_speed": speed, "share": share, "blend_length": length,
            "time": 2 * ends + 2 * inner + 3 * length / speed}


def make_rows():
    line = leg(mpf(200), 0, 0, V, A, J)[0]
    study("1 line 200", "2.200000", line)
    side = leg(mpf(100), 0, 0, V, A, J)[0]
    fast_side = leg(mpf(100), 0, 0, V, A, 10 * J)[0]
    study("2 square, stop", "4.800000", 4 * side)
    study("2 square, stop, J 1e5", "4.440000", 4 * fast_side)

    blends, fast = [], []
    printed = {"0.05": ("7.663094", "4.885737"), "0.1": ("12.164404", "4.877730"),
               "1": ("56.462162", "4.568655"), "4": ("100", "4.200000")}
    printed_fast = {"0.05": ("15.795152", "4.413147"), "4": ("100", "4.110000")}
    for text in ("0.05", "0.1", "1", "4"):
        e = exact.exact(float(text))
        blends.append(square(mpf(100), e, V, A, J))
        fast.append(square(mpf(100), e, V, A, 10 * J))
        study(f"3 square e {text} corner speed", printed[text][0], blends[-1]["corner_speed"])
        study(f"3 square e {text} time", printed[text][1], blends[-1]["time"])
        if text in printed_fast:
            study(f"4 square e {text} J 1e5 corner speed", printed_fast[text][0], fast[-1]["corner_speed"])
            study(f"4 square e {text} J 1e5 time", printed_fast[text][1], fast[-1]["time"])
    study("4 square e 0.05 J 1e5 share", "0.3877", fast[0]["share"])

    overlaps = []
    for e, j, times_printed in ((1.0, J, ("0.150283", "4.349152")), (0.05, J, (None, "4.633906")), (1.0, 10 * J, None)):
        tau = overlap_time(sqrt(mpf(2)), exact.exact(e), A, j)
        whole = (4 * side if j == J else 4 * fast_side) - 3 * tau
        overlaps.append({"deviation": e, "jerk": j, "overlap": tau, "time": whole})
        if times_printed:
            if times_printed[0]:
                study(f"5 overlap e {e} tau", times_printed[0], tau)
            study(f"5 overlap e {e} time", times_printed[1], whole)

    r = mpf(50)
    free_arc, free_ramp, free_speed = ideal_circle(r, A)
    whole_free = 2 * free_ramp + (2 * pi * r - 2 * free_arc) / free_speed
    study("6 ramp constant", "2.6220575543", 2 * free_ramp / sqrt(r / A))
    study("6 circle R 50, free", "1.640032", whole_free)
    fed_arc, fed_ramp, fed_speed = ideal_circle(r, A, V)
    whole_fed = 2 * fed_ramp + (2 * pi * r - 2 * fed_arc) / fed_speed
    study("7 ramp arc", "5.033948", fed_arc)
    study("7 ramp time", "0.100407", fed_ramp)
    study("7 circle R 50, feed 100", "3.241727", whole_fed)
    study("8 jerk cap", "292.401774", cbrt(J * r * r))

    reaches = {}
    for v, text in ((0, "21.544347"), (5, "20.445115"), (20, "24.949397")):
        reaches[str(v)] = study(f"9 F({v}; 1)", text, reach(mpf(v), mpf(1), inf, J))

    hermite = make_line_arc()
    h = helix(r, mpf(20))
    study("12 helix curvature", "0.019919270", h["curvature"])
    study("12 helix torsion", "0.001268100", h["torsion"])
    study("12 helix 5 turns", "1573.976207", 5 * h["turn"])
    chord = 2 * r * acos(1 - mpf("0.001") / r) / mpf("0.001")
    study("13 chord cap", "632.456587", chord)
    return {"1_line_200": line, "2_square_stop": 4 * side, "2_square_stop_jerk_1e5": 4 * fast_side,
            "3_square_t_blend": blends, "4_square_t_blend_jerk_1e5": fast, "5_square_overlap": overlaps,
            "6_circle_free": {"ramp_arc": free_arc, "ramp_time": free_ramp, "speed": free_speed, "time": whole_free},
            "7_circle_feed_100": {"ramp_arc": fed_arc, "ramp_time": fed_ramp, "speed": fed_speed, "time": whole_fed},
            "8_arc_jerk_cap": cbrt(J * r * r), "9_reach": reaches, "10_line_arc": hermite,
            "12_helix": {**h, "five_turns": 5 * h["turn"]}, "13_chord_cap": chord}


def make_line_arc():
    """Rows 10 and 11: a line along x, then y: straight, or a circle of radius 50 to the left or to the right."""
    rows = []
    printed = {None: ("3.771236", "4.525483", "0.562500"), 50: ("3.770703", "4.524940", "0.585375"),
               -50: ("3.770698", "4.524934", "0.541158")}
    for radius in (None, 50, -50):
        row = {"radius": radius}
        for name, orders, text in (("quintic", 3, printed[radius][0]), ("septic", 4, printed[radius][1])):
            r = None if radius is None else mpf(radius)
            d = trim_for(mpf(1), X, None, Y, r, orders, mpf(20))
            curve = HermiteBlend(X, None, Y, r, d, orders)
            kappa = greatest(curve.curvature, mpf(0), 2 * d)
            off = greatest(curve.off_path, mpf(0), 2 * d)
            row[name] = {"trim": d, "curvature": float(mp.nstr(kappa, 14)), "off_path": float(mp.nstr(off, 14))}
            study(f"10 line, radius {radius}, {name} trim", text, d)
            if name == "quintic":
                study(f"11 line, radius {radius}, {name} curvature", printed[radius][2], kappa)
        rows.append(row)
    turn = sqrt(mpf(2))
    for row, key in ((rows[0]["quintic"], "quartic"), (rows[0]["septic"], "sextic")):  # T' of 2.1 is r'' of 2.2
        check_equal("line, line: " + key, TBlend(X, Y, POLYNOMIAL_TURNS[key]).length_for(mpf(1)) / 2, row["trim"],
                    mpf(10) ** -30)
    check_equal("quartic", 1 / (turn * mpf(3) / 32) / 2, rows[0]["quintic"]["trim"], mpf(10) ** -30)
    return rows
