# SPDX-License-Identifier: Apache-2.0
"""Times along a path with 60 digits: ramps, legs from rest to rest, corners at constant speed, overlaps.

A ramp is built of its phases of constant jerk and integrated; its inverses are bisected for. No formula of a planner
is used, so that a cubic solved in closed form there meets a root found here.
"""
from exact import ZERO, Piece, Piecewise, bisect, check_equal
from mpmath import cbrt, inf, mp, mpf, sqrt


def phases(change, a, j):
    """Lengths of the phases of a ramp by `change`: jerk up, constant acceleration, jerk down."""
    if j == inf:
        return ZERO, change / a, ZERO
    if a == inf or change <= a * a / j:
        return sqrt(change / j), ZERO, sqrt(change / j)
    return a / j, change / a - a / j, a / j


def ramp_time(change, a, j):
    return sum(phases(change, a, j), ZERO)


def ramp_length(low, high, a, j):
    """The way of a ramp between two speeds, by integration of its jerk; equal to the mean speed times its time."""
    up, hold, down = phases(high - low, a, j)
    way = (low + high) / 2 * (up + hold + down)
    if j != inf and up > 0:
        pieces = [Piece(t, (s * j,)) for t, s in ((up, 1), (hold, 0), (down, -1)) if t > 0]
        speed = Piecewise(pieces).integral(ZERO).integral(low)
        check_equal("ramp speed", speed(speed.knots[-1]), high)
        check_equal("ramp length", speed.integral(ZERO)(speed.knots[-1]), way)
    return way


def reach(low, length, a, j):
    """The greatest speed that a ramp from `low` reaches in `length`."""
    over = max(low, mpf(1))
    while mean_way(low, low + over, a, j) < length:
        over *= 2
    return bisect(lambda v: mean_way(low, v, a, j) - length, low, low + over)


def mean_way(low, high, a, j):
    return (low + high) / 2 * ramp_time(high - low, a, j)


def leg(length, start, end, v, a, j, d=None):
    """Least time with zero acceleration at both ends and one speed between: (time, greatest speed)."""
    d = d or a
    need = lambda peak: mean_way(start, peak, a, j) + mean_way(end, peak, d, j)
    if need(v) <= length:
        return ramp_time(v - start, a, j) + ramp_time(v - end, d, j) + (length - need(v)) / v, v
    low = max(start, end)
    if need(low) > length * (1 + mpf(10) ** -50):
        return None, None
    peak = bisect(lambda w: need(w) - length, low, v)
    return ramp_time(peak - start, a, j) + ramp_time(peak - end, d, j), peak


def along(direction, path, axes):
    """A limit along a unit vector: that of the path and those of the axes."""
    return min([path] + [limit / abs(u) for limit, u in zip(axes, direction) if u != 0])


def corner_speed(before, after, length_of, most, v, a, j):
    """Greatest constant parameter speed through a T-blend: (speed, share of the ramps, length of the blend).

    `length_of(share)` is the blend that the deviation allows; `most` the trim that the legs allow. Along the share
    the bound of the acceleration falls and the one of the jerk rises, if the length does not depend on it too much:
    the best is bisected for and compared with a fine scan.
    """
    turn = [w - u for u, w in zip(before, after)]
    top = min(limit / max(abs(u), abs(w)) for limit, u, w in zip(v, before, after) if u != 0 or w != 0)
    length = lambda share: min(length_of(share), 2 * most)
    by_a = lambda b: min((sqrt(x * (1 - b) * length(b) / abs(t)) for x, t in zip(a, turn) if t != 0), default=inf)
    by_j = lambda b: min((cbrt(x * b * (1 - b) * length(b) ** 2 / abs(t)) for x, t in zip(j, turn) if t != 0),
                         default=inf)
    speed = lambda b: min(top, by_a(b), by_j(b))
    half, small = mpf(1) / 2, mpf(10) ** -12
    best = half
    if by_a(half) < by_j(half):
        best = bisect(lambda b: by_a(b) - by_j(b), small, half)
    for i in range(1, 65):
        assert speed(half * i / 64) <= speed(best) * (1 + mpf(10) ** -30), "the crossing is not the best"
    return speed(best), best, length(best)


def overlap_reach(t, a, j):
    """The way from rest after a time t of a ramp that is still accelerating: x(t)."""
    up = min(t, a / j)
    jerk = [Piece(up, (j,))] + ([Piece(t - up, (ZERO,))] if t > up else [])
    way = Piecewise(jerk).integral(ZERO).integral(ZERO).integral(ZERO)
    return way(way.knots[-1])


def overlap_time(turn, deviation, a, j):
    """How long two symmetric legs overlap so that the corner is passed at `deviation`; turn = |w - u|."""
    far = mpf(1)
    return 2 * bisect(lambda t: turn * overlap_reach(t, a, j) - deviation, mpf(10) ** -12, far)


def ideal_circle(r, a, v=inf):
    """Rest to rest along a full circle with the total acceleration below a: (ramp arc, ramp time, time).

    B = q'^2 obeys (B'/2)^2 + (B/r)^2 = a^2, whose solution from rest is B = a r sin(2 q / r).
    """
    share = min(mpf(1), v * v / (a * r))
    arc = r * mp.asin(share) / 2
    check = lambda q: (a * mp.cos(2 * q / r)) ** 2 + (a * mp.sin(2 * q / r)) ** 2
    check_equal("circle from rest", check(arc / 3), a * a)
    # The singularity q^(-1/2) at rest is taken out by q = z^2.
    time = mp.quad(lambda z: 2 * z / sqrt(a * r * mp.sin(2 * z * z / r)), [0, sqrt(arc)])
    return arc, time, sqrt(share * a * r)
