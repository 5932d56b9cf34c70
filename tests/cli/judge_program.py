#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""judge_program.py LOG.x.csv LOG.y.csv LOG.group.csv: checks the outputs of program_in_namespace.sh.

The place of the axes at an edge follows from the cubics through their positions and velocities in the two
ticks around it. Each edge must be where its H word is in the program: at a corner, within its deviation
of 0.1 mm; elsewhere, within 1e-6 mm. Shares no code with Jounce.
"""
import math
import sys

from tick_log import rows

DT = 1e-3
# output, on, place, tolerance: in the order of the program
WANTED = [("+1", (0, 0), 1e-6), ("-1", (20, 0), 1e-6), ("+2", (40, 0), 0.1 + 1e-6), ("-2", (40, 40), 1e-6)]


def between(before, now, share, dt):
    p0, p1 = float(before["position"]), float(now["position"])
    v0, v1 = float(before["velocity"]) * dt, float(now["velocity"]) * dt
    way = p1 - p0
    return p0 + share * way + share * (1 - share) * ((1 - share) * (v0 - way) - share * (v1 - way))


def main(x_log, y_log, group_log):
    x, y, group = (dict(rows(path)) for path in (x_log, y_log, group_log))
    seen = []
    before = None
    for tick, now in group.items():
        for edge in now["edges"].split():
            name, delay = edge.split("@")
            dt = (tick - before) * DT  # a late cycle leaves out ticks
            share = float(delay) / dt
            assert 0 <= share < 1, (tick, edge)
            seen.append((name, tuple(between(log[before], log[tick], share, dt) for log in (x, y))))
        before = tick
    for (name, place), (wanted, at, tolerance) in zip(seen, WANTED):
        assert name == wanted, (name, wanted)
        assert math.dist(place, at) <= tolerance, (name, place, at)
    assert [name for name, _ in seen] == [name for name, _, _ in WANTED], seen
    print(f"{len(seen)} edges at the places of their words")


if __name__ == "__main__":
    main(*sys.argv[1:4])
