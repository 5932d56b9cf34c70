#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""judge_compensation.py LOG.x.csv LOG.y.csv: checks every tick of examples/compensated-table.

While a compensation is active, the drive receives the setpoint plus the correction of the tables below, interpolated here:
a natural spline for x, straight lines for y. The drive never moves further in a tick than the velocity limit of the axis
and the slope of its table permit, also when the compensation is switched on and off, and it stands still while the axis is
disabled. Shares no code with Jounce."""
import csv
import sys

DT = 1e-3
SCREW = [-0.2, 0.1, -0.3, 0.4, -0.1]  # at -100, 100, ... 700
PLATE = [[0.3, 0.1, -0.4], [-0.4, 0, 0.2], [0.2, -0.1, 0.5]]  # [y][x], at -100, 100, 300 and -100, 0, 100
VELOCITY = {"x": 500, "y": 300}


def natural_spline(values):
    """The second derivatives at the points, in units of the interval: M0 = Mn = 0, Mi-1 + 4 Mi + Mi+1 = 6 second differences."""
    n = len(values)
    m = [0.0] * n
    diagonal, right = [4.0] * n, [0.0] * n
    for i in range(1, n - 1):
        right[i] = 6 * (values[i - 1] - 2 * values[i] + values[i + 1])
    for i in range(2, n - 1):  # Thomas
        factor = 1 / diagonal[i - 1]
        diagonal[i] -= factor
        right[i] -= factor * right[i - 1]
    for i in range(n - 2, 0, -1):
        m[i] = (right[i] - (m[i + 1] if i + 1 < n - 1 else 0)) / diagonal[i]
    return m


CURVED = natural_spline(SCREW)


def of_x(x):
    s = min(max((x + 100) / 200, 0), 4)
    i = min(int(s), 3)
    b = s - i
    a = 1 - b
    return (a * SCREW[i] + b * SCREW[i + 1] + ((a ** 3 - a) * CURVED[i] + (b ** 3 - b) * CURVED[i + 1]) / 6)


def of_y(x, y):
    s, t = min(max((x + 100) / 200, 0), 2), min(max((y + 100) / 100, 0), 2)
    i, j = min(int(s), 1), min(int(t), 1)
    u, w = s - i, t - j
    row = [(1 - u) * PLATE[k][i] + u * PLATE[k][i + 1] for k in (j, j + 1)]
    return (1 - w) * row[0] + w * row[1]


def rows(path):
    with open(path, newline="") as file:
        reader = csv.reader(file)
        names = [name.split(" ")[0] for name in next(reader)]
        return {int(one["tick"]): {k: v if k in ("state", "fault") else float(v or "nan") for k, v in one.items()
                                   if k in ("tick", "state", "fault", "position", "velocity", "compensated",
                                            "compensation", "drive_position")}
                for one in (dict(zip(names, row)) for row in reader)}


def main(x_log, y_log):
    logs = {"x": rows(x_log), "y": rows(y_log)}
    judged, switched, moved = 0, 0, 0
    # y moves by the slope along x, too: 0.6 per 200 mm of x at 500 mm/s; its own slope is below 0.01.
    most = {"x": 500 * 1.01 * DT, "y": (300 * 1.01 + 500 * 0.6 / 200) * DT}
    for name, log in logs.items():
        for tick, now in log.items():
            assert now["fault"] == "none", (name, tick, now["fault"])
            other = logs["x"].get(tick)
            if other is None:
                continue
            expected = 0.0
            if now["compensated"]:
                expected = of_x(now["position"]) if name == "x" else of_y(other["position"], now["position"])
            assert abs(now["compensation"] - expected) < 1e-9, (name, tick, now["compensation"], expected)
            judged += now["compensated"] == 1
            before = log.get(tick - 1)
            if before is None:
                continue
            step = now["drive_position"] - before["drive_position"]
            assert abs(step) <= most[name], (name, tick, "the drive steps", step)
            if "disabled" in (now["state"], before["state"]) and now["state"] == before["state"]:
                assert abs(step) < 1e-9, (name, tick, "the drive moves while the axis is disabled", step)
            switched += now["compensated"] != before["compensated"]
            moved += now["compensated"] == 1 and now["velocity"] != 0
    assert judged > 5000 and moved > 2000, (judged, moved)
    assert switched == 3, switched
    print(f"{judged} corrected ticks, {moved} of them in motion; {switched} switches without a step")


main(*sys.argv[1:])
