#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""judge_contour.py LOG.x.csv LOG.y.csv LEAST DEVIATION X,Y ...: checks every tick of two axes that follow a group
along the polygon of these corners.

In every tick, both axes keep their stop limits: velocity 200, acceleration 4000 and jerk 100000; and the place is
within DEVIATION of the polygon. At least LEAST ticks must be judged. Its input is the limits and the
polygon alone. Shares no code with Jounce.
"""
import math
import sys

from tick_log import rows

DT = 1e-3
VELOCITY, ACCELERATION, JERK = 200, 4000, 100000
NEAR = 1 + 1e-9


def distance(p, corners):
    best = math.inf
    for a, b in zip(corners, corners[1:]):
        length2 = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2
        t = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / length2
        t = min(max(t, 0), 1)
        best = min(best, math.dist(p, (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))))
    return best


def judge_step(name, tick, before, now, n):
    """`n`: ticks between both rows: a late cycle leaves out ticks."""
    p0, v0, a0 = (float(before[key]) for key in ("position", "velocity", "acceleration"))
    p1, v1, a1 = (float(now[key]) for key in ("position", "velocity", "acceleration"))
    dt = n * DT
    assert abs(v1) <= VELOCITY * NEAR, (name, tick, "velocity", v1)
    assert abs(a1) <= ACCELERATION * NEAR, (name, tick, "acceleration", a1)
    assert abs(v1 - v0) <= ACCELERATION * dt * NEAR, (name, tick, "velocity step", v0, v1)
    assert abs(a1 - a0) <= JERK * dt * NEAR + 1e-9, (name, tick, "acceleration step", a0, a1)
    way = p1 - p0 - (v0 + v1) / 2 * dt
    assert abs(way) <= JERK * dt**3 / 6 + 1e-9, (name, tick, "way", p0, p1)


def main(x_log, y_log, least, deviation, corners):
    logs = {"x": dict(rows(x_log)), "y": dict(rows(y_log))}
    judged, farthest, last = 0, 0.0, None
    for tick in logs["x"]:
        if tick not in logs["y"]:  # the log of y was truncated
            break
        now = {name: log[tick] for name, log in logs.items()}
        if last is not None and all(axis["state"] == "synchronized_motion" for axis in now.values()):
            farthest = max(farthest, distance([float(axis["position"]) for axis in now.values()], corners))
            assert farthest <= deviation, (tick, "off the path", farthest)
            before = {name: log[last] for name, log in logs.items()}
            for name, axis in now.items():
                if before[name]["state"] == axis["state"]:
                    judge_step(name, tick, before[name], axis, tick - last)
            judged += 1
        last = tick
    assert judged >= least, (judged, least)
    print(f"{judged} ticks within the limits, at most {farthest:.6g} mm from the polygon")


if __name__ == "__main__":
    main(*sys.argv[1:3], int(sys.argv[3]), float(sys.argv[4]),
         [tuple(map(float, corner.split(","))) for corner in sys.argv[5:]])
