# SPDX-License-Identifier: Apache-2.0
"""Poles and margins of drives' loops with 40 digits: loop.json.

Continuous: L(s) as a ratio of polynomials, from the impedance of the chain of masses (the last one first); the
poles are roots of numerator + denominator, the crossings of |L| = 1 and of the real axis roots of polynomials in the
frequency. Sampled: one cycle of the closed loop, simulated state by state, is the matrix whose eigenvalues are
taken; its frequency response is solved for numerically. No state space, no Pade states, no eigenvalues of the drive's
equations: none of it as validate/ does it.
Run: python3 loop.py > loop.json
"""

import json
import sys

from mpmath import (arg, eig, exp, expm, eye, findroot, floor, im, log, log10, lu_solve, matrix, mp, mpc, mpf, pi,
                    polyroots, re)

mp.dps = 40


# ---- polynomials, the highest power first ----------------------------------------------------------

def mul(a, b):
    c = [mpf(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += x * y
    return c


def add(a, b):
    n = max(len(a), len(b))
    a, b = [mpf(0)] * (n - len(a)) + a, [mpf(0)] * (n - len(b)) + b
    return [x + y for x, y in zip(a, b)]


def scale(a, k):
    return [k * x for x in a]


def trimmed(a):
    size = max(abs(x) for x in a)
    while len(a) > 1 and abs(a[0]) <= size * mpf(10) ** -30 * abs(a[-1] or 1):
        if a[0] != 0:
            break
        a = a[1:]
    return a


def at_jw(a):
    """(real, imaginary) polynomials in w of a(j w)."""
    n = len(a) - 1
    real, imag = [mpf(0)] * (n + 1), [mpf(0)] * (n + 1)
    for i, x in enumerate(a):
        power = n - i
        k = power % 4
        target = real if k in (0, 2) else imag
        target[i] += x if k in (0, 1) else -x
    return real, imag


def value(a, s):
    v = mpf(0)
    for x in a:
        v = v * s + x
    return v


def roots(a):
    a = trimmed(a)
    tail = 0
    while len(a) > 1 and a[-1] == 0:
        a, tail = a[:-1], tail + 1
    # scaled so that the coefficients are of one size
    n = len(a) - 1
    if n == 0:
        return [mpf(0)] * tail
    k = abs(a[-1] / a[0]) ** (mpf(1) / n)
    scaled = [x * k ** (n - i) for i, x in enumerate(a)]
    scaled = [x / scaled[0] for x in scaled]
    return [k * r for r in polyroots(scaled, maxsteps=4000, extraprec=600)] + [mpf(0)] * tail


def positive_real(a):
    found = []
    for r in roots(a):
        if abs(im(r)) < mpf(10) ** -20 * abs(r) and re(r) > 0:
            found.append(re(r))
    return found


# ---- drives ----------------------------------------------------------------------------------------

def chain(bodies):
    """(numerator, denominator) of the motor's angle for a torque; bodies: (inertia, friction, stiffness, damping)."""
    num, den = None, None  # impedance of what hangs behind, torque / angle
    for i in reversed(range(len(bodies))):
        j, b, c, d = [mpf(x) for x in bodies[i]]
        own_n, own_d = [j, b, mpf(0)], [mpf(1)]
        if num is not None:
            own_n = add(mul(own_n, den), num)
            own_d = den
        if i == 0:
            return own_d, own_n
        shaft = [d, c]
        num, den = mul(shaft, own_n), add(mul(shaft, own_d), own_n)


def continuous(case):
    k = case["controller"]
    kp, kv = mpf(k["kp"]), mpf(k["kv"])
    num, den = chain(case["bodies"])
    num = mul(num, scale([mpf(1), kp], kv))
    if k["ti"]:
        num, den = mul(num, [mpf(k["ti"]), mpf(1)]), mul(den, [mpf(k["ti"]), mpf(0)])
    if k["delay"]:
        t = mpf(k["delay"])
        num, den = mul(num, [t * t, -6 * t, mpf(12)]), mul(den, [t * t, 6 * t, mpf(12)])
    if case["lag"]:
        den = mul(den, [mpf(case["lag"]), mpf(1)])
    nr, ni = at_jw(num)
    dr, di = at_jw(den)
    sub = lambda a, b: add(a, scale(b, -1))
    loop = lambda w: value(num, mpc(0, w)) / value(den, mpc(0, w))
    unity = positive_real(sub(add(mul(nr, nr), mul(ni, ni)), add(mul(dr, dr), mul(di, di))))
    real = positive_real(sub(mul(ni, dr), mul(nr, di)))
    return roots(add(num, den)), loop, unity, real


def plant(case):
    """x' = A x + b T of the open drive: angles, speeds, and the torque of the lag."""
    bodies = [[mpf(x) for x in b] for b in case["bodies"]]
    n, lag = len(bodies), mpf(case["lag"])
    size = 2 * n + (1 if lag else 0)
    a, b = matrix(size, size), matrix(size, 1)
    for i, (j, f, c, d) in enumerate(bodies):
        a[i, n + i] = 1
        a[n + i, n + i] -= f / j
        if i == 0:
            continue
        for side, sign in ((i - 1, -1), (i, 1)):
            js = bodies[side][0]
            a[n + side, i - 1] += sign * c / js
            a[n + side, i] -= sign * c / js
            a[n + side, n + i - 1] += sign * d / js
            a[n + side, n + i] -= sign * d / js
    if lag:
        a[n, 2 * n] = 1 / bodies[0][0]
        a[2 * n, 2 * n] = -1 / lag
        b[2 * n] = 1 / lag
    else:
        b[n] = 1 / bodies[0][0]
    return a, b


def moved(a, b, x, torque, time):
    """The plant after a constant torque."""
    n = a.rows
    m = matrix(n + 1, n + 1)
    for i in range(n):
        for j in range(n):
            m[i, j] = a[i, j] * time
        m[i, n] = b[i] * time
    e = expm(m, method="taylor")
    y = matrix(n, 1)
    for i in range(n):
        y[i] = sum(e[i, j] * x[j] for j in range(n)) + e[i, n] * torque
    return y


def sampled(case):
    k = case["controller"]
    kp, kv, ti, h = mpf(k["kp"]), mpf(k["kv"]), mpf(k["ti"]), mpf(k["cycle"])
    late = int(floor(mpf(k["delay"]) / h + mpf(10) ** -9))
    rest = mpf(k["delay"]) - late * h
    a, b = plant(case)
    n = a.rows
    waiting = late + (1 if rest > 0 else 0)

    def cycle(state, loop=None):
        """One cycle from the reading on; `loop`: the torque to apply instead of the one asked for."""
        x, z, before, queue = state[:n], state[n], state[n + 1], list(state[n + 2:])
        error = kv * (-kp * x[0] - (x[0] - before) / h)
        asked = error + z
        if ti:
            z = z + error * h / ti
        queue.insert(0, asked if loop is None else loop)
        x = matrix(x)
        angle = x[0]
        if rest > 0:
            x = moved(a, b, x, queue[late + 1], rest)
            x = moved(a, b, x, queue[late], h - rest)
        else:
            x = moved(a, b, x, queue[late], h)
        return list(x) + [z, angle] + queue[:waiting], asked

    size = n + 2 + waiting
    columns = [cycle([mpf(1) if i == j else mpf(0) for i in range(size)])[0] for j in range(size)]
    m = matrix(size, size)
    for j in range(size):
        for i in range(size):
            m[i, j] = columns[j][i]
    real = lambda z: re(z) if abs(im(z)) < mpf(10) ** -25 * abs(z) else z  # one logarithm of a negative number
    poles = [log(real(z)) / h for z in eig(m, left=False, right=False) if abs(z) > mpf(10) ** -9]

    # The open loop: the torque asked for when another one is applied.
    opened = matrix(size, size)
    given, asked = matrix(size, 1), matrix(1, size)
    for j in range(size):
        state, y = cycle([mpf(1) if i == j else mpf(0) for i in range(size)], mpf(0))
        asked[j] = y
        for i in range(size):
            opened[i, j] = state[i]
    state, _ = cycle([mpf(0)] * size, mpf(1))
    for i in range(size):
        given[i] = state[i]

    def loop(w):
        z = exp(mpc(0, w * h))
        x = lu_solve(z * eye(size) - opened, given)
        return -(asked * x)[0]

    unity, real = [], []
    mp.dps = 20  # for the search; refined below
    top = pi / h
    grid = [top * (mpf(i) / 3000) ** 2 for i in range(1, 3000)]
    values = [loop(w) for w in grid]
    mp.dps = 40
    for p, q, u, v in zip(grid, grid[1:], values, values[1:]):
        if (abs(u) > 1) != (abs(v) > 1):
            unity.append(findroot(lambda w: log(abs(loop(w))), (p, q), solver="anderson", tol=1e-25))
        if (im(u) > 0) != (im(v) > 0) and re(u) < 0:
            real.append(findroot(lambda w: im(loop(w)), (p, q), solver="anderson", tol=1e-25))
    real.append(top)
    return poles, loop, unity, real


def margins(poles, loop, unity, real):
    stable = max(re(p) for p in poles) < 0
    gain, phase = None, None
    for w in real:
        l = loop(w)
        if re(l) < 0 and abs(im(l)) < mpf(10) ** -10 * abs(l):
            db = -20 * log10(abs(l))
            if gain is None or abs(db) < abs(gain[0]):
                gain = (db, w / (2 * pi))
    for w in unity:
        degrees = abs(arg(-loop(w))) * 180 / pi
        if phase is None or degrees < phase[0]:
            phase = (degrees, w / (2 * pi))
    if not stable:
        gain = gain and (-abs(gain[0]), gain[1])
        phase = phase and (-phase[0], phase[1])
    return stable, gain, phase


def case(name, bodies, kp, kv, ti=0, delay=0, cycle=0, lag=0):
    given = {"bodies": bodies, "lag": lag,
             "controller": {"kp": kp, "kv": kv, "ti": ti, "delay": delay, "cycle": cycle}}
    poles, loop, unity, real = sampled(given) if cycle else continuous(given)
    stable, gain, phase = margins(poles, loop, unity, real)
    ordered = sorted((p for p in poles if im(p) >= -mpf(10) ** -15 * abs(p)), key=lambda p: -re(p))
    pair = lambda m: m and [float(m[0]), float(m[1])]
    points = []
    for f in (0.5, 5.0, 50.0, 200.0):
        l = loop(2 * pi * mpf(f))
        points.append([f, float(re(l)), float(im(l))])
    print(name, stable, pair(gain), pair(phase), file=sys.stderr)
    return {"name": name, **given, "stable": bool(stable), "gain": pair(gain), "phase": pair(phase),
            "poles": [[float(re(p)), float(abs(im(p)) / (2 * pi))] for p in ordered], "loop": points}


TWO = [[4e-5, 1e-4, 0, 0], [2e-4, 0, 50, 5e-3]]
FOUR = [[4e-5, 1e-4, 0, 0], [5e-5, 0, 400, 1e-3], [1e-4, 1e-4, 120, 2e-3], [5e-5, 0, 200, 1e-3]]

CASES = [
    case("rigid", [[2.4e-4, 1e-4, 0, 0]], 40, 0.05, 0.02),
    case("two masses", TWO, 40, 0.05, 0.02),
    case("two masses, delay 0.86 ms", TWO, 40, 0.05, 0.02, delay=8.6e-4),
    case("two masses, delay 1.1 ms", TWO, 40, 0.05, 0.02, delay=1.1e-3),
    case("gain too low for the integral part", [[2.4e-4, 0, 0, 0]], 200, 0.01, 0.002),
    case("four masses, lag", FOUR, 60, 0.08, 0.03, lag=1e-4),
    case("four masses, lag and delay", FOUR, 60, 0.08, 0.03, lag=1e-4, delay=3e-4),
    case("sampled", TWO, 40, 0.05, 0.02, cycle=2.5e-4),
    case("sampled, delay of part of a cycle", TWO, 40, 0.05, 0.02, cycle=2.5e-4, delay=1e-4),
    case("sampled, delay of cycles", TWO, 40, 0.05, 0.02, cycle=2.5e-4, delay=6e-4, lag=1e-4),
    case("sampled too slowly", [[2.4e-4, 1e-4, 0, 0]], 40, 0.05, 0.02, cycle=1e-2),
]

print(json.dumps({"cases": CASES}, indent=1))
