#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives with backlash and with dry friction, by Runge-Kutta with a fixed step: tests/oracle/drive.json.

A motor and a load on a shaft under a P-PI cascade, in absolute angles and plain Python (3.11); none
of our code. Steps of 10 us; where a switch would fall within a step, its instant is found by
bisection of the step. A run with half the step differs by the "error" that is written beside each case.

    python3 tests/oracle/drive.py > tests/oracle/drive.json
"""
import json
import math

STROKE, TIME, END = 2 * math.pi, 0.2, 0.4  # one turn by the 3-4-5 law, then standstill

JM, JL, C, D = 4e-5, 2e-4, 50.0, 5e-3
KP, KV, TI = 40.0, 0.05, 0.02


def reference(t):
    if t >= TIME:
        return STROKE, 0.0, 0.0
    s = t / TIME
    return (STROKE * s**3 * (10 - 15 * s + 6 * s * s),
            STROKE / TIME * 30 * s * s * (1 - s) ** 2,
            STROKE / TIME**2 * 60 * s * (1 - s) * (1 - 2 * s))


class Friction:
    def __init__(self, viscous, coulomb=0.0, breakaway=0.0, speed=1.0):
        self.b, self.tc, self.ts, self.ws = viscous, coulomb, breakaway, speed

    def sliding(self, w):
        return self.tc + (self.ts - self.tc) * math.exp(-((w / self.ws) ** 2))


class Axis:
    def __init__(self, gap, motor, load):
        self.gap, self.f = gap, (motor, load)
        self.touch = 0 if gap else 1  # flank: -1, 0, 1
        self.slide = [0 if f.ts else None for f in self.f]  # None: no dry friction

    def flank(self, y, sign):
        """(press of the spring, torque of spring and damper) of that flank."""
        twist, rate = y[0] - y[2], y[1] - y[3]
        spring = C * (sign * twist - self.gap / 2)
        return spring, sign * (spring + sign * D * rate)

    def shaft(self, y):
        if not self.gap:
            return C * (y[0] - y[2]) + D * (y[1] - y[3])
        return self.flank(y, self.touch)[1] if self.touch else 0.0

    def net(self, t, y):
        r, v, a = reference(t)
        e = KP * (r - y[0]) + v - y[1]
        torque = KV * e + y[4] + (JM + JL) * a
        s = self.shaft(y)
        return e, torque - s - self.f[0].b * y[1], s - self.f[1].b * y[3]

    def slope(self, t, y):
        e, motor, load = self.net(t, y)
        out = [y[1], 0.0, y[3], 0.0, KV * e / TI]
        for i, (n, j) in enumerate(((motor, JM), (load, JL))):
            if self.slide[i] is None:
                out[2 * i + 1] = n / j
            elif self.slide[i]:
                out[2 * i + 1] = (n - self.slide[i] * self.f[i].sliding(y[2 * i + 1])) / j
        return out

    def guards(self, t, y):
        """The quantities that must stay positive for the modes to hold."""
        out = []
        if self.gap:
            if self.touch:
                spring, torque = self.flank(y, self.touch)
                out.append(min(spring, self.touch * torque))
            else:
                out += [-min(self.flank(y, s)[0], s * self.flank(y, s)[1]) for s in (1, -1)]
        n = self.net(t, y)[1:]
        for i in (0, 1):
            if self.slide[i] == 0:
                out.append(self.f[i].ts - abs(n[i]))
            elif self.slide[i]:
                out.append(self.slide[i] * y[2 * i + 1])
        return out

    def switch(self, t, y):
        tiny = 1e-13
        if self.gap:
            press = {s: min(self.flank(y, s)[0], s * self.flank(y, s)[1]) for s in (1, -1)}
            if self.touch and press[self.touch] <= tiny:
                self.touch = 0
            elif not self.touch:
                for s in (1, -1):
                    if press[s] >= -tiny:
                        self.touch = s
        for i in (0, 1):
            if self.slide[i] is None:
                continue
            n = self.net(t, y)[1 + i]
            if self.slide[i] == 0 and abs(n) >= self.f[i].ts - tiny:
                self.slide[i] = 1 if n > 0 else -1
            elif self.slide[i] and self.slide[i] * y[2 * i + 1] <= tiny:
                y[2 * i + 1] = 0.0
                self.slide[i] = 0 if abs(n) <= self.f[i].ts else (1 if n > 0 else -1)


def runge_kutta(axis, t, y, h):
    k1 = axis.slope(t, y)
    k2 = axis.slope(t + h / 2, [a + h / 2 * b for a, b in zip(y, k1)])
    k3 = axis.slope(t + h / 2, [a + h / 2 * b for a, b in zip(y, k2)])
    k4 = axis.slope(t + h, [a + h * b for a, b in zip(y, k3)])
    return [a + h / 6 * (b + 2 * c + 2 * d + e) for a, b, c, d, e in zip(y, k1, k2, k3, k4)]


def advance(axis, t, y, h):
    """One step; where a guard falls, to that instant, switch, and on."""
    left, switches = h, 0
    while left > 1e-15:
        # a guard that is zero now was just switched at: it counts once it has been positive
        before = axis.guards(t, y)
        fell = lambda z, u: any(b > 1e-12 and g < 0 for b, g in zip(before, axis.guards(u, z)))
        grown = lambda z, u: any(b <= 1e-12 and g < -1e-10 for b, g in zip(before, axis.guards(u, z)))
        z = runge_kutta(axis, t, y, left)
        if not fell(z, t + left) and not grown(z, t + left):
            return z, switches
        low, high = 0.0, left
        for _ in range(60):
            middle = (low + high) / 2
            z = runge_kutta(axis, t, y, middle)
            if fell(z, t + middle) or grown(z, t + middle):
                high = middle
            else:
                low = middle
        y = runge_kutta(axis, t, y, high)
        t, left, switches = t + high, left - high, switches + 1
        axis.switch(t, y)
    return y, switches


def run(make, h):
    axis, y, count = make(), [0.0] * 5, 0
    steps, samples = round(END / h), []
    for k in range(steps):
        if k % (steps // 40) == 0:
            samples.append((y[0], y[2]))
        y, n = advance(axis, k * h, y, h)
        count += n
    return samples + [(y[0], y[2])], count


CASES = {
    "backlash": lambda: Axis(2e-3, Friction(1e-4), Friction(1e-4)),
    "stribeck": lambda: Axis(0, Friction(1e-4, 0.02, 0.03, 2.0), Friction(1e-4, 0.05, 0.08, 2.0)),
    "both": lambda: Axis(4e-3, Friction(1e-4), Friction(1e-4, 0.05, 0.08, 2.0)),
}

out = {}
for name, make in CASES.items():
    coarse, _ = run(make, 2e-5)
    fine, switches = run(make, 1e-5)
    error = max(abs(a - b) for p, q in zip(coarse, fine) for a, b in zip(p, q))
    out[name] = {"switches": switches, "error": error,
                 "motor": [p[0] for p in fine], "load": [p[1] for p in fine]}
print(json.dumps(out, indent=1))
