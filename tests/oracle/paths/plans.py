# SPDX-License-Identifier: Apache-2.0
"""Exact plans by closed form, and polylines with random blends or averaged by a box.

A plan of lines is a list of phases (duration, jerk of each axis), integrated from rest; the blends are the T-blends
of constant speed, the overlaps are sums of two legs. Circles are sines at constant speed, or two-point Hermite
polynomials of degree 11 for each phase of constant jerk along the arc, computed with 60 digits.
"""
import math

V, A, J = 100.0, 1000.0, 10000.0
SLOWER = "slower than stopping", "slower than stopping, with arcs"
LIMITS = {"velocity": V, "acceleration": A, "jerk": J}


# ----------------------------------------------------------------------------------------------- plans

def curve_json(segments, start=0.0):
    return {"jounce_curve": 1, "axis": "time", "start": start,
            "segments": [{"length": h, "polynomial": c, "sines": sines} for h, c, sines in segments]}


def integrate(phases, start):
    """Curves of the axes from phases of constant jerk; every axis begins at rest."""
    curves = []
    for k, p in enumerate(start):
        v = a = 0.0
        segments = []
        for h, jerks in phases:
            j = jerks[k]
            segments.append((h, [p, v * h, a * h * h / 2, j * h**3 / 6], []))
            p, v, a = p + v * h + a * h * h / 2 + j * h**3 / 6, v + a * h + j * h * h / 2, a + j * h
        curves.append(curve_json(segments))
    return curves


def ramp_phases(change, a=A, j=J):
    """(duration, sign of the jerk) of a ramp that raises the speed by `change`."""
    if change <= a * a / j:
        t = math.sqrt(change / j)
        return [(t, 1), (t, -1)]
    return [(a / j, 1), (change / a - a / j, 0), (a / j, -1)]


def ramp_time(change, a=A, j=J):
    return sum(t for t, _ in ramp_phases(change, a, j))


def leg(length, direction, low, high, v=V, a=A, j=J):
    """Phases along a line, from one speed to another, through the greatest speed that fits."""
    way = lambda peak: ((low + peak) * ramp_time(peak - low, a, j) + (high + peak) * ramp_time(peak - high, a, j)) / 2
    peak = v
    if way(v) > length:
        bottom, peak = max(low, high), v
        for _ in range(200):
            middle = (bottom + peak) / 2
            bottom, peak = (middle, peak) if way(middle) < length else (bottom, middle)
        peak = bottom
    signed = [(t, s) for t, s in ramp_phases(peak - low, a, j)] + [((length - way(peak)) / peak, 0)] + \
             [(t, -s) for t, s in ramp_phases(peak - high, a, j)]
    return [(t, [s * j * u for u in direction]) for t, s in signed if t > 0]


CORNERS = [[100.0, 0.0], [100.0, 100.0], [0.0, 100.0], [0.0, 0.0]]
SIDES = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]


def job(curves, pieces, start, axes=None, **more):
    names = "xyz"[:len(curves)]
    return {"jounce_path_job": 1, "axes": [{"name": n, **(axes or LIMITS)} for n in names], "start": list(start),
            "pieces": pieces, "curves": dict(zip(names, curves)), **more}


def square_pieces(deviation, stop=False):
    return [{"type": "line", "to": c, "line": i + 3, "deviation": deviation, "stop": stop} for i, c in enumerate(CORNERS)]


def square_with_stops():
    phases = [phase for u in SIDES for phase in leg(100.0, u, 0.0, 0.0)]
    return job(integrate(phases, [0.0, 0.0]), square_pieces(0.0, True), [0, 0], path={"velocity": V})


def square_with_blends(e=1.0, share=0.5):
    """Constant speed in T-blends with ramps of `share`: 4.568655 s for e = 1, share 1/2."""
    half = (3 - 6 * share + 4 * share**2) / (24 * (1 - share))
    length = e / (math.sqrt(2) * half)
    v = min(V, math.sqrt(A * (1 - share) * length), (J * share * (1 - share) * length**2) ** (1 / 3))
    phases = []
    for i, u in enumerate(SIDES):
        ends = (0.0 if i == 0 else v), (0.0 if i == 3 else v)
        phases += leg(100.0 - length / (2 if i in (0, 3) else 1), u, *ends)
        if i < 3:
            j = [v**3 * (w - x) / (share * (1 - share) * length**2) for x, w in zip(u, SIDES[i + 1])]
            parts = [(share * length / v, 1), ((1 - 2 * share) * length / v, 0), (share * length / v, -1)]
            phases += [(t, [s * x for x in j]) for t, s in parts if t > 0]
    return job(integrate(phases, [0.0, 0.0]), square_pieces(e), [0, 0], path={"velocity": V})


def square_with_overlaps(tau=0.15028261607100366):
    """Each leg begins tau before the one before ends (4.349152 s, corner distance 1)."""
    one = leg(100.0, [1.0], 0.0, 0.0)
    period = sum(t for t, _ in one) - tau
    curves = []
    for axis in (0, 1):
        events = []  # (time, change of the jerk)
        for i, u in enumerate(SIDES):
            t, before = i * period, 0.0
            for h, (j,) in one + [(0.0, [0.0])]:
                events.append((t, (j - before) * u[axis]))
                t, before = t + h, j
        events.sort()
        phases, j = [], 0.0
        for (t0, d), (t1, _) in zip(events, events[1:] + [(3 * period + sum(t for t, _ in one), 0)]):
            j += d
            if t1 - t0 > 1e-12:
                phases.append((t1 - t0, [j]))
        curves += integrate(phases, [0.0])
    return job(curves, square_pieces(1.0), [0, 0], path={"velocity": V})


def circle_on_the_fly(r=50.0):
    """A line of 100 mm, a full circle at constant speed as sines, a line; the jerk is not limited."""
    run, omega = leg(100.0, [1.0, 0.0], 0.0, V), V / r
    brake = leg(100.0, [1.0, 0.0], V, 0.0)
    before, after = integrate(run, [0.0, 0.0]), [[], []]
    period, turns = 2 * math.pi / omega, 4
    for i in range(turns):
        h = period / turns
        after[0].append((h, [100.0], [[r, omega * h, i * omega * h]]))
        after[1].append((h, [r], [[r, omega * h, i * omega * h - math.pi / 2]]))
    p, v, a, tail = 100.0, V, 0.0, []
    for h, (j, _) in brake:
        tail.append((h, [p, v * h, a * h * h / 2, j * h**3 / 6], []))
        p, v, a = p + v * h + a * h * h / 2 + j * h**3 / 6, v + a * h + j * h * h / 2, a + j * h
    flat = [(h, [0.0], []) for h, _, _ in tail]
    for k, (middle, end) in enumerate(zip(after, (tail, flat))):
        before[k]["segments"] += [{"length": h, "polynomial": c, "sines": s} for h, c, s in middle + end]
    pieces = [{"type": "line", "to": [100.0, 0.0], "line": 1},
              {"type": "arc", "to": [100.0, 0.0], "center": [100.0, r], "line": 2, "stop": False},
              {"type": "line", "to": [200.0, 0.0], "line": 3}]
    limits = {"velocity": V, "acceleration": A}
    return job(before, pieces, [0, 0], limits, path={"velocity": V, "normal_acceleration": V * V / r})


def circle_from_rest(r=50.0, v=80.0, a=600.0, j=5000.0, climb=0.0):
    """A full circle from rest to rest; every phase of the law as polynomials of degree 11."""
    from exact import hermite
    from mpmath import mp, mpf, pi
    from mpmath import sqrt as root
    speed, pull = mpf(v), mpf(a)
    up = [pull / j, speed / pull - pull / j, pull / j]
    way = speed * sum(up)  # both ramps
    jerks = [j, 0, -j, 0, -j, 0, j]
    whole = root((2 * pi * r) ** 2 + mpf(climb) ** 2)
    durations = [*up, (whole - way) / speed, *reversed(up)]
    curves, law = [[], [], []], []
    q = [mpf(0)] * 3
    for h, jerk in zip(durations, jerks):
        if h == 0:
            continue
        parts = max(1, int(mp.ceil(q[1] * h / r / mpf("0.8"))), int(mp.ceil(h / mpf("0.1"))))
        for i in range(parts):
            t = h / parts
            end = [q[0] + q[1] * t + q[2] * t**2 / 2 + jerk * t**3 / 6, q[1] + q[2] * t + jerk * t**2 / 2, q[2] + jerk * t]
            ends = []
            for state in (q, end):
                s = [state[0], state[1], state[2] / 2, mpf(jerk) / 6, mpf(0), mpf(0)]  # Taylor series of the law
                angle = [x * 2 * pi / whole for x in s]
                c, d = series_of_circle(angle)
                z = [x * mpf(climb) / whole for x in s]
                ends.append([[r * x * mp.factorial(k) for k, x in enumerate(row)] for row in (c, d)] +
                            [[x * mp.factorial(k) for k, x in enumerate(z)]])
            for axis in range(3):
                f = hermite(t, ends[0][axis], ends[1][axis])
                curves[axis].append((float(t), [float(x * t**k) for k, x in enumerate(f.poly)], []))
            law.append((float(t), [float(q[0]), float(q[1] * t), float(q[2] * t * t / 2), float(jerk * t**3 / 6)], []))
            q = end
    axes = 3 if climb else 2
    to = [r, 0.0, climb][:axes]
    pieces = [{"type": "arc", "to": to, "center": [0.0, 0.0], "line": 1, "stop": True}]
    limits = {"velocity": v, "acceleration": math.hypot(a, v * v / r), "jerk": j + 3 * v * a / r + v**3 / r**2}
    return job([curve_json(c) for c in curves[:axes]], pieces, [r, 0.0, 0.0][:axes], limits, path={"velocity": v}, tolerance=1e-9,
               law={"velocity": v, "acceleration": a, "jerk": j}) | {"law_curve": curve_json(law)}


def series_of_circle(angle):
    """Taylor coefficients of cos and sin of a power series."""
    from mpmath import cos, mpf, sin
    n = len(angle)
    c, s = [cos(angle[0])], [sin(angle[0])]
    for k in range(1, n):
        c.append(-sum(i * angle[i] * s[k - i] for i in range(1, k + 1)) / mpf(k))
        s.append(sum(i * angle[i] * c[k - i] for i in range(1, k + 1)) / mpf(k))
    return c, s


def with_law(document):
    law = document.pop("law_curve")
    document["curves"]["law"] = law
    return document


# ---------------------------------------------------------------------------------------- random plans

def blended(points, deviations, limits, share, start_line=3):
    """T-blends at one constant corner speed, the greatest that all corners and both ends allow."""
    axes = len(points[0])
    directions, lengths = [], []
    for p, q in zip(points, points[1:]):
        lengths.append(math.dist(p, q))
        directions.append([(y - x) / lengths[-1] for x, y in zip(p, q)])
    half = (3 - 6 * share + 4 * share**2) / (24 * (1 - share))
    turns = [[w - u for u, w in zip(a, b)] for a, b in zip(directions, directions[1:])]
    blends = [e / (math.hypot(*t) * half) for e, t in zip(deviations, turns)]
    rest = [l - (a + b) / 2 for l, a, b in zip(lengths, [0.0, *blends], [*blends, 0.0])]
    if min(rest) < 0:
        return None
    along = [{key: min(x[key] / abs(c) for x, c in zip(limits, u) if c) for key in LIMITS} for u in directions]
    speed = min(a["velocity"] for a in along)
    for length, turn in zip(blends, turns):
        for x, t in zip(limits, turn):
            if t:
                speed = min(speed, math.sqrt(x["acceleration"] * (1 - share) * length / abs(t)),
                            (x["jerk"] * share * (1 - share) * length**2 / abs(t)) ** (1 / 3))
    for a, length in ((along[0], rest[0]), (along[-1], rest[-1])):
        while speed * ramp_time(speed, a["acceleration"], a["jerk"]) / 2 > length:
            speed *= 0.9
    phases = []
    for k, (u, a, length) in enumerate(zip(directions, along, rest)):
        low, high = (0.0 if k == 0 else speed), (0.0 if k + 1 == len(rest) else speed)
        phases += leg(length, u, low, high, a["velocity"], a["acceleration"], a["jerk"])
        if k < len(turns):
            j = [speed**3 * t / (share * (1 - share) * blends[k] ** 2) for t in turns[k]]
            parts = [(share * blends[k] / speed, 1), ((1 - 2 * share) * blends[k] / speed, 0), (share * blends[k] / speed, -1)]
            phases += [(t, [s * x for x in j]) for t, s in parts if t > 0]
    pieces = [{"type": "line", "to": p, "line": i + start_line, "deviation": e}
              for i, (p, e) in enumerate(zip(points[1:], [*deviations, 0.0]))]
    document = job(integrate(phases, points[0]), pieces, points[0], tolerance=1e-12 * sum(lengths))
    document["axes"] = [{"name": n, **x} for n, x in zip("xyz"[:axes], limits)]
    return document


def stopping(document):
    """The plan with rest at the end of every line of a job; None if the job has arcs or no length."""
    at, curves = document["start"], [[] for _ in document["axes"]]
    for piece in document["pieces"]:
        if piece["type"] != "line":
            return None
        length = math.dist(at, piece["to"])
        if length:
            u = [(y - x) / length for x, y in zip(at, piece["to"])]
            least = lambda *keys: min(axis[k] / abs(c) for axis, c in zip(document["axes"], u) if c for k in keys if k in axis)
            v = min(least("velocity"), piece.get("feed", math.inf), document["path"]["velocity"])
            phases = leg(length, u, 0.0, 0.0, v, least("acceleration", "deceleration"), least("jerk"))
            for axis, curve in zip(curves, integrate(phases, at)):
                axis += curve["segments"]
        at = piece["to"]
    if not curves[0]:
        return None
    named = {axis["name"]: {"jounce_curve": 1, "axis": "time", "start": 0.0, "segments": c} for axis, c in zip(document["axes"], curves)}
    return {**document, "curves": named}


def random_blended(rng):
    """A polyline of 2 to 8 random legs in two or three axes with limits of their own, up to its sharpest corners."""
    while True:
        axes = rng.choice((2, 3))
        points = [[round(rng.uniform(-50, 50), 3) for _ in range(axes)] for _ in range(rng.randrange(3, 10))]
        limits = [{"velocity": rng.uniform(50, 200), "acceleration": rng.uniform(300, 3000), "jerk": rng.uniform(3000, 50000)}
                  for _ in range(axes)]
        deviations = [10 ** rng.uniform(-4, 0) for _ in points[2:]]
        document = blended(points, deviations, limits, rng.choice((0.5, 0.25, 0.1)))
        if document:
            return document


def averaged(points, window, start_line=3):
    """The polyline averaged over a window of its length by a box, ends mirrored, and a law from rest to rest.

    r(q) is the mean of the polyline over [q - w/2, q + w/2]: pieces of degree 2 in q, degree 6 in time.
    """
    axes, lengths = len(points[0]), [math.dist(p, q) for p, q in zip(points, points[1:])]
    mirrored = lambda end, others: [[2 * e - x for e, x in zip(end, p)] for p in others]
    whole = mirrored(points[0], points[:0:-1]) + points + mirrored(points[-1], points[-2::-1])
    at = [0.0]
    for p, q in zip(whole, whole[1:]):
        at.append(at[-1] + math.dist(p, q))
    total = sum(lengths)
    at = [s - total for s in at]  # 0 at the first point
    moment = [[0.0] * axes]  # integral of the polyline up to each knot
    for p, q, a, b in zip(whole, whole[1:], at, at[1:]):
        moment.append([m + (x + y) / 2 * (b - a) for m, x, y in zip(moment[-1], p, q)])

    def piece_of(s):
        low, high = 0, len(at) - 2
        while low < high:
            middle = (low + high + 1) // 2
            low, high = (middle, high) if at[middle] <= s else (low, middle - 1)
        return low

    def integral(q, direction_from, axis):
        """Power series in (x - q) of the integral of the polyline up to x near q."""
        k = direction_from
        slope = (whole[k + 1][axis] - whole[k][axis]) / (at[k + 1] - at[k])
        d = q - at[k]
        return [moment[k][axis] + whole[k][axis] * d + slope * d * d / 2, whole[k][axis] + slope * d, slope / 2]

    half = window / 2
    cuts = sorted({0.0, total} | {s + d for s in at for d in (-half, half) if 0 < s + d < total})
    law, q = [], [0.0, 0.0, 0.0]
    for h, (j,) in leg(total, [1.0], 0.0, 0.0):
        law.append((h, list(q), j))
        q = [q[0] + q[1] * h + q[2] * h * h / 2 + j * h**3 / 6, q[1] + q[2] * h + j * h * h / 2, q[2] + j * h]
    curves = [[] for _ in range(axes)]
    for h, (q0, v, a), j in law:
        place = lambda t: q0 + v * t + a * t * t / 2 + j * t**3 / 6
        times = [0.0]
        for c in cuts:
            if place(0.0) < c < place(h):
                low, high = 0.0, h
                for _ in range(80):
                    middle = (low + high) / 2
                    low, high = (middle, high) if place(middle) < c else (low, middle)
                times.append(low)
        times.append(h)
        for t0, t1 in zip(times, times[1:]):
            d = t1 - t0
            if d <= 1e-12:
                continue
            start, middle = place(t0), place((t0 + t1) / 2)
            rates = [v + a * t0 + j * t0 * t0 / 2, a + j * t0]
            way = [0.0, rates[0] * d, rates[1] * d * d / 2, j * d**3 / 6]  # q - start in s
            square = [0.0] * 7
            for i, x in enumerate(way):
                for k, y in enumerate(way):
                    square[i + k] += x * y
            for axis in range(axes):
                top = integral(start + half, piece_of(middle + half), axis)
                bottom = integral(start - half, piece_of(middle - half), axis)
                c = [(x - y) / window for x, y in zip(top, bottom)]
                out = [c[2] * x for x in square]
                for i, x in enumerate(way):
                    out[i] += c[1] * x
                out[0] += c[0]
                curves[axis].append((d, out, []))
    pieces = [{"type": "line", "to": list(p), "line": i + start_line, "deviation": 0.0} for i, p in enumerate(points[1:])]
    document = job([curve_json(c) for c in curves], pieces, points[0], tolerance=1e-10 * total)
    document["axes"] = [{"name": n} for n in "xyz"[:axes]]
    return document
