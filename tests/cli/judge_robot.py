#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""judge_robot.py ROBOT GROUP.csv JOINT.csv...: checks every tick of a group of joints.

In every tick in which the joints follow the group, they keep their range, velocity, acceleration and
jerk; with the first word `stops`, acceleration and jerk may be twice as high (the stop limits). The
tool, by forward kinematics from the joints, is on the requested lines, within the deviation of their
corners. Shares no code with Jounce.
"""
import math
import sys

from tick_log import rows

DT = 1e-3

# range, velocity, acceleration, jerk of each joint
SCARA = [((-130, 130), 200, 1500, 30000), ((5, 155), 300, 2500, 50000), ((-10, 150), 400, 4000, 80000)]
DELTA = [((100, 450), 1200, 15000, 500000)] * 3
GANTRY = [((-60, 600), 500, 3000, 60000)] * 3 + [((-60, 600), 150, 1500, 60000)]


def scara_tool(a0, a1, z):
    a, b = math.radians(a0), math.radians(a0 + a1)
    return (300 * math.cos(a) + 250 * math.cos(b), 300 * math.sin(a) + 250 * math.sin(b), z)


def delta_tool(*heights):
    """Newton's method on the lengths of the three arms of 320 mm, from below the carriages."""
    ends = [(160 * math.cos(math.radians(90 + 120 * i)), 160 * math.sin(math.radians(90 + 120 * i)), h)
            for i, h in enumerate(heights)]
    p = [0.0, 0.0, min(heights) - math.sqrt(320**2 - 160**2)]
    for _ in range(50):
        f = [sum((p[k] - e[k])**2 for k in range(3)) - 320**2 for e in ends]
        j = [[2 * (p[k] - e[k]) for k in range(3)] for e in ends]
        step = solve(j, f)
        p = [p[k] - step[k] for k in range(3)]
        if max(map(abs, step)) < 1e-13:
            break
    return tuple(p)


def solve(m, v):
    """Cramer's rule for three unknowns."""
    def det(a):
        return (a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0])
                + a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]))
    d = det(m)
    return [det([[v[r] if c == k else m[r][c] for c in range(3)] for r in range(3)]) / d for k in range(3)]


def gantry_tool(x, y1, y2, z):
    assert abs(y1 - y2) < 1e-12, ("the beam is skewed", y1, y2)
    return (x, y1, z)


# The jogs of limits_in_namespace.sh: along x until the joint a1 is at 5 deg, along -y as far as that, and
# along -x.
FARTHEST = math.sqrt(300**2 + 250**2 + 2 * 300 * 250 * math.cos(math.radians(5)))
X = math.sqrt(FARTHEST**2 - 250**2)
JOGS = [(300, 250, 0), (X, 250, 0), (X, -250, 0), (-X, -250, 0)]

# tool, limits of the joints, the requested corners, the deviation at a corner
ROBOTS = {
    "jogs": (scara_tool, SCARA, JOGS, 1e-6),
    "scara": (scara_tool, SCARA,
              [(300, 250, 0), (300, 250, 60), (420, -100, 60), (420, -100, 0)], 5),
    "delta": (delta_tool, DELTA, None, 3),
    "gantry": (gantry_tool, GANTRY, None, math.inf),
}


def distance(p, corners):
    best = math.inf
    for a, b in zip(corners, corners[1:]):
        length2 = sum((b[k] - a[k])**2 for k in range(3))
        t = sum((p[k] - a[k]) * (b[k] - a[k]) for k in range(3)) / length2
        t = min(max(t, 0), 1)
        best = min(best, math.dist(p, [a[k] + t * (b[k] - a[k]) for k in range(3)]))
    return best


def main(words):
    factor = 2 if words[0] == "stops" else 1
    if words[0] == "stops":
        words = words[1:]
    tool, limits, corners, deviation = ROBOTS[words[0]]
    if words[0] == "delta":  # the corners of the test, in the frame x 20, y -10, 30 deg
        turn = math.radians(30)
        corners = [(0, 0, 0)] + [
            (20 + x * math.cos(turn) - y * math.sin(turn), -10 + x * math.sin(turn) + y * math.cos(turn), z)
            for x, y, z in [(0, 0, 40), (60, 0, 40), (60, 40, 10), (-40, 40, 10)]]
    group, *joints = [dict(rows(path)) for path in words[1:]]
    judged = on_path = 0
    farthest = 0.0
    for tick, now in group.items():
        pairs = [(log.get(tick - 1), log.get(tick)) for log in joints]
        if any(a is None or b is None for a, b in pairs):
            continue
        if any({a["state"], b["state"]} != {"synchronized_motion"} for a, b in pairs):
            continue
        for k, (a, b) in enumerate(pairs):
            (low, high), velocity, acceleration, jerk = limits[k]
            p, v0, v1, a0, a1 = (float(b["position"]), float(a["velocity"]), float(b["velocity"]),
                                 float(a["acceleration"]), float(b["acceleration"]))
            near = 1 + 1e-9
            assert low - 1e-9 <= p <= high + 1e-9, (k, tick, "range", p)
            assert abs(v1) <= velocity * near, (k, tick, "velocity", v1)
            assert abs(a1) <= factor * acceleration * near, (k, tick, "acceleration", a1)
            assert abs(v1 - v0) <= factor * acceleration * DT * near, (k, tick, "velocity step", v0, v1)
            assert abs(a1 - a0) <= factor * jerk * DT * near + 1e-9, (k, tick, "acceleration step", a0, a1)
            way = p - float(a["position"])
            assert abs(way - (v0 + v1) / 2 * DT) <= factor * jerk * DT**3 / 6 + 1e-9, (k, tick, "way", way)
        judged += 1
        at = tool(*(float(b["position"]) for _, b in pairs))
        if corners and now["state"] == "discrete_motion":
            away = distance(at, corners)
            farthest = max(farthest, away)
            assert away <= deviation + 1e-6, (tick, "off the path", at, away)
            on_path += 1
    assert judged > 300, judged
    print(f"{judged} ticks within the limits of the joints, {on_path} on the path, at most {farthest:.6g} from it")


if __name__ == "__main__":
    main(sys.argv[1:])
