# SPDX-License-Identifier: Apache-2.0
"""Linear drives along references, by matrix exponentials with 30 digits: linear_drive.json.

Absolute angles, the reference's derivatives as states, Van Loan's block exponential for the integral
of torque squared: none of it as validate/ does it. Run: python3 linear_drive.py > linear_drive.json
"""

import json

from mpmath import cos, expm, matrix, mp, mpf, pi, sin, sqrt

mp.dps = 30


class Drive:
    def __init__(self, bodies, kp, kv, ti, kff, ktff, kfff=0, lag=0, rev=360, load=None, motor=None):
        """bodies: (inertia, friction, load torque, stiffness to the one before, its damping)."""
        self.bodies = [[mpf(x) for x in b] for b in bodies]
        self.kp, self.kv, self.ti = mpf(kp), mpf(kv), mpf(ti)
        self.kff, self.ktff, self.kfff, self.lag = mpf(kff), mpf(ktff), mpf(kfff), mpf(lag)
        self.rad = 2 * pi / mpf(rev)
        self.load = len(bodies) - 1 if load is None else load
        self.inertia = sum(b[0] for b in self.bodies)
        self.friction = sum(b[1] for b in self.bodies)

    def matrix(self, omegas, order):
        """States: angles, speeds, integral, torque of the lag, 1, r .. r^(order-1), sin and cos."""
        n = len(self.bodies)
        z, t, one, r = 2 * n, 2 * n + 1, 2 * n + 2, 2 * n + 3
        size = r + order + 2 * len(omegas)
        a = matrix(size, size)
        for k in range(order - 1):
            a[r + k, r + k + 1] = 1
        ref = [matrix(1, size) for _ in range(3)]
        for k in range(3):
            ref[k][0, r + k] = 1
        for i, o in enumerate(omegas):
            s, c = r + order + 2 * i, r + order + 2 * i + 1
            a[s, c], a[c, s] = o, -o
            ref[0][0, s], ref[1][0, c], ref[2][0, s] = 1, o, -o * o
        e = self.rad * (self.kp * ref[0] + self.kff * ref[1])
        e[0, 0] -= self.kp
        e[0, n] -= 1
        asked = self.kv * e + self.rad * (self.ktff * self.inertia * ref[2]
                                          + self.kfff * self.friction * ref[1])
        if self.ti:
            asked[0, z] += 1
            a[z, :] = self.kv / self.ti * e
        torque = asked
        if self.lag:
            given = matrix(1, size)
            given[0, t] = 1
            a[t, :] = (asked - given) / self.lag
            torque = given
        self.add_bodies(a, one, torque)
        return a, torque, ref[0]

    def add_bodies(self, a, one, torque):
        n = len(self.bodies)
        for i, (inertia, friction, load, stiffness, damping) in enumerate(self.bodies):
            a[i, n + i] = 1
            a[n + i, n + i] -= friction / inertia
            a[n + i, one] -= load / inertia
            if i:
                for body, sign in ((i, 1), (i - 1, -1)):
                    f = sign / self.bodies[body][0]
                    a[n + body, i - 1] += f * stiffness
                    a[n + body, i] -= f * stiffness
                    a[n + body, n + i - 1] += f * damping
                    a[n + body, n + i] -= f * damping
        a[n, :] += torque / self.bodies[0][0]


    def rest(self):
        """Angles relative to the reference, and the motor's torque, in equilibrium with the loads."""
        torque = held = sum(b[2] for b in self.bodies)
        angles = [mpf(0) if self.ti else -torque / (self.kv * self.kp)]
        for before, body in zip(self.bodies, self.bodies[1:]):
            torque -= before[2]
            angles.append(angles[-1] - torque / body[3])
        return angles, held


def factorial(k):
    return mpf(1) if k < 2 else k * factorial(k - 1)


def derivative(segment, k, s):
    length, c, sines = segment
    p = sum(mpf(c[i]) * factorial(i) / factorial(i - k) * s ** (i - k) for i in range(k, len(c)))
    for amplitude, angle, phase in sines:
        p += amplitude * mpf(angle) ** k * sin(angle * s + phase + k * pi / 2)
    return p / mpf(length) ** k


def place(x, base, segment, order):
    length, c, sines = segment
    for k in range(order):
        x[base + k] = derivative((length, c, []), k, mpf(0))
    for i, (amplitude, angle, phase) in enumerate(sines):
        x[base + order + 2 * i] = amplitude * sin(phase)
        x[base + order + 2 * i + 1] = amplitude * cos(phase)


def van_loan(a, q, t):
    """exp(a t) and the integral of (q exp(a u))' (q exp(a u)) over u from 0 to t."""
    size = a.rows
    block = matrix(2 * size, 2 * size)
    block[:size, :size] = -a.T * t
    block[:size, size:] = q.T * q * t
    block[size:, size:] = a * t
    e = expm(block)
    return e[size:, size:], e[size:, size:].T * e[:size, size:]


def continuous(drive, segments, times):
    n = len(drive.bodies)
    base = 2 * n + 3
    core = matrix(base, 1)
    core[2 * n + 2] = 1
    angles, held = drive.rest()
    for i in range(n):
        core[i] = drive.rad * derivative(segments[0], 0, mpf(0)) + angles[i]
    core[2 * n] = held if drive.ti else 0
    core[2 * n + 1] = held
    end = sum(mpf(s[0]) for s in segments)
    pieces = segments + [(None, [derivative(segments[-1], 0, mpf(1))], [])]
    begin, square, samples, left = mpf(0), mpf(0), [], list(times)
    for piece in pieces:
        length = piece[0]
        order = max(3, len(piece[1]))
        a, torque, ref = drive.matrix([mpf(w[1]) / length for w in piece[2]] if length else [], order)
        x = matrix(a.rows, 1)
        x[:base] = core
        place(x, base, piece if length else (1, piece[1], []), order)
        while left and (length is None or mpf(left[0]) < begin + length):
            y = expm(a * (mpf(left[0]) - begin)) * x
            samples.append([left.pop(0), (torque * y)[0], y[0] / drive.rad,
                            y[drive.load] / drive.rad, (ref * y)[0]])
        if length is None:
            break
        count = 1 + int(length * 500)  # short pieces: the block below holds exp(-A) too
        forward, weight = van_loan(a, torque, length / count)
        for _ in range(count):
            square += (x.T * weight * x)[0]
            x = forward * x
        core = x[:base]
        begin += length
    return {"samples": samples, "rms_torque": sqrt(square / end)}


def sampled(drive, segments, cycle, delay, times):
    """Reads at k cycle, gives out `delay` later."""
    n = len(drive.bodies)
    one, u, lag = 2 * n, 2 * n + 1, 2 * n + 2
    size = 2 * n + 3
    a = matrix(size, size)
    torque = matrix(1, size)
    torque[0, lag if drive.lag else u] = 1
    if drive.lag:
        a[lag, u], a[lag, lag] = 1 / drive.lag, -1 / drive.lag
    drive.add_bodies(a, one, torque)
    cycle, delay = mpf(cycle), mpf(delay)
    end = sum(mpf(s[0]) for s in segments)

    def reference(t):
        begin = mpf(0)
        for s in segments:
            if t < begin + mpf(s[0]):
                return [derivative(s, k, (t - begin) / mpf(s[0])) for k in range(3)]
            begin += mpf(s[0])
        return [derivative(segments[-1], 0, mpf(1)), mpf(0), mpf(0)]

    events = []
    count = int(max(times) / float(cycle)) + 2
    for k in range(count):
        events += [(k * cycle, 0, k), (k * cycle + delay, 1, k)]  # reading before giving
    events += [(mpf(t), 3, t) for t in times] + [(end, 2, 0)]
    events.sort(key=lambda e: (e[0], e[1]))
    x = matrix(size, 1)
    x[one] = 1
    angles, held = drive.rest()
    for i in range(n):
        x[i] = drive.rad * reference(mpf(0))[0] + angles[i]
    x[u] = x[lag] = held
    z = held if drive.ti else mpf(0)
    now, before, square, commands, samples, cache = mpf(0), None, mpf(0), [], [], {}
    for when, kind, what in events:
        step = when - now
        if step > 0:
            key = mp.nstr(step, 25)
            if key not in cache:
                cache[key] = van_loan(a, torque, step)
            forward, weight = cache[key]
            if when <= end:
                square += (x.T * weight * x)[0]
            x = forward * x
            now = when
        if kind == 0:
            r = reference(when)
            speed = (x[0] - before) / cycle if before is not None else mpf(0)
            before = x[0]
            e = drive.kp * (drive.rad * r[0] - x[0]) + drive.kff * drive.rad * r[1] - speed
            commands.append(drive.kv * e + z + drive.rad * (drive.ktff * drive.inertia * r[2]
                                                            + drive.kfff * drive.friction * r[1]))
            z += drive.kv * e * cycle / drive.ti if drive.ti else 0
        elif kind == 1:
            x[u] = commands[what]
        elif kind == 3:
            samples.append([what, (torque * x)[0], x[0] / drive.rad, x[drive.load] / drive.rad,
                            reference(when)[0]])
    return {"samples": samples, "rms_torque": sqrt(square / end)}


def trapezoid():  # 3600 degrees at 9000 and 60000
    return [(mpf("0.15"), [0, 0, 675], []), (mpf("0.25"), [675, 2250], []),
            (mpf("0.15"), [2925, 1350, -675], [])]


def s_curve():
    """Jerk 2e6, acceleration 60000, velocity 9000: 0.03, 0.12, 0.03 s, then a line to 3600."""
    pieces, r = [], [mpf(0)] * 3
    line = mpf("0.22")
    for length, jerk in ((".03", 2e6), (".12", 0), (".03", -2e6), (line, 0), (".03", -2e6),
                         (".12", 0), (".03", 2e6)):
        t, j = mpf(length), mpf(jerk)
        pieces.append((t, [r[0], r[1] * t, r[2] * t ** 2 / 2, j * t ** 3 / 6], []))
        r = [r[0] + r[1] * t + r[2] * t ** 2 / 2 + j * t ** 3 / 6, r[1] + r[2] * t + j * t ** 2 / 2,
             r[2] + j * t]
    return pieces


def cycloid():  # 720 degrees in 0.2 s
    return [(mpf("0.2"), [0, 720], [(-360 / pi, 2 * pi, mpf(0))])]


def law_4567():
    return [(mpf("0.3"), [0, 0, 0, 0, 35 * 1800, -84 * 1800, 70 * 1800, -20 * 1800], [])]


def pendulum(share, frequency, damping, inertia):
    """Body hung from a mass, and what is left of the mass."""
    j, w = mpf(share) * mpf(inertia), 2 * pi * mpf(frequency)
    return (j, 0, 0, j * w * w, 2 * mpf(damping) * j * w), mpf(inertia) - j


def drives():
    two = [("4e-5", "1e-4", 0, 0, 0), ("2e-4", "1e-4", 0, 50, "5e-3")]
    four = [("4e-5", "1e-4", 0, 0, 0), ("5e-5", 0, 0, 400, "1e-3"), ("1e-4", "1e-4", "0.1", 120, "2e-3"),
            ("5e-5", 0, 0, 200, "1e-3")]
    hung, rest = pendulum("0.3", 4, "0.01", "2e-4")
    slosh = [two[0], (rest, "1e-4", 0, 50, "5e-3"), hung]
    rigid = [("2.4e-4", "2e-4", "0.05", 0, 0)]
    gains = {"kp": 40, "kv": "0.05", "ti": "0.02", "kff": 1, "ktff": 1}
    return {
        "two_mass": Drive(two, **gains),
        "four_mass": Drive(four, 60, "0.08", "0.03", "0.9", "0.8", "0.5", "1e-4"),
        "lagging": Drive([two[0], ("2e-4", "1e-4", "0.1", 50, "5e-3")], 40, "0.05", "0.02", "0.9", "0.8",
                         "0.5", "2e-4"),
        "pendulum": Drive(slosh, load=1, **gains),
        "rigid": Drive(rigid, 100, "0.1", 0, 1, "0.5"),
    }


def plain(value):
    if isinstance(value, dict):
        return {k: plain(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(v) for v in value]
    return float(value) if not isinstance(value, (str, int)) else value


def main():
    references = {"trapezoid": trapezoid(), "s_curve": s_curve(), "cycloid": cycloid(),
                  "law_4567": law_4567()}
    times = [0.0031, 0.0501, 0.1234, 0.1611, 0.29062, 0.4101, 0.5201, 0.6001, 0.7501]
    cases = []
    for drive, model in drives().items():
        for reference, segments in references.items():
            if drive != "two_mass" and reference not in ("trapezoid", "cycloid"):
                continue
            found = continuous(model, segments, times)
            cases.append({"drive": drive, "reference": reference, "cycle": 0, "delay": 0, **found})
    for drive, cycle, delay in (("two_mass", 0.00025, 0.0), ("lagging", 0.00025, 0.0003),
                                ("pendulum", 0.00025, 0.00025), ("rigid", 0.0005, 0.000625)):
        found = sampled(drives()[drive], references["s_curve"], cycle, delay, times)
        cases.append({"drive": drive, "reference": "s_curve", "cycle": cycle, "delay": delay, **found})
    print(json.dumps({"references": plain(references), "cases": plain(cases)}, indent=1))


if __name__ == "__main__":
    main()
