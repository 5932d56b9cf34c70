#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""judge_limits.py GROUP.csv X.csv Y.csv TICK...: checks every tick of the plotter between the given ticks.

Each part between two ticks has its own limits of the axis x, and its own line. It has only these
limits and lines. Shares no code with Jounce.
"""
import math
import sys

from tick_log import rows

DT = 1e-3
# velocity, acceleration and jerk of x; from and to, and the least peak of the velocity of x. In the
# third part, the speed changes in motion: the stop limits apply.
PARTS = [((100, 500, 10000), (0, 0), (100, 0), 99),
         ((20, 2000, 50000), (100, 0), (80, 40), 15),
         ((40, 4000, 100000), (80, 40), (200, 40), 30),
         ((200, 2000, 50000), (200, 40), (0, 0), 140)]


def main(group_log, x_log, y_log, *ticks):
    group, x, y = (dict(rows(path)) for path in (group_log, x_log, y_log))
    near = 1 + 1e-9
    for ((velocity, acceleration, jerk), a, b, least), first, last in zip(PARTS, ticks, ticks[1:]):
        judged = 0
        fastest = 0.0
        for tick in range(first + 1, last):
            was, now = x.get(tick - 1), x.get(tick)
            if now is not None:
                fastest = max(fastest, abs(float(now["velocity"])))
            if was is None or now is None or {was["state"], now["state"]} != {"synchronized_motion"}:
                continue
            v0, v1, a0, a1 = (float(one[key]) for key in ("velocity", "acceleration") for one in (was, now))
            assert abs(v1) <= velocity * near, (tick, "velocity", v1)
            assert abs(a1) <= acceleration * near, (tick, "acceleration", a1)
            assert abs(v1 - v0) <= acceleration * DT * near, (tick, "velocity step", v0, v1)
            assert abs(a1 - a0) <= jerk * DT * near + 1e-9, (tick, "acceleration step", a0, a1)
            p = float(now["position"]), float(y[tick]["position"])
            length = math.dist(a, b)
            off = abs((p[0] - a[0]) * (b[1] - a[1]) - (p[1] - a[1]) * (b[0] - a[0])) / length
            assert off <= 1e-9, (tick, "off the line", p)
            judged += 1
        assert judged > 20, (first, last, judged)
        assert fastest >= least, (first, last, "peak of the velocity", fastest)
    print(f"{len(PARTS)} motions within their limits, on their lines")


if __name__ == "__main__":
    main(*sys.argv[1:4], *map(int, sys.argv[4:]))
