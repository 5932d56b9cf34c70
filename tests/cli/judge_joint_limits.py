#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""judge_joint_limits.py GROUP.csv A0.csv A1.csv Z.csv: checks a SCARA whose second line has lower limits of a joint.

The tool follows three lines with rounded corners. On the second line and on its corners, the joint a0
keeps the lower limits; on the other lines it is faster. It has only these limits and the geometry.
Shares no code with Jounce.
"""
import math
import sys

from judge_robot import DT, distance, scara_tool
from tick_log import rows

CORNERS = [(300, 250, 0), (350, 150, 0), (420, 0, 0), (300, -200, 0)]
DEVIATION = 3
VELOCITY, ACCELERATION, JERK = 12, 100, 1500  # limits of a0 on the second line


def main(group_log, *joint_logs):
    group, *joints = [dict(rows(path)) for path in (group_log, *joint_logs)]
    slow = fast = 0
    peaks = [0.0, 0.0]  # greatest velocity of a0: on the first and the last line, on the second
    for tick in group:
        now = [log.get(tick) for log in joints]
        was = joints[0].get(tick - 1)
        if was is None or any(one is None for one in now):
            continue
        if {was["state"], now[0]["state"]} != {"synchronized_motion"}:
            continue
        tool = scara_tool(*(float(one["position"]) for one in now))
        away = distance(tool, CORNERS)
        assert away <= DEVIATION + 1e-6, (tick, "off the path", tool, away)
        v0, v1, a0, a1 = (float(one[key]) for key in ("velocity", "acceleration") for one in (was, now[0]))
        if min(distance(tool, CORNERS[:2]), distance(tool, CORNERS[2:])) <= 1e-6:
            fast += 1
            peaks[0] = max(peaks[0], abs(v1))
            continue
        before = scara_tool(*(float(log[tick - 1]["position"]) for log in joints))
        if min(distance(before, CORNERS[:2]), distance(before, CORNERS[2:])) <= 1e-6:
            continue  # the limits begin within this cycle
        slow += 1
        peaks[1] = max(peaks[1], abs(v1))
        near = 1 + 1e-9
        assert abs(v1) <= VELOCITY * near, (tick, "velocity", v1)
        assert abs(a1) <= ACCELERATION * near, (tick, "acceleration", a1)
        assert abs(v1 - v0) <= ACCELERATION * DT * near, (tick, "velocity step", v0, v1)
        assert abs(a1 - a0) <= JERK * DT * near + 1e-9, (tick, "acceleration step", a0, a1)
    assert slow > 500 and fast > 500, ("cycles", slow, fast)
    assert peaks[0] > 1.5 * VELOCITY, ("the other lines are as slow", peaks)
    assert peaks[1] > 0.95 * VELOCITY, ("the limit does not decide", peaks)
    print(f"{slow} cycles within the limits of a0 (peak {peaks[1]:.6g} deg/s), {fast} without (peak {peaks[0]:.6g} deg/s)")


if __name__ == "__main__":
    main(*sys.argv[1:])
