# SPDX-License-Identifier: Apache-2.0
"""Rest-to-rest moves: seven-segment S-curves and trapezoids, asymmetric.

S-curve: while speeding up |a| <= acceleration and |da/dt| <= jerk, while slowing down |a| <= deceleration and
|da/dt| <= deceleration jerk. In the plane (v, a) the ramp 0 -> peak that takes a(v) as large as the limits allow
is fastest and shortest at once, so the least duration follows from the peak velocity alone:

    T(v; A, J) = v/A + A/J  if v >= A^2/J (plateau),  2 sqrt(v/J) otherwise;    distance = v T / 2

The peak velocity is the limit, with a cruise, or the root of accel + decel distance = length, found by bisection
(no closed form of the seven cases is used here). Trapezoids are the same with T = v/A.
"""
from mpmath import mp, mpf

from exact import ZERO, Piece, Piecewise, bisect, check_equal, exact

SHAPES = {  # velocity, acceleration, deceleration, jerk, deceleration jerk, distance
    "full": (120, 800, 500, 9000, 4000, 75),
    "no cruise": (900, 800, 500, 9000, 4000, 600),
    "no accel plateau": (30, 900, 120, 8000, 5000, 25),
    "no decel plateau": (30, 120, 900, 5000, 8000, 25),
    "no plateaus": (2.5, 800, 500, 9000, 4000, 1.25),
    "no accel plateau, no cruise": (500, 900, 120, 8000, 5000, 12),
    "no decel plateau, no cruise": (500, 120, 900, 5000, 8000, 12),
    "four segments": (500, 800, 500, 9000, 4000, 0.7),
}
PRESENT = {  # accel plateau, cruise, decel plateau
    "full": [1, 1, 1], "no cruise": [1, 0, 1], "no accel plateau": [0, 1, 1], "no decel plateau": [1, 1, 0],
    "no plateaus": [0, 1, 0], "no accel plateau, no cruise": [0, 0, 1], "no decel plateau, no cruise": [1, 0, 0],
    "four segments": [0, 0, 0],
}
VARIANTS = (  # name, from, direction, factor on length, factor on time
    ("forward", 0, 1, 1.0, 1.0),
    ("backward", 17.5, -1, 1.0, 1.0),
    ("length x 1e-6", 0, 1, 1e-6, 1.0),
    ("length x 1e6, time x 1e3", -3, -1, 1e6, 1e3),
)


def ramp_time(v, a, j):
    return v / a + a / j if v * j >= a * a else 2 * mp.sqrt(v / j)


def ramp_distance(v, a, j):
    return v * ramp_time(v, a, j) / 2


def ramp_phases(v, a, j):
    """Durations of rising, constant and falling acceleration."""
    plateau = v * j >= a * a
    edge = a / j if plateau else mp.sqrt(v / j)
    return [edge, v / a - a / j if plateau else ZERO, edge]


def peak_velocity(v, distance, limit):
    """The largest speed up to `limit` whose two ramps fit into the distance."""
    if distance(limit) <= v:
        return limit
    low = limit
    while distance(low) > v:
        low /= 2
    return bisect(lambda x: distance(x) - v, low, 2 * low)


def s_curve(case):
    start, end, v_max, a, d, ja, jd = (exact(case[k]) for k in (
        "from", "to", "velocity", "acceleration", "deceleration", "jerk", "deceleration_jerk"))
    length = abs(end - start)
    v = peak_velocity(length, lambda x: ramp_distance(x, a, ja) + ramp_distance(x, d, jd), v_max)
    cruise = (length - ramp_distance(v, a, ja) - ramp_distance(v, d, jd)) / v
    if abs(cruise) < mpf(10) ** -45 * length / v:
        cruise = ZERO
    phases = ramp_phases(v, a, ja) + [cruise] + ramp_phases(v, d, jd)
    check_by_integration(case["name"], phases, ja, jd, v, length)
    return dict(case, distance=length, duration=sum(phases, ZERO), peak_velocity=v,
                peak_acceleration=phases[0] * ja, peak_deceleration=phases[6] * jd, phases=phases)


def check_by_integration(name, phases, ja, jd, v, length):
    jerks = (ja, ZERO, -ja, ZERO, -jd, ZERO, jd)
    curve = Piecewise([Piece(t, (j,)) for t, j in zip(phases, jerks)]).integral().integral().integral()
    end = curve.pieces[-1].length
    last = curve.pieces[-1]
    velocity, acceleration = last.derivative()(end), last.derivative().derivative()(end)
    check_equal(f"{name}: reaches its end", last(end) / length, mpf(1), mpf(10) ** -40)
    check_equal(f"{name}: at rest", velocity / v, ZERO, mpf(10) ** -40)
    check_equal(f"{name}: without acceleration", acceleration / (phases[0] * ja), ZERO, mpf(10) ** -40)


def case(name, start, direction, length, v, a, d, ja, jd):
    start = float(start)
    return {"name": name, "from": start, "to": start + direction * float(length), "velocity": float(v),
            "acceleration": float(a), "deceleration": float(d), "jerk": float(ja), "deceleration_jerk": float(jd)}


def s_curve_cases():
    for shape, (v, a, d, ja, jd, length) in SHAPES.items():
        for variant, start, direction, s, t in VARIANTS:
            entry = case(f"{shape}, {variant}", start, direction, length * s, v * s / t, a * s / t**2, d * s / t**2,
                         ja * s / t**3, jd * s / t**3)
            yield dict(entry, shape=shape)
    for label, v, a, d, ja, jd in (("plateaus", 120, 800, 500, 9000, 4000),
                                   ("no plateaus", 2.5, 800, 500, 9000, 4000),
                                   ("steep", 300, 2000, 9000, 4e6, 1e5)):
        ramps = ramp_distance(exact(v), exact(a), exact(ja)) + ramp_distance(exact(v), exact(d), exact(jd))
        for part in (1e-2, 1e-4, 1e-6, 1e-9):
            yield case(f"short, {label}, {part:.0e} of the ramp distance", 0, 1, float(ramps) * part, v, a, d, ja, jd)
    # limits that are met exactly (every number here is a dyadic rational)
    yield case("exactly no cruise", 0, 1, 24, 16, 16, 16, 32, 32)
    yield case("exactly no cruise, asymmetric", 0, -1, 32, 16, 16, 8, 32, 16)
    yield case("plateau of length zero", 0, 1, 48, 16, 16, 16, 16, 16)
    yield case("plateau of length zero, no cruise", 0, 1, 32, 32, 16, 16, 16, 16)
    yield case("only the decel plateau has length zero", 0, 1, 64, 16, 8, 16, 16, 16)
    # strong asymmetry
    yield case("acceleration / deceleration 1e4", 0, 1, 50, 200, 1e5, 10, 1e7, 1e4)
    yield case("deceleration / acceleration 1e4", 0, -1, 50, 200, 10, 1e5, 1e4, 1e7)
    yield case("jerk / deceleration jerk 1e6", 0, 1, 3, 40, 500, 500, 1e8, 100)
    yield case("deceleration jerk / jerk 1e6", 0, 1, 3, 40, 500, 500, 100, 1e8)
    yield case("nearly a trapezoid", 0, 1, 1000, 100, 500, 250, 1e12, 1e12)
    yield case("long cruise", 0, 1, 1e9, 1.5, 3, 2, 40, 30)
    yield case("jerk decides everything", 0, 1, 1000, 1e6, 1e6, 1e6, 0.25, 4)
    yield case("distance of a count", 0, 1, 1, 50, 0.25, 0.125, 0.01, 0.005)
    yield case("slow limit, stiff jerk", -100, 1, 200, 1e-3, 10, 7, 1e4, 3e3)
    yield case("thirds", 0, 1, 1 / 3, 1 / 7, 2 / 3, 3 / 7, 11 / 3, 13 / 9)
    yield case("small offsets on a large start", 1048576, 1, 0.125, 3, 40, 25, 1500, 900)


def trapezoid(entry):
    start, end, v_max, a, d = (exact(entry[k]) for k in ("from", "to", "velocity", "acceleration", "deceleration"))
    length = abs(end - start)
    v = peak_velocity(length, lambda x: x * x / (2 * a) + x * x / (2 * d), v_max)
    cruise = (length - v * v / (2 * a) - v * v / (2 * d)) / v
    if abs(cruise) < mpf(10) ** -45 * length / v:
        cruise = ZERO
    closed = min(v_max, mp.sqrt(2 * length * a * d / (a + d)))
    check_equal(f"trapezoid {entry['name']}: closed form", v / closed, mpf(1))
    return dict(entry, distance=length, duration=v / a + cruise + v / d, peak_velocity=v,
                phases=[v / a, cruise, v / d])


def trapezoid_cases():
    def make(name, start, direction, length, v, a, d):
        full = case(name, start, direction, length, v, a, d, 1, 1)
        return {k: full[k] for k in full if "jerk" not in k}

    shapes = {"with cruise": (75, 120, 800, 500), "triangle": (20, 240, 800, 500), "steep stop": (75, 120, 100, 9000),
              "steep start": (75, 120, 9000, 100), "slow": (75, 0.5, 2, 3)}
    for shape, (length, v, a, d) in shapes.items():
        for variant, start, direction, s, t in VARIANTS:
            yield make(f"{shape}, {variant}", start, direction, length * s, v * s / t, a * s / t**2, d * s / t**2)
    for part in (1e-2, 1e-4, 1e-6, 1e-9):
        ramps = exact(120) ** 2 / 2 * (1 / exact(800) + 1 / exact(500))
        yield make(f"short, {part:.0e} of the ramp distance", 0, 1, float(ramps) * part, 120, 800, 500)
    yield make("exactly a triangle", 0, 1, 16, 16, 16, 16)
    yield make("exactly a triangle, asymmetric", 8, -1, 24, 16, 16, 8)
    yield make("Googol iDEABOX manual ex. 7-1, unsmoothed", 0, 1, 50000, 50, 0.25, 0.125)
    yield make("PMC600 manual 6.3 ex. 6.7, master", 0, 1, 4000, 2000, 4000, 4000)
    yield make("acceleration / deceleration 1e6", 0, 1, 50, 200, 1e6, 1)
    yield make("small offset on a large start", 1048576, -1, 0.125, 3, 40, 25)


def make_s_curves():
    cases = [s_curve(entry) for entry in s_curve_cases()]
    assert len(cases) == 60, len(cases)
    for entry in cases[:len(SHAPES) * len(VARIANTS)]:  # the names are right
        present = [int(entry["phases"][i] > 0) for i in (1, 3, 5)]
        assert present == PRESENT[entry.pop("shape")], entry["name"]
    return cases


def make_trapezoids():
    cases = [trapezoid(entry) for entry in trapezoid_cases()]
    assert len(cases) == 30, len(cases)
    return cases
