# SPDX-License-Identifier: Apache-2.0
"""Random programs of lines and arcs that must be planned, with limits of their own for each axis."""
import math
import random

from paths.gcode import arc, gcode, job, line


def quarter(start, rng, feed):
    """An arc of one to four quarter turns about a center beside the start: exact in decimals."""
    radius, side, turns = round(rng.uniform(0.01, 50), 3), rng.randrange(4), rng.randrange(1, 5)
    ray = [(1, 0), (0, 1), (-1, 0), (0, -1)]
    clockwise = rng.random() < 0.5
    center = [round(c - radius * x, 12) for c, x in zip(start, ray[side])]
    end = [round(c + radius * x, 12) for c, x in zip(center, ray[(side + (-turns if clockwise else turns)) % 4])]
    climb = [round(z + (rng.uniform(-20, 20) if rng.random() < 0.3 else 0), 3) for z in start[2:]]
    return arc(end + climb, center, clockwise, **feed)


def next_line(start, before, rng, feed):
    """A line, mostly to anywhere; now and then to the same place, back, straight on, a little aside, or a tiny step.

    `before`: the start of the line that ended at `start`, or None.
    """
    kind, scale = rng.random(), 10 ** rng.uniform(-3, 2)
    if kind < 0.05:
        return line(start, **feed)
    if before is not None and kind < 0.2:
        way = [a - b for a, b in zip(start, before)]
        size = math.hypot(*way)
        if size > 0:
            factor = -1.0 if kind < 0.1 else rng.uniform(0.1, 3)
            aside = [rng.uniform(-1e-6, 1e-6) if kind > 0.15 else 0.0 for _ in way]
            return line([round(a + factor * d + e, 9) for a, d, e in zip(start, way, aside)], **feed)
    if kind < 0.25:
        scale = 1e-6
    return line([round(c + scale * rng.uniform(-1, 1), 6) for c in start], **feed)


def random_program(seed):
    """Text and job. The same seed gives the same program everywhere."""
    rng = random.Random(seed)
    axes = rng.choice((2, 3))
    start = [round(rng.uniform(-100, 100), 3) for _ in range(axes)]
    at, before, pieces = start, None, []
    for _ in range(rng.randrange(1, 14)):
        feed = {"feed": round(rng.uniform(10, 300), 1)} if rng.random() < 0.3 else {"feed": 100.0}
        piece = quarter(at, rng, feed) if rng.random() < 0.3 else next_line(at, before, rng, feed)
        pieces.append(piece)
        at, before = piece["to"], at if piece["type"] == "line" else None
    deviation = 0 if rng.random() < 0.15 else float(f"{10 ** rng.uniform(-4, 0.5):.3g}")
    text, numbered = gcode(start, pieces, deviation)
    geometry = job(start, numbered, deviation, max(p["feed"] for p in pieces))
    for axis in geometry["axes"]:
        axis.update(velocity=round(rng.uniform(50, 300), 1), acceleration=float(round(rng.uniform(300, 5000))),
                    jerk=float(round(rng.uniform(3000, 100000))))
        if rng.random() < 0.3:
            axis["deceleration"] = float(round(rng.uniform(300, 5000)))
    return text, geometry
