# SPDX-License-Identifier: Apache-2.0
"""Shapes of a path with 60 digits: arcs by every definition, helices, ellipses, blends of corners.

Each shape is derived from its definition (distances, linear equations, integrals), not from a planner's formulas.
"""
from exact import ZERO, Piece, Piecewise, bisect, check_equal, hermite
from mpmath import atan2, cos, mp, mpf, pi, sin, sqrt


# --------------------------------------------------------------------------------------------- vectors

def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def times(k, a):
    return [k * x for x in a]


def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), ZERO)


def norm(a):
    return sqrt(dot(a, a))


def unit(a):
    return times(1 / norm(a), a)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def left(a):
    return [-a[1], a[0]]


# ------------------------------------------------------------------------------------------------ arcs

def turn(before, after):
    """The signed angle from one planar direction to the next, counterclockwise positive."""
    return atan2(before[0] * after[1] - before[1] * after[0], dot(before, after))


def turn_between(start, end):
    """The counterclockwise angle from one vector to another, in (0, 2 pi]: equal vectors make a full turn."""
    angle = turn(start, end)
    return angle + 2 * pi if angle <= mpf(10) ** -45 else angle


def arc(start, center, sweep):
    """A planar arc: what every definition leads to. A positive sweep is counterclockwise."""
    r = minus(start, center)
    at = lambda f: plus(center, [r[0] * cos(f * sweep) - r[1] * sin(f * sweep), r[0] * sin(f * sweep) + r[1] * cos(f * sweep)])
    return {"center": center, "radius": norm(r), "sweep": sweep, "length": norm(r) * abs(sweep),
            "points": [at(mpf(i) / 4) for i in range(5)],
            "tangents": [times(mp.sign(sweep) / norm(r), left(minus(at(mpf(i)), center))) for i in (0, 1)]}


def by_center(start, end, center, clockwise, extra_turns=0):
    angle = turn_between(minus(start, center), minus(end, center))
    if clockwise:
        angle = angle - 2 * pi if angle < 2 * pi else -2 * pi
    return arc(start, center, angle + 2 * pi * extra_turns * (-1 if clockwise else 1))


def by_radius(start, end, radius, clockwise, extra_turns=0):
    """The center is on the chord's bisector; a positive radius means the arc below 180 degrees."""
    chord = minus(end, start)
    middle = times(mpf(1) / 2, plus(start, end))
    height = sqrt(max(ZERO, radius ** 2 - dot(chord, chord) / 4))
    candidates = [plus(middle, times(s * height, unit(left(chord)))) for s in (1, -1)]
    arcs = [by_center(start, end, c, clockwise) for c in candidates]
    pick = min if radius > 0 else max
    best = pick(arcs, key=lambda a: abs(a["sweep"]))
    return by_center(start, end, best["center"], clockwise, extra_turns)


def circumcenter(points):
    """The point of the plane of three points that is equally far from them (a linear system), in any dimension."""
    a, b = minus(points[1], points[0]), minus(points[2], points[0])
    m = mp.matrix([[dot(a, a), dot(a, b)], [dot(a, b), dot(b, b)]])
    x = mp.lu_solve(m, mp.matrix([dot(a, a) / 2, dot(b, b) / 2]))
    center = plus(points[0], plus(times(x[0], a), times(x[1], b)))
    for p in points[1:]:
        check_equal("circumcenter", norm(minus(p, center)), norm(minus(points[0], center)))
    return center


def by_three_points(start, via, end):
    center = circumcenter([start, via, end])
    to_via = turn_between(minus(start, center), minus(via, center))
    to_end = turn_between(minus(start, center), minus(end, center))
    return arc(start, center, to_end if to_via < to_end else to_end - 2 * pi)


def in_space(start, via, end):
    center = circumcenter([start, via, end])
    x = unit(minus(start, center))
    normal = unit(cross(minus(via, start), minus(end, start)))
    y = cross(normal, x)
    flat = lambda p: [dot(minus(p, center), x), dot(minus(p, center), y)]
    sweep = turn_between(flat(start), flat(end))
    assert turn_between(flat(start), flat(via)) < sweep, "the normal has the sense start, via, end"
    r = norm(minus(start, center))
    at = lambda f: plus(center, plus(times(r * cos(f * sweep), x), times(r * sin(f * sweep), y)))
    return {"center": center, "radius": r, "normal": normal, "sweep": sweep, "length": r * sweep,
            "points": [at(mpf(i) / 4) for i in range(5)]}


def by_turns(start, end, center, turns):
    """HIMC 8.2.17: the sweep that `turns` asks for, in degrees counterclockwise."""
    angle = turn_between(minus(start, center), minus(end, center))
    if angle == 2 * pi:
        angle = ZERO  # start and end coincide: the manual's rule has 0 here
    return angle + 2 * pi * (max(turns, 1) - 1) if turns >= 0 else angle + 2 * pi * turns


def nearest_center(start, end, center):
    """A center that does not fit, moved along the chord's direction onto the chord's bisector."""
    chord = unit(minus(end, start))
    off = dot(minus(center, times(mpf(1) / 2, plus(start, end))), chord)
    moved = minus(center, times(off, chord))
    check_equal("moved center", norm(minus(start, moved)), norm(minus(end, moved)))
    return {"center": moved, "moved": abs(off), "radius": norm(minus(start, moved)),
            "misfit": abs(norm(minus(start, center)) - norm(minus(end, center)))}


def helix(radius, pitch):
    """Curvature, torsion and length of a turn, from derivatives of (R cos p, R sin p, pitch p / 2 pi)."""
    c = pitch / (2 * pi)
    r1, r2, r3 = [ZERO, radius, c], [-radius, ZERO, ZERO], [ZERO, -radius, ZERO]
    b = cross(r1, r2)
    return {"curvature": norm(b) / norm(r1) ** 3, "torsion": dot(b, r3) / dot(b, b), "turn": 2 * pi * norm(r1)}


def ellipse_length(a, b, start, end):
    """Length between two eccentric angles: quadrature, compared with the elliptic integral."""
    low, high = min(start, end), max(start, end)
    cuts = [low + (high - low) * i / 8 for i in range(9)]
    length = mp.quad(lambda t: sqrt((a * sin(t)) ** 2 + (b * cos(t)) ** 2), cuts)
    m = 1 - (a / b) ** 2
    check_equal("ellipse", length, b * (mp.ellipe(high, m) - mp.ellipe(low, m)), mpf(10) ** -30)
    return length


def ellipse_from(start, center, angle, ratio):
    """Half axes and eccentric angle of PMC600's ellipse: it passes `start`, its major axis is turned by `angle`."""
    d = minus(start, center)
    along, across = d[0] * cos(angle) + d[1] * sin(angle), d[1] * cos(angle) - d[0] * sin(angle)
    major = sqrt(along ** 2 + (across / ratio) ** 2)
    return major, ratio * major, atan2(across / ratio, along)


# -------------------------------------------------------------------------------------------- T-blends

def turn_shape(share):
    """T' of a trapezoid with ramps of `share` each, area 1; share 0 is a box, 1/2 a triangle."""
    top = 1 / (1 - share)
    if share == 0:
        return Piecewise([Piece(mpf(1), (top,))])
    pieces = [Piece(share, (ZERO, top / share)), Piece(1 - 2 * share, (top,)), Piece(share, (top, -top / share))]
    return Piecewise([p for p in pieces if p.length > 0])


POLYNOMIAL_TURNS = {"quartic": Piece(mpf(1), (ZERO, mpf(6), mpf(-6))),
                    "sextic": Piece(mpf(1), (ZERO, ZERO, mpf(30), mpf(-60), mpf(30)))}


class TBlend:
    """r' = u + (w - u) T(q / length), q from 0, with the corner at the origin; the trim is half the length."""

    def __init__(self, before, after, shape):
        self.u, self.turn = before, minus(after, before)
        self.rate = shape if isinstance(shape, Piecewise) else Piecewise([shape])
        self.share = self.rate.integral(ZERO)
        self.area = self.share.integral(ZERO)
        check_equal("T(1)", self.share(mpf(1)), mpf(1))
        check_equal("both trims are equal", self.area(mpf(1)), mpf(1) / 2)
        self.half = self.area(mpf(1) / 2)

    def length_for(self, deviation):
        return deviation / (norm(self.turn) * self.half)

    def at(self, x, length):
        return plus(times((x - mpf(1) / 2) * length, self.u), times(self.area(x) * length, self.turn))

    def curvature(self, x, length):
        r1, r2 = plus(self.u, times(self.share(x), self.turn)), times(self.rate(x) / length, self.turn)
        return sqrt(max(ZERO, dot(r1, r1) * dot(r2, r2) - dot(r1, r2) ** 2)) / norm(r1) ** 3

    def off_path(self, x, length):
        """Distance of the curve from the corner's two legs."""
        p, w = self.at(x, length), plus(self.u, self.turn)
        back, forth = max(ZERO, -dot(p, self.u)), max(ZERO, dot(p, w))
        return min(norm(plus(p, times(back, self.u))), norm(minus(p, times(forth, w))))


# -------------------------------------------------------------------------------------- Hermite blends

def on_line(direction, distance):
    """Position from the corner and three derivatives by arc length, `distance` (signed) from the corner."""
    none = [ZERO] * len(direction)
    return [times(distance, direction), list(direction), none, none]


def on_arc(direction, radius, distance):
    """The same on a circle that has `direction` at the corner; a positive radius turns left."""
    n, p = left(direction), distance / radius
    tangent = plus(times(cos(p), direction), times(sin(p), n))
    normal = left(tangent)
    return [plus(times(radius * sin(p), direction), times(radius * (1 - cos(p)), n)), tangent,
            times(1 / radius, normal), times(-1 / radius ** 2, tangent)]


def neighbour(direction, radius, distance):
    return on_line(direction, distance) if radius is None else on_arc(direction, radius, distance)


class HermiteBlend:
    """Both neighbours trimmed by d; the polynomial with their derivatives at its ends, parameter length 2 d."""

    def __init__(self, before, radius_before, after, radius_after, trim, orders):
        self.sides = (before, radius_before), (after, radius_after)
        self.trim = trim
        a, b = neighbour(before, radius_before, -trim), neighbour(after, radius_after, trim)
        self.axes = [hermite(2 * trim, [v[k] for v in a[:orders]], [v[k] for v in b[:orders]]) for k in (0, 1)]
        self.d1 = [f.derivative() for f in self.axes]
        self.d2 = [f.derivative() for f in self.d1]

    def at(self, q):
        return [f(q) for f in self.axes]

    def curvature(self, q):
        x1, y1, x2, y2 = self.d1[0](q), self.d1[1](q), self.d2[0](q), self.d2[1](q)
        return abs(x1 * y2 - y1 * x2) / (x1 * x1 + y1 * y1) ** (mpf(3) / 2)

    def deviation(self):
        """Distance of the curve from the corner."""
        slope = lambda q: dot(self.at(q), [f(q) for f in self.d1])
        grid = [2 * self.trim * i / 24 for i in range(25)]
        ends = [norm(self.at(grid[0])), norm(self.at(grid[-1]))]
        signs = [slope(q) for q in grid]
        roots = [bisect(slope, a, b) for a, b, fa, fb in zip(grid, grid[1:], signs, signs[1:]) if fa < 0 <= fb]
        return min(ends + [norm(self.at(q)) for q in roots])

    def off_path(self, q):
        """Distance of the curve from the two neighbours, each ending at the corner."""
        p = self.at(q)
        return min(self.off_side(p, *self.sides[0], -1), self.off_side(p, *self.sides[1], 1))

    @staticmethod
    def off_side(p, direction, radius, side):
        if radius is None:
            s = dot(p, direction)
            return norm(minus(p, times(s, direction))) if side * s >= 0 else norm(p)
        r = minus(p, times(radius, left(direction)))
        return abs(norm(r) - abs(radius)) if side * dot(r, direction) >= 0 else norm(p)


def greatest(function, low, high, cells=96):
    """The greatest value of a smooth function: the best of a grid, refined by golden section."""
    grid = [low + (high - low) * i / cells for i in range(cells + 1)]
    values = [function(x) for x in grid]
    best = max(range(cells + 1), key=lambda i: values[i])
    a, b = grid[max(best - 1, 0)], grid[min(best + 1, cells)]
    golden = (sqrt(mpf(5)) - 1) / 2
    x, y = b - golden * (b - a), a + golden * (b - a)
    fx, fy = function(x), function(y)
    for _ in range(70):
        if fx < fy:
            a, x, fx = x, y, fy
            y = a + golden * (b - a)
            fy = function(y)
        else:
            b, y, fy = y, x, fx
            x = b - golden * (b - a)
            fx = function(x)
    return max(fx, fy, values[best])


def trim_for(deviation, before, radius_before, after, radius_after, orders, most):
    """The trim whose blend passes the corner at `deviation`, by bisection; the deviation must grow with the trim."""
    off = lambda d: HermiteBlend(before, radius_before, after, radius_after, d, orders).deviation()
    few = [off(most * i / 6) for i in range(1, 7)]
    if any(a >= b for a, b in zip(few, few[1:])) or few[-1] < deviation:
        return None
    return bisect(lambda d: off(d) - deviation, most / 10**6, most)
