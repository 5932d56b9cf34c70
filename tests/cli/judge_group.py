#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""judge_group.py LOG.x.csv LOG.y.csv LOG.group.csv FIRST LAST: checks every tick of a group of the
axes x and y.

While the axes follow the group, they keep the stop limits: velocity 200, acceleration 4000 and jerk
100000. In the ticks FIRST to LAST, they keep the limits: acceleration 2000 and jerk 50000; and both
are on the requested path (lines and an arc, below), within the deviation of its corners, and come
along each line and the arc. Shares no code with Jounce.
"""
import math
import sys

from tick_log import rows

DT = 1e-3
VELOCITY, ACCELERATION, JERK = 200, 2000, 50000
LINES = [((0, 0), (20, 10)), ((20, 10), (40, 10)), ((40, 30), (0, 30)), ((0, 30), (0, 0))]
ARC = ((40, 20), 10)  # center and radius, from (40, 10) to (40, 30)
DEVIATION = 1.0


def distances(p):
    """The distances of a point from the arc and the lines of the requested path."""
    yield abs(math.dist(p, ARC[0]) - ARC[1]) if p[0] >= ARC[0][0] else math.inf
    for a, b in LINES:
        length2 = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2
        t = ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / length2
        t = min(max(t, 0), 1)
        yield math.dist(p, (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))


def main(x_log, y_log, group_log, first, last):
    x, y, group = (dict(rows(path)) for path in (x_log, y_log, group_log))
    judged = 0
    on_path = [0] * (1 + len(LINES))  # ticks along each part
    for tick, now in group.items():
        before = group.get(tick - 1)
        if before is None:
            continue
        factor = 1 if first <= tick <= last else 2
        for name, log in (("x", x), ("y", y)):
            a, b = log.get(tick - 1), log.get(tick)
            if a is None or b is None or {a["state"], b["state"]} != {"synchronized_motion"}:
                continue
            v0, v1 = float(a["velocity"]), float(b["velocity"])
            a0, a1 = float(a["acceleration"]), float(b["acceleration"])
            near = 1 + 1e-9
            assert abs(v1) <= VELOCITY * near, (name, tick, "velocity", v1)
            assert abs(a1) <= factor * ACCELERATION * near, (name, tick, "acceleration", a1)
            assert abs(v1 - v0) <= factor * ACCELERATION * DT * near, (name, tick, "velocity step", v0, v1)
            assert abs(a1 - a0) <= factor * JERK * DT * near + 1e-9, (name, tick, "acceleration step", a0, a1)
            way = float(b["position"]) - float(a["position"])
            assert abs(way - (v0 + v1) / 2 * DT) <= factor * JERK * DT**3 / 6 + 1e-9, (name, tick, "way", way)
            judged += 1
        if first <= tick <= last and now["state"] == "discrete_motion":
            away = list(distances((float(x[tick]["position"]), float(y[tick]["position"]))))
            assert min(away) <= DEVIATION + 1e-9, (tick, "off the path", away)
            on_path[away.index(min(away))] += 1
    assert judged > 1000 and min(on_path) > 10, (judged, on_path)
    print(f"{judged} ticks of axes within the limits, {on_path} ticks on the arc and the lines of the path")


if __name__ == "__main__":
    main(*sys.argv[1:4], int(sys.argv[4]), int(sys.argv[5]))
