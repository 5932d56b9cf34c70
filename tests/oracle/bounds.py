# SPDX-License-Identifier: Apache-2.0
"""Bounds that no motion law can beat, and the least effort between given end states.

rest_to_rest: peak of the n-th derivative (perfect spline), integrals of squared derivatives, peak of f' f'', the
    front of acceleration against jerk.
peak_acceleration: least peak |a| from v0 to v1 over a displacement in a given time, optionally with |v| <= limit:
    bisection on the peak, with the exact range of displacements that bang-coast-bang can reach.
square_acceleration: least integral of a^2 for the same data without a velocity limit.
peak_jerk: least peak |jerk| with position, velocity and acceleration given at both ends. The optimum is +-J with
    at most two switches (perfect spline); the moment equations reduce to a quartic, and since the jerk's sign is
    the sign of a quadratic, duality proves it optimal.
"""
from math import comb

from mpmath import mp, mpf

from exact import ZERO, Piece, Piecewise, bisect, check_equal, check_printed, exact, hermite

# ------------------------------------------------------------------------------------------- rest to rest


def perfect_spline_peak(n):
    """max |f^(n)| of the perfect spline with knots (1 - cos(k pi / n)) / 2, by integrating +-1 n times."""
    knots = [(1 - mp.cos(k * mp.pi / n)) / 2 for k in range(n + 1)]
    curve = Piecewise([Piece(b - a, (mpf((-1) ** k),)) for k, (a, b) in enumerate(zip(knots, knots[1:]))])
    for order in range(n):
        curve = curve.integral()
        end = curve.pieces[-1](curve.pieces[-1].length)
        if order < n - 1:
            check_equal(f"perfect spline {n}: derivative {n - 1 - order} vanishes", end, ZERO)
    return 1 / abs(end), knots


def square_integral(n):
    """Integral of (f^(n))^2 of the optimal polynomial: degree 2n-1, rest conditions up to derivative n-1."""
    rest = [ZERO] * (n - 1)
    curve = Piecewise([hermite(mpf(1), [ZERO] + rest, [mpf(1)] + rest)]).derivative(n)
    return mp.quad(lambda z: curve(z) ** 2, [0, mpf(1) / 2, 1])


def front(jerk):
    """Least peak acceleration of a rest-to-rest law whose jerk stays within +-jerk: trapezoidal acceleration.

    Peak A with edges A/J: stroke = A (1/2 - A/J) / 2 = 1 for half-length 1/2, solved by bisection for A.
    """
    return bisect(lambda a: a * (mpf(1) / 2 - a / jerk) / 2 - 1, mpf(4), jerk / 4)


def make_rest_to_rest():
    peaks, squares, fronts = [], [], []
    for n, printed in ((2, 4), (3, 32), (4, 384), (5, 6144)):
        peak, knots = perfect_spline_peak(n)
        check_equal(f"perfect spline {n}", peak, mpf(printed))
        check_equal(f"perfect spline {n} formula", peak, mpf(2) ** (2 * n - 2) * mp.factorial(n - 1))
        peaks.append({"derivative": n, "peak": peak, "knots": knots})
    for n, printed in ((2, 12), (3, 720), (4, 100800)):
        value = square_integral(n)
        check_equal(f"least square integral {n}", value, mpf(printed))
        squares.append({"derivative": n, "integral": value})
    for jerk in (32, 36, 39.4784176043574, 60.0, 61.42597, 100.0, 1000.0, 1e6):
        j = exact(jerk)
        a = front(j) if jerk > 32 else mpf(8)
        check_equal(f"front at {jerk}", a, j / 4 * (1 - mp.sqrt(1 - 32 / j)), mpf(10) ** -40)
        fronts.append({"cj": float(jerk), "ca": a})
    check_printed("front at 60", "4.7530", fronts[3]["ca"])
    return {"peak_derivative": peaks, "square_integral": squares, "front": fronts,
            "peak_power": constant_power_peak()}


def constant_power_peak():
    """f' f'' = P, f' = sqrt(2 P z) up to 1/2: stroke = 2 sqrt(2P) (2/3) (1/2)^(3/2) = 1."""
    p = bisect(lambda p: 2 * mp.sqrt(2 * p) * mpf(2) / 3 * mpf("0.5") ** mpf("1.5") - 1, mpf(1), mpf(5))
    check_equal("constant power", p, mpf(9) / 4)
    return {"peak": p, "cv": mp.sqrt(p)}


# ------------------------------------------------------------------------------------- peak acceleration

STRETCHES = (  # v0, v1, displacement, length, velocity limit
    (0, 0, 1, 1, None), (0, 0, -3, 2, None), (0, 0, 0, 1, None), (1, 1, 1, 1, None), (1, 1, 0, 1, None),
    (2, -1, 0.5, 1, None), (-2, 3, 10, 4, None), (5, 0, 2, 1, None), (0, 5, 2.5, 1, None), (1, 1, -2, 0.5, None),
    (100, 80, 4000, 37, None), (1e-6, -1e-6, 1e-7, 0.25, None),
    (0, 0, 1, 1, 1.5), (0, 0, 1, 1, 1.125), (0, 0, -1, 1, 1.0625), (1, 1, -0.5, 2, 1.25),
    (2, -1, 0.5, 1, 2), (0, 2, 3.5, 2, 2), (1, 0.5, 2.5, 2, 1.5), (-1, 1, 0, 4, 1),
    (0, 0, 1, 1, 1), (0, 0, 3, 2, 1.25), (1, 1, 2, 2, 1), (3, 0, 1, 1, 2),
)


def furthest(a, v0, v1, t, limit):
    """Largest displacement in time t with |acceleration| <= a: up, coast at the limit, down."""
    up = (t + (v1 - v0) / a) / 2
    top = v0 + a * up
    if limit is None or top <= limit:
        return (v0 + top) / 2 * up + (top + v1) / 2 * (t - up)
    t_up, t_down = (limit - v0) / a, (limit - v1) / a
    return (v0 + limit) / 2 * t_up + limit * (t - t_up - t_down) + (limit + v1) / 2 * t_down


def reachable(a, v0, v1, d, t, limit):
    if a * t < abs(v1 - v0):
        return False
    return -furthest(a, -v0, -v1, t, limit) <= d <= furthest(a, v0, v1, t, limit)


def least_peak_acceleration(v0, v1, d, t, limit):
    """None if no acceleration, however large, does it."""
    if v0 == v1 and d == v0 * t:
        return ZERO
    if limit is not None and (max(abs(v0), abs(v1)) > limit or abs(d) >= limit * t):
        return None
    high = (abs(d) / t + abs(v0) + abs(v1)) / t
    while not reachable(high, v0, v1, d, t, limit):
        high *= 2
    low = ZERO
    for _ in range(230):
        middle = (low + high) / 2
        low, high = (low, middle) if middle and reachable(middle, v0, v1, d, t, limit) else (middle, high)
    return high


def make_peak_acceleration():
    rows = []
    for v0, v1, d, t, limit in STRETCHES:
        v0, v1, d, t = (float(x) for x in (v0, v1, d, t))
        e0, e1, ed, et = (exact(x) for x in (v0, v1, d, t))
        a = least_peak_acceleration(e0, e1, ed, et, None if limit is None else exact(limit))
        if limit is None:  # closed form with the displacement beyond the mean speed
            delta = abs(ed - (e0 + e1) / 2 * et)
            check_equal(f"peak acceleration {(v0, v1, d, t)}", a,
                        (2 * delta + mp.sqrt(4 * delta**2 + (e1 - e0) ** 2 * et**2)) / et**2)
        rows.append({"v0": v0, "v1": v1, "displacement": d, "length": t, "velocity_limit": limit and float(limit),
                     "feasible": a is not None, "peak_acceleration": a})
    return rows


# ----------------------------------------------------------------------------------- square acceleration

def make_square_acceleration():
    """The optimal acceleration is c0 + c1 t; both constants from the end conditions, the integral by quadrature."""
    cases = [row[:4] for row in STRETCHES if row[4] is None]
    cases += [(0, 0, 1e6, 1e3), (0, 1, 1, 3), (3, 3, 9.5, 3), (-1, -2, 4, 0.125), (0, 0, 1e-3, 1e-3), (7, -7, 0, 2),
              (1.1, 2.2, 3.3, 4.4), (0.1, -0.2, 0.3, 0.7)]
    rows = []
    for values in cases:
        v0, v1, d, t = (exact(x) for x in values)
        solution = mp.lu_solve(mp.matrix([[t, t**2 / 2], [t**2 / 2, t**3 / 6]]),
                               mp.matrix([v1 - v0, d - v0 * t]))
        c0, c1 = solution
        integral = mp.quad(lambda x: (c0 + c1 * x) ** 2, [ZERO, t])
        delta = d - (v0 + v1) / 2 * t
        check_equal(f"square acceleration {values}", integral, (v1 - v0) ** 2 / t + 12 * delta**2 / t**3)
        rows.append({"v0": float(values[0]), "v1": float(values[1]), "displacement": float(values[2]),
                     "length": float(values[3]), "integral": integral,
                     "acceleration_at_start": c0, "acceleration_at_end": c0 + c1 * t})
    assert len(rows) == 20, len(rows)
    return rows


# --------------------------------------------------------------------------------------------- peak jerk

JERK_CASES = (  # p0, v0, a0, p1, v1, a1, length
    (0, 0, 0, 1, 0, 0, 1), (0, 0, 0, 100, 50, 0, 4), (0, 1, 0, 1, 1, 0, 2), (5, -3, 2, -4, 1, -1, 3),
    (0, 0, 4, 1, 0, -4, 1), (0, 2, 0, 0, 2, 0, 1), (0, 0, 0, 0, 0, 1, 1), (10, 20, -30, 40, -50, 60, 0.5),
    (0, 1e-3, 0, 1e-6, 0, 0, 0.01), (0, 0, 0, 1, 3, 6, 1), (-1, 0.5, 0.25, 7, 0.125, -2, 6),
)


def perfect_jerk(p0, v0, a0, p1, v1, a1, t):
    """(J, sign of the first jerk, times-to-go of the two switches), from the moments of the jerk.

    With time to go x the moments are int u x^k / k! dx = m_k. For u = s J, -s J, s J with switches x1 >= x2 and
    w = 1/(s J):   x1 - x2 = p,  x1^2 - x2^2 = q,  x1^3 - x2^3 = r,  all linear in w, and 4 p r = 3 q^2 + p^4.
    """
    m = (a1 - a0, v1 - v0 - a0 * t, p1 - p0 - v0 * t - a0 * t**2 / 2)
    # scaled to t = 1 so that the quartic's coefficients are of one size
    n = [(m[0], 2 * m[1] / t, 6 * m[2] / t**2)[k] / t for k in range(3)]
    if n[0] == n[1] == n[2]:  # one constant jerk
        return n[0], [ZERO, ZERO]
    # p = (1 - n0 w)/2 and so on; expand 3 q^2 + p^4 - 4 p r in powers of w
    coefficients = [mpf(comb(4, k)) * (-n[0]) ** k / 16 for k in range(5)]
    for k, c in enumerate((1, -2 * n[1], n[1] ** 2)):
        coefficients[k] += 3 * c / 4
    for k, c in enumerate((1, -n[0] - n[2], n[0] * n[2])):
        coefficients[k] -= c
    while coefficients[-1] == 0:
        coefficients.pop()
    found = []
    for w in mp.polyroots(coefficients[::-1], maxsteps=2000, extraprec=400, error=False):
        if abs(mp.im(w)) > mpf(10) ** -25 or w == 0:
            continue
        w = mp.re(w)
        p, q = (1 - n[0] * w) / 2, (1 - n[1] * w) / 2
        if abs(p) < mpf(10) ** -25:
            continue
        x1, x2 = (q / p + p) / 2, (q / p - p) / 2
        slack = mpf(10) ** -25
        if -slack <= x2 <= x1 <= 1 + slack:
            found.append((1 / w, [x1, x2]))
    assert found, "no perfect spline"
    best = min(found, key=lambda f: abs(f[0]))
    assert all(abs(abs(f[0]) - abs(best[0])) < mpf(10) ** -20 * abs(best[0]) for f in found)
    return best


def make_peak_jerk():
    rows = []
    for values in JERK_CASES:
        p0, v0, a0, p1, v1, a1, t = (exact(x) for x in values)
        jerk, to_go = perfect_jerk(p0, v0, a0, p1, v1, a1, t)
        switches = [max(ZERO, (1 - x)) * t for x in to_go]
        lengths = [switches[0], switches[1] - switches[0], t - switches[1]]
        acceleration = Piecewise([Piece(h, (s * jerk,)) for h, s in zip(lengths, (1, -1, 1))]).integral(a0)
        velocity = acceleration.integral(v0)
        position = velocity.integral(p0)
        for name, curve, end in (("p", position, p1), ("v", velocity, v1), ("a", acceleration, a1)):
            last = curve.pieces[-1]
            check_equal(f"peak jerk {values}: end {name}", last(last.length), end, mpf(10) ** -22)
        rows.append({**dict(zip(("p0", "v0", "a0", "p1", "v1", "a1", "length"), (float(x) for x in values))),
                     "peak_jerk": abs(jerk), "first_jerk": jerk if lengths[0] > 0 else -jerk, "switches": switches})
    check_equal("peak jerk, rest to rest", rows[0]["peak_jerk"], mpf(32))
    return rows


def make():
    return {"rest_to_rest": make_rest_to_rest(), "peak_acceleration": make_peak_acceleration(),
            "square_acceleration": make_square_acceleration(), "peak_jerk": make_peak_jerk()}
