#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints a lower bound of the time in which any motion follows the Hilbert curve of docs/path/speed.md.

The motion stays within e of the lines, passes each corner within e, and keeps the velocity V and the acceleration A of
each axis. Its jerk is not limited, and its path is free.

Take a leg from s = 0 to s = L along one axis. Its window is the time from the last instant with |s| <= e to the first one
with |s - L| <= e. The windows of all legs are disjoint, because each leg is perpendicular to its neighbors. In the window
of the leg before it, of at least the time T', this axis moves by at most 2 e. So at some instant of that window its
speed is at most w = 2 e / T', at a place s >= -e, and afterwards v^2 <= w^2 + 2 A (s + e). The same holds from the other
end. So the window lasts at least the integral of ds / v over [e, L - e] with

    v = min(V, sqrt(w^2 + 2 A (s + e)), sqrt(w'^2 + 2 A (L - s + e))).

It begins with T' = (L - 2 e) / V, which holds for any motion, and takes each result as the next T'. At the start and at
the end of the path the motion rests, so there w = 0, s >= 0, and the window reaches up to the point itself.
"""
import math

from paths.formulas import hilbert, legs

A, V, DEVIATION = 1000.0, 100.0, 0.05
LINUXCNC_S_CURVE = 154.2  # s, measured; docs/path/speed.md


def half(near, far, w, offset):
    """The integral of ds / v from near to far, v^2 = w^2 + 2 A (s + offset), at most V."""
    capped = min(max((V * V - w * w) / (2 * A) - offset, near), far)
    speed = lambda s: math.sqrt(w * w + 2 * A * (s + offset))
    return (speed(capped) - speed(near)) / A + (far - capped) / V


def window(length, e, before, after):
    """Least time of a leg. before, after: w of its ends; None at a rest."""
    (w0, o0), (w1, o1) = [(0.0, 0.0) if w is None else (w, e) for w in (before, after)]
    low, high = o0, length - o1
    middle = min(max(((w1 * w1 - w0 * w0) / (2 * A) + length + o1 - o0) / 2, low), high)
    return half(low, middle, w0, o0) + half(length - high, length - middle, w1, o1)


def least_time(lengths, e):
    times = [(length - 2 * e) / V for length in lengths]
    for _ in range(20):
        w = [None, *[2 * e / t for t in times], None]
        times = [window(length, e, w[k], w[k + 2]) for k, length in enumerate(lengths)]
    return sum(times)


def main():
    lengths = [length for length, _ in legs(hilbert(), True)]
    w, steps = 1.5, 100000  # the closed form against the midpoint rule
    places = (0.05 + 1.9 * (i + 0.5) / steps for i in range(steps))
    sums = sum(1.9 / steps / math.sqrt(w * w + 2 * A * (min(s, 2 - s) + 0.05)) for s in places)
    assert abs(window(2.0, 0.05, w, w) / sums - 1) < 1e-9, (window(2.0, 0.05, w, w), sums)
    least = least_time(lengths, DEVIATION)
    print(f"deviation {DEVIATION} mm: {len(lengths)} legs, at least {least:.2f} s; the S-curve of LinuxCNC takes at most "
          f"{LINUXCNC_S_CURVE / least:.2f} times as long")


if __name__ == "__main__":
    main()
