# SPDX-License-Identifier: Apache-2.0
"""Worked examples of controller manuals, recomputed.

PMC600 manual, volume 4, 6.2, Fig. 6.14: a cam of four quintic segments with printed extrema; and the same cam
    behind a trapezoidal master (example "4.3"), which exercises the whole chain rule.
Googol iDEABOX manual, example 7-1: a trapezoid and its variant with 25 ms of smoothing (linear acceleration ramps).
HIWIN HIMC HMPL manual, 5.2.8: a PVT table, read as cubic Hermite, with its overshoot.
"""
from mpmath import mp, mpf

from exact import ZERO, Piece, Piecewise, check_equal, check_printed, digits_agree, exact, hermite

# ------------------------------------------------------------------------------------- PMC600, Fig. 6.14

CAM = {"x": [0.0, 75.0, 200.0, 280.0, 360.0], "y": [0.0, 100.0, 225.0, 100.0, 0.0],
       "v": [0.0, 1.0, 1.0, 0.01739120485, 0.0], "a": [0.0, 0.0, 0.0, 0.0, 0.0]}
CAM_PRINTED = [
    {"min_position": "0", "max_position": "100", "max_abs_v": "2.107392000", "max_abs_a": "0.0779244639"},
    {"min_position": "100", "max_position": "225", "max_abs_v": "1", "max_abs_a": "0"},
    {"min_position": "99.9838833331", "max_position": "232.361666", "max_abs_v": "3.392270802",
     "max_abs_a": "0.1619234501"},
    {"min_position": "0", "max_position": "100.020222", "max_abs_v": "2.351367663", "max_abs_a": "0.0910560073"},
]


def cam(v280=None):
    x, y, v, a = ([exact(value) for value in CAM[key]] for key in "xyva")
    if v280 is not None:
        v[3] = v280
    return Piecewise([hermite(x[i + 1] - x[i], (y[i], v[i], a[i]), (y[i + 1], v[i + 1], a[i + 1]))
                      for i in range(4)], x[0])


def cam_segment(curve, i):
    part = Piecewise([curve.pieces[i]], curve.knots[i])
    low, high = part.minimum(), part.maximum()
    speed, bend, jerk = (part.derivative(k).peak() for k in (1, 2, 3))
    return {"min_position": low[1], "x_of_min_position": low[0],
            "max_position": high[1], "x_of_max_position": high[0],
            "max_abs_v": speed[1], "x_of_max_abs_v": speed[0],
            "max_abs_a": bend[1], "x_of_max_abs_a": bend[0],
            "max_abs_j": jerk[1], "x_of_max_abs_j": jerk[0],
            "j_start": part.derivative(3)(part.knots[0]), "j_end": part.derivative(3)(part.knots[1]),
            "polynomial_in_local_x": list(curve.pieces[i].poly)}


def v280_range():
    """The slopes at master 280 for which every printed digit of both neighbours is right, rounded or cut off."""
    def fits(v):
        curve = cam(v)
        return all(digits_agree(CAM_PRINTED[i][key], cam_segment(curve, i)[key])
                   for i in (2, 3) for key in CAM_PRINTED[i])

    def edge(good, bad):
        for _ in range(36):
            middle = (good + bad) / 2
            good, bad = (middle, bad) if fits(middle) else (good, middle)
        return good

    middle = exact(CAM["v"][3])
    return [edge(middle, middle - mpf("1e-8")), edge(middle, middle + mpf("1e-8"))]


def make_cam():
    curve = cam()
    segments = []
    for i in range(4):
        values = cam_segment(curve, i)
        relation = {key: check_printed(f"Fig. 6.14 segment {i + 1} {key}", text, values[key], allow_truncated=True)
                    for key, text in CAM_PRINTED[i].items()}
        segments.append(dict(values, printed=CAM_PRINTED[i], printed_is=relation))
    check_equal("Fig. 6.14 segment 1 peak slope", segments[0]["max_abs_v"], mpf("2.107392"))
    check_equal("Fig. 6.14 segment 1 peak slope at", segments[0]["x_of_max_abs_v"], mpf(42))
    return {"knots": CAM, "segments": segments, "v280_printed": "0.01739",
            "v280_printed_is": check_printed("Fig. 6.14 V at 280", "0.01739", exact(CAM["v"][3]), True),
            "v280_that_fits_all_digits": dict(zip(("from", "to"), v280_range()))}


# ------------------------------------------------------------------------------------- chain rule on the cam

def master():
    """0 -> 1080 pulse with 200 pulse/s and 1000 pulse/s^2."""
    acceleration = [Piece(mpf(1) / 5, (mpf(1000),)), Piece(mpf(26) / 5, (ZERO,)), Piece(mpf(1) / 5, (mpf(-1000),))]
    return Piecewise(acceleration).integral().integral()


def follow(curve, m, t, left=False):
    """Slave position, velocity, acceleration, jerk at t, one-sided; the cam repeats every 360."""
    x, v, a, j = (m.derivative(k)(t, left) for k in range(4))
    for knot in curve.knots:  # a break is not exact in binary: on a knot means on the knot, not just beside it
        laps = mp.nint((x - knot) / 360)
        if abs(x - knot - 360 * laps) < mpf("1e-40"):
            x = knot + 360 * laps
    phase = x - 360 * mp.floor(x / 360)
    if phase == 0 and (left and x > 0 or t == m.knots[-1]):
        phase = mpf(360)
    f, f1, f2, f3 = (curve.derivative(k)(phase, left) for k in range(4))
    return {"master": x, "position": f, "velocity": f1 * v, "acceleration": f2 * v**2 + f1 * a,
            "jerk": f3 * v**3 + 3 * f2 * v * a + f1 * j}


def make_chain_rule():
    curve, m = cam(), master()
    at_knots = {}
    for lap in range(3):
        for x in curve.knots[:-1] + ([curve.knots[-1]] if lap == 2 else []):
            target = 360 * lap + x
            if 20 <= target <= 1060:
                at_knots[mpf(1) / 5 + (target - 20) / 200] = True
    breaks = sorted(set(at_knots) | set(m.knots))
    # 60 times away from the breaks (at least 1 us), the first at the very start
    times = [0.0] + [float(exact(5.6) * (k + mpf("0.37") * mp.sin(7 * k)) / 60) for k in range(1, 60)]
    assert all(abs(exact(t) - b) > 1e-6 for t in times[1:] for b in breaks)
    rows = [follow(curve, m, exact(t)) for t in times]
    both = [{"t": b, "left": follow(curve, m, b, True) if b > 0 else None,
             "right": follow(curve, m, b) if b < m.knots[-1] else None} for b in breaks]
    for row in both:  # position, velocity and acceleration at the joins of the cam itself are continuous
        if row["left"] and row["right"] and row["t"] not in m.knots:
            for key in ("position", "velocity", "acceleration"):
                wrapped = key == "position" and abs(row["left"][key] - row["right"][key]) > 200
                if not wrapped:
                    check_equal(f"chain rule: {key} at {mp.nstr(row['t'], 6)}", row["left"][key], row["right"][key])
    return {"master": {"from": 0.0, "to": 1080.0, "velocity": 200.0, "acceleration": 1000.0,
                       "knots": list(m.knots)},
            "t": times, "breaks": both,
            **{key: [row[key] for row in rows] for key in rows[0]}}


# --------------------------------------------------------------------------------------------- Googol 7-1

def phases_to_profile(phases):
    """Acceleration pieces (duration, value, slope) -> position over time."""
    return Piecewise([Piece(mpf(t), (mpf(a), mpf(j))) for t, a, j in phases]).integral().integral()


def ramp(speed, peak, smoothing):
    """0 -> speed with a linear rise and fall of the acceleration over `smoothing`."""
    speed, peak, s = mpf(speed), mpf(peak), mpf(smoothing)
    flat = speed / peak - s
    assert flat >= 0
    j = peak / s if s else ZERO
    return [p for p in ((s, ZERO, j), (flat, peak, ZERO), (s, peak, -j)) if p[0] > 0]


def googol(smoothing):
    up = ramp(50, "0.25", smoothing)
    down = [(t, -a, -j) for t, a, j in ramp(50, "0.125", smoothing)]

    def distance(phases, start):
        curve = Piecewise([Piece(t, (a, j)) for t, a, j in phases]).integral(mpf(start)).integral()
        return curve(curve.knots[-1])

    d_up, d_down = distance(up, 0), distance(down, 50)
    cruise = (50000 - d_up - d_down) / 50
    curve = phases_to_profile(up + [(cruise, ZERO, ZERO)] + down)
    check_equal("Googol 7-1 end", curve(curve.knots[-1]), mpf(50000))
    v, a, j = (curve.derivative(k) for k in (1, 2, 3))
    total = curve.knots[-1]
    fixed = {float(k) for k in curve.knots}
    n = 50 - len(fixed)
    inner = {float(total * (k + mpf("0.31") * mp.sin(5 * k)) / (n + 1)) for k in range(1, n + 1)}
    times = sorted(fixed | inner)
    assert len(times) == 50
    at = [exact(t) for t in times]
    accel_time, decel_time = sum((p[0] for p in up), ZERO), sum((p[0] for p in down), ZERO)
    return {"accel_time": accel_time, "cruise_time": cruise, "decel_time": decel_time, "total_time": total,
            "accel_distance": d_up, "cruise_distance": 50 * cruise, "decel_distance": d_down,
            "accel_jerk": up[0][2] if smoothing else None, "decel_jerk": -down[0][2] if smoothing else None,
            "phase_ends": list(curve.knots[1:]),
            "position_at_phase_ends": [curve(k) for k in curve.knots[1:]], "t": times,
            "position": [curve(t) for t in at], "velocity": [v(t) for t in at],
            "acceleration": [a(t) for t in at], "jerk": [j(t) for t in at]}


def make_googol():
    plain, smooth = googol(0), googol(25)
    for text, value in (("200", plain["accel_time"]), ("700", plain["cruise_time"]), ("400", plain["decel_time"]),
                        ("1300", plain["total_time"]), ("225", smooth["accel_time"]),
                        ("675", smooth["cruise_time"]), ("425", smooth["decel_time"]),
                        ("1325", smooth["total_time"]), ("5625", smooth["accel_distance"]),
                        ("10625", smooth["decel_distance"])):
        check_equal(f"Googol 7-1: {text}", value, mpf(text))
    return {"from": 0.0, "to": 50000.0, "velocity": 50.0, "acceleration": 0.25, "deceleration": 0.125,
            "smooth_time": 25.0, "units": "pulse, ms", "trapezoid": plain, "smoothed": smooth}


# --------------------------------------------------------------------------------------------- HMPL 5.2.8

PVT = {"t": [0.0, 2000.0, 3000.0, 4000.0, 6000.0, 11000.0],
       "p": [0.0, 153.333, 42.123, 161.21, 177.0, 83.333],
       "v": [0.0, 1000.0, 800.0, 1660.0, 450.0, 0.0]}


def outside(curve, low, high):
    """Open intervals in which the position leaves [low, high], with the side and the worst excursion."""
    found = []
    for bound, sign, side in ((low, -1, "below"), (high, 1, "above")):
        cuts = {curve.knots[0], curve.knots[-1]}
        for knot, piece in zip(curve.knots, curve.pieces):
            shifted = Piece(piece.length, (piece.poly[0] - bound,) + piece.poly[1:])
            cuts |= {knot + u for u in shifted.zeros()}
        cuts = sorted(cuts)
        for a, b in zip(cuts, cuts[1:]):
            if b > a and sign * (curve((a + b) / 2) - bound) > 0:
                inside = [c for c in curve.candidates() if a < c[0] < b]
                worst = max(inside, key=lambda c: sign * c[1])
                found.append({"side": side, "from": a, "to": b, "t_of_worst": worst[0], "worst": worst[1]})
    return sorted(found, key=lambda entry: entry["from"])


def make_pvt():
    """Times in ms, positions in mm, velocities in mm/s, accelerations in mm/s^2."""
    t, p, v = ([exact(value) for value in PVT[key]] for key in "tpv")
    pieces = [hermite(t[i + 1] - t[i], (p[i], v[i] / 1000), (p[i + 1], v[i + 1] / 1000)) for i in range(5)]
    curve = Piecewise(pieces)
    segments = []
    for i in range(5):
        part = Piecewise([pieces[i]], t[i])
        low, high = part.minimum(), part.maximum()
        speed, bend = part.derivative(1).peak(), part.derivative(2).peak()
        middle = (t[i] + t[i + 1]) / 2
        segments.append({
            "min_position": low[1], "t_of_min": low[0], "max_position": high[1], "t_of_max": high[0],
            "peak_velocity": 1000 * speed[1], "t_of_peak_velocity": speed[0],
            "peak_acceleration": 10**6 * bend[1], "t_of_peak_acceleration": bend[0],
            "midpoint_position": part(middle), "midpoint_velocity": 1000 * part.derivative(1)(middle),
            "acceleration_at_start": 10**6 * part.derivative(2)(t[i]),
            "acceleration_at_end": 10**6 * part.derivative(2)(t[i + 1])})
    check_printed("HMPL 5.2.8 midpoint position", "-173.3335", segments[0]["midpoint_position"])
    check_printed("HMPL 5.2.8 midpoint velocity", "-135", segments[0]["midpoint_velocity"])
    check_printed("HMPL 5.2.8 lowest position", "-188.7", min(s["min_position"] for s in segments))
    check_printed("HMPL 5.2.8 highest position", "596.1", max(s["max_position"] for s in segments))
    check_printed("HMPL 5.2.8 peak acceleration", "7525.5", max(s["peak_acceleration"] for s in segments))
    return {"table": PVT, "units": "ms, mm, mm/s, mm/s^2", "segments": segments,
            "bounds": {"low": 0.0, "high": 200.0}, "outside_bounds": outside(curve, ZERO, mpf(200))}
