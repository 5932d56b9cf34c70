#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/pictures/encoder-master.svg: the velocity of a master by differences and by the filter.

usage: master_picture.py > docs/pictures/encoder-master.svg
       master_picture.py --numbers        the table of docs/executor/masters.md

An implementation of its own of what axis/src/follow/tracker.cpp derives, (1) to (5); standard library alone.
"""
import random
import sys
from math import exp, floor, sqrt

H = 1e-3  # s
COUNT = 50e-6  # m: 4000 counts a turn of 0.2 m


def gains(order, time_constant):
    t = exp(-H / time_constant)
    if order == 2:
        return 1 - t**2, (1 - t) ** 2, 0
    return 1 - t**3, 1.5 * (1 - t) ** 2 * (1 + t), (1 - t) ** 3 / 2


def estimates(measured, order, time_constant):
    a_gain, b_gain, c_gain = gains(order, time_constant)
    x, v, a = measured[0], (measured[1] - measured[0]) / H, 0.0
    for z in measured:
        x += v * H + a * H * H / 2
        v += a * H
        r = z - x
        x += a_gain * r
        v += b_gain * r / H
        a += 2 * c_gain * r / H**2
        yield x, v


def rms(values):
    return sqrt(sum(e * e for e in values) / len(values))


def numbers():
    draw = random.Random(1)
    noise = [draw.gauss(0, 10e-6) for _ in range(100000)]
    print("| order | time_constant | position, rms | velocity, rms | lag at 20 m/s^2 | of the velocity |")
    print("|---|---|---|---|---|---|")
    for order in (2, 3):
        for tc in (2e-3, 5e-3, 10e-3, 20e-3):
            noisy = list(estimates(noise, order, tc))[2000:]
            ramp = [10 * (i * H) ** 2 for i in range(2000)]
            x, v = list(estimates(ramp, order, tc))[-1]
            lag = (ramp[-1] - x, 20 * 1999 * H - v)
            print(f"| {order} | {tc * 1e3:g} ms | {rms([e[0] for e in noisy]) * 1e6:.2f} um | "
                  f"{rms([e[1] for e in noisy]) * 1e3:.2f} mm/s | {abs(lag[0]) * 1e6:.1f} um | "
                  f"{abs(lag[1]) * 1e3:.1f} mm/s |")


def truth(t):
    """A line that speeds up from 0.813 to 1.213 m/s in 0.1 s."""
    s = min(max(t - 0.15, 0), 0.1)
    return 0.813 * t + 2 * s * s + 0.4 * max(t - 0.25, 0)


def picture():
    draw = random.Random(2)
    measured = [floor((truth(i * H) + draw.gauss(0, 5e-6)) / COUNT + 0.5) * COUNT for i in range(-200, 400)]
    raw = [(measured[i] - measured[i - 1]) / H for i in range(1, 600)]
    curves = [("by differences", "#bbb", 0.8, raw),
              ("order 2", "#c0392b", 1.6, [v for _, v in estimates(measured, 2, 5e-3)][1:]),
              ("order 3", "#1f5fa8", 1.6, [v for _, v in estimates(measured, 3, 10e-3)][1:])]
    width, height, left, top, right, bottom = 640, 360, 56, 24, 20, 48
    at = lambda i, v: (left + (width - left - right) * i / 399,
                       height - bottom - (height - top - bottom) * (v - 0.7) / 0.6)
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
          'font-family="sans-serif" font-size="12">')
    print('<title>Velocity of an encoder master: by differences, and by the filter</title>')
    print(f'<rect width="{width}" height="{height}" fill="white"/>')
    for v in (0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.3):
        y = at(0, v)[1]
        print(f'<path d="M{left} {y:.1f}H{width - right}" stroke="#eee"/>'
              f'<text x="{left - 6}" y="{y + 4:.1f}" text-anchor="end">{v}</text>')
    for i in range(0, 400, 100):
        print(f'<text x="{at(i, 0)[0]:.1f}" y="{height - bottom + 18}" text-anchor="middle">{i}</text>')
    print(f'<text x="{width - right}" y="{height - 10}" text-anchor="end">ms</text>'
          f'<text x="{left}" y="16">m/s: 50 um per count, 5 um of noise, read at 1 kHz</text>')
    for k, (name, color, stroke, values) in enumerate(curves):
        points = " ".join("{:.1f},{:.1f}".format(*at(i, v)) for i, v in enumerate(values[199:]))
        print(f'<polyline points="{points}" fill="none" stroke="{color}" stroke-width="{stroke}"/>'
              f'<text x="{width - right - 4}" y="{height - bottom - 12 - 16 * k}" text-anchor="end" '
              f'fill="{"#777" if k == 0 else color}">{name}</text>')
    print("</svg>")


numbers() if "--numbers" in sys.argv else picture()
