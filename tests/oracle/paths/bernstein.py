# SPDX-License-Identifier: Apache-2.0
"""Polynomials on [0, 1] in plain Python: exact extrema and sign changes by subdivision of the Bernstein form.

A polynomial is a list of power coefficients, lowest first, in s of [0, 1]; `bernstein` gives the list of Bernstein
coefficients, which enclose the values. Nothing is sampled: an interval is dropped when its coefficients prove that
it cannot matter, and otherwise halved.
"""
from functools import lru_cache
from math import ceil, comb, cos, factorial, sin


def value(c, s):
    result = 0.0
    for x in reversed(c):
        result = result * s + x
    return result


def derivative(c, h=1.0):
    return [k * x / h for k, x in enumerate(c)][1:] or [0.0]


def add(a, b):
    n = max(len(a), len(b))
    return [(a[i] if i < len(a) else 0.0) + (b[i] if i < len(b) else 0.0) for i in range(n)]


def scale(k, a):
    return [k * x for x in a]


def multiply(a, b):
    out = [0.0] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        if x:
            for j, y in enumerate(b):
                out[i + j] += x * y
    return out


def squares(polynomials):
    total = [0.0]
    for p in polynomials:
        total = add(total, multiply(p, p))
    return total


def part(c, s0, s1):
    """The same polynomial over [s0, s1], as one over [0, 1]."""
    n, d = len(c), s1 - s0
    out = list(c)
    for i in range(n - 1):  # Taylor shift by s0
        for j in range(n - 2, i - 1, -1):
            out[j] += s0 * out[j + 1]
    return [x * d**k for k, x in enumerate(out)]


@lru_cache(maxsize=None)
def weights(n):
    return [[comb(i, k) / comb(n, k) for k in range(i + 1)] for i in range(n + 1)]


def bernstein(c):
    return [sum(w * x for w, x in zip(row, c)) for row in weights(len(c) - 1)]


def halves(b):
    """De Casteljau at the middle."""
    left, right, row = [b[0]], [b[-1]], list(b)
    while len(row) > 1:
        row = [(x + y) / 2 for x, y in zip(row, row[1:])]
        left.append(row[0])
        right.append(row[-1])
    return left, right[::-1]


def greatest(c, floor=None):
    """(value, s) of the maximum over [0, 1]. With `floor`, a maximum below it may come out too small."""
    b = bernstein(c)
    best, at = (b[0], 0.0) if b[0] >= b[-1] else (b[-1], 1.0)
    slack = 1e-15 * max(map(abs, b))
    stack = [(b, 0.0, 1.0)]
    while stack:
        b, s, d = stack.pop()
        top = max(b)
        if top <= best + slack or (floor is not None and top <= floor):
            continue
        left, right = halves(b)
        if left[-1] > best:
            best, at = left[-1], s + d / 2
        if d > 1e-13:
            stack += [(left, s, d / 2), (right, s + d / 2, d / 2)]
    return best, at


def sign_changes(c, resolution=1e-13):
    """Where a polynomial goes through zero in [0, 1], to the resolution."""
    b = bernstein(c)
    noise = 4e-16 * max(map(abs, b)) * len(b)
    found, stack = [], [(b, 0.0, 1.0)]
    while stack:
        b, s, d = stack.pop()
        if min(b) > noise or max(b) < -noise or max(map(abs, b)) <= noise:
            continue
        if d < resolution:
            found.append(s + d / 2)
            continue
        left, right = halves(b)
        stack += [(right, s + d / 2, d / 2), (left, s, d / 2)]
    distinct = []
    for s in sorted(found):
        if not distinct or s - distinct[-1] > 10 * resolution:
            distinct.append(s)
    return distinct


def of_sines(c, sines):
    """A polynomial plus sines [amplitude, angle, phase] as polynomials over equal parts of [0, 1].

    Each part turns every sine by at most half a radian; the Taylor series to degree 15 leaves 7e-19 of the amplitude.
    """
    parts = max([1] + [ceil(2 * abs(angle)) for _, angle, _ in sines])
    out = []
    for k in range(parts):
        p = part(c, k / parts, (k + 1) / parts)
        for amplitude, angle, phase in sines:
            turn, start = angle / parts, angle * k / parts + phase
            cycle = [sin(start), cos(start), -sin(start), -cos(start)]
            p = add(p, [amplitude * cycle[n % 4] * turn**n / factorial(n) for n in range(16)])
        out.append(p)
    return out


def hermite(h, left, right):
    """The polynomial over a length h with the given value, and derivatives, at both ends (two or three of each)."""
    d = right[0] - left[0]
    if len(left) == 1:
        return [left[0], d]
    v0, v1 = left[1] * h, right[1] * h
    if len(left) == 2:
        return [left[0], v0, 3 * d - 2 * v0 - v1, v0 + v1 - 2 * d]
    a0, a1 = left[2] * h * h, right[2] * h * h
    return [left[0], v0, a0 / 2, 10 * d - 6 * v0 - 4 * v1 - (3 * a0 - a1) / 2,
            -15 * d + 8 * v0 + 7 * v1 + (3 * a0 - 2 * a1) / 2, 6 * d - 3 * (v0 + v1) - (a0 - a1) / 2]
