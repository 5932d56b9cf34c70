# SPDX-License-Identifier: Apache-2.0
"""Benchmark paths by formula, as points; coordinates in mm, rounded to 1e-6."""
import math
import random


def rounded(points):
    return [[round(c, 6) + 0.0 for c in p] for p in points]


def square(side=100):
    return [[0, 0], [side, 0], [side, side], [0, side], [0, 0]]


def cut_line(length=200, pieces=2000):
    return [[length * i / pieces, 0] for i in range(pieces + 1)]


def chord_circle(radius=50, chord=0.5):
    n = round(2 * math.pi * radius / chord)
    return [[radius * math.cos(2 * math.pi * i / n), radius * math.sin(2 * math.pi * i / n)] for i in range(n + 1)]


def zigzag(leg=5, corners=40):
    """Stairs: legs along x and y in turn, each corner 90 degrees."""
    points = [[0, 0]]
    for i in range(corners + 1):
        x, y = points[-1]
        points.append([x + leg, y] if i % 2 == 0 else [x, y + leg])
    return points


def hilbert(order=5, step=2):
    """Hilbert's curve by the L-system A -> -BF+AFA+FB-, B -> +AF-BFB-FA+."""
    word = "A"
    for _ in range(order):
        word = "".join({"A": "-BF+AFA+FB-", "B": "+AF-BFB-FA+"}.get(c, c) for c in word)
    points, heading = [[0, 0]], (1, 0)
    for c in word:
        if c == "F":
            points.append([points[-1][0] + step * heading[0], points[-1][1] + step * heading[1]])
        elif c in "+-":
            heading = (-heading[1], heading[0]) if c == "+" else (heading[1], -heading[0])
    return points


def fay(t, scale=20):
    """Fay's butterfly, first turn."""
    r = scale * (math.exp(math.sin(t)) - 2 * math.cos(4 * t) + math.sin((2 * t - math.pi) / 24) ** 5)
    return [r * math.sin(t), r * math.cos(t)]


def butterfly(chord=0.2):
    """The butterfly in chords of equal length; the last one is what remains."""
    points, t = [fay(0)], 0.0
    while True:
        low, high = t, t + 0.02
        while math.dist(fay(high), points[-1]) < chord:
            low, high = high, high + 0.02
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if math.dist(fay(middle), points[-1]) < chord else (low, middle)
        if high >= 2 * math.pi:
            return points + [fay(2 * math.pi)]
        t = high
        points.append(fay(t))


def random_walk(steps=10000, seed=23):
    """Steps of 0.2 to 2 mm, each turned by less than 90 degrees from the one before, in three axes."""
    rng, points, heading, climb = random.Random(seed), [[0, 0, 0]], 0.0, 0.0
    for _ in range(steps):
        heading += math.radians(90) * (2 * rng.random() - 1)
        climb = 0.3 * (2 * rng.random() - 1)
        step = 0.2 + 1.8 * rng.random()
        x, y, z = points[-1]
        points.append([x + step * math.cos(heading), y + step * math.sin(heading), z + step * climb])
    return points


def benchmarks():
    """Polylines by name."""
    return {name: rounded(make()) for name, make in (
        ("square", square), ("cut_line", cut_line), ("zigzag", zigzag), ("hilbert", hilbert),
        ("chord_circle", chord_circle), ("butterfly", butterfly), ("random_walk", random_walk))}


def legs(points, merged=False):
    """Length and unit vector of each leg. Merged: successive legs of one direction, to 1e-9 rad, are one."""
    out = []
    for a, b in zip(points, points[1:]):
        length = math.dist(a, b)
        if length == 0:
            continue
        direction = [(y - x) / length for x, y in zip(a, b)]
        if merged and out and math.dist(out[-1][1], direction) < 1e-9:
            out[-1] = (out[-1][0] + length, out[-1][1])
        else:
            out.append((length, direction))
    return out
