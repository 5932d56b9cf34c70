#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""judge_follow.py CASE LOG.csv [EVENTS]: checks the log of an axis that plays follow tables, and its events.

CASE names the table: 7-7 and 7-9 of the Googol manual, or forwards (7-7 with direction = 1, over a master that turns
back). Each setpoint must be on the parabolas that follow from the points of the table (manual 7.6), at the position of
the master in the log. The column `profile` must contain each begin of a table and each end of a pass, in order, at its
position of the master; its instant must be where the motion of the master in the log has this position. EVENTS is the
output of `jounce monitor --events --json`: its events must be those of the log. Shares no code with Jounce."""
import csv
import json
import re
import sys

OLD, BRIDGE, NEW = (10000, 20000, 10000), (10000, 20000, 16000), (16000, 20000, 16000)


def segment(u, length, way, begin):
    """Position and ratio at u in a segment, and the ratio at its end."""
    end = 2 * way / length - begin
    return begin * u + (end - begin) * u * u / (2 * length), begin + (end - begin) * u / length, end


def chain(ways, u, begin, length=20000):
    """Position and ratio at u in segments of this length."""
    done = 0
    for way in ways:
        if u <= length:
            p, ratio, _ = segment(u, length, way, begin)
            return done + p, ratio
        begin = segment(length, length, way, begin)[2]
        done, u = done + way, u - length
    raise AssertionError("beyond the table")


def example_7_7(m):
    """From 50000 on, without end."""
    if m <= 50000:
        return 0, 0
    n, u = divmod(m - 50000, 60000)
    p, ratio = chain(OLD, u, 0)
    return 40000 * n + p, ratio


def example_7_9(m):
    """A table, the bridge, then the last one without end."""
    if m <= 0:
        return 0, 0
    if m <= 60000:
        return chain(OLD, m, 0)
    if m <= 120000:
        p, ratio = chain(BRIDGE, m - 60000, 0)
        return 40000 + p, ratio
    n, u = divmod(m - 120000, 60000)
    p, ratio = chain(NEW, u, 0.6)
    return 86000 + 52000 * n + p, ratio


def forwards(m):
    """From 0 on, without end."""
    return example_7_7(m + 50000)


# The motion, the first events (with the table that begins, or the pass that ends, and the position of the master), and
# the position at which each later pass ends.
CASES = {
    "7-7": (example_7_7, [("table1", 50000)], lambda k: 50000 + 60000 * k),
    "7-9": (example_7_9, [("table1", 0), ("pass1", 120000), ("table2", 120000)], lambda k: 120000 + 60000 * k),
    "forwards": (forwards, [("table1", 0)], lambda k: 60000 * k),
}


def read(path):
    with open(path, newline="") as file:
        reader = csv.reader(file)
        names = [name.split(" ")[0] for name in next(reader)]
        rows = [dict(zip(names, row)) for row in reader]
    for row in rows:
        assert row["fault"] == "none", (path, row)
        for name in ("time", "master", "master_velocity", "position", "velocity"):
            row[name] = float(row[name])
        row["tick"] = int(row["tick"])
    return rows


def check_motion(case, rows):
    exact = CASES[case][0]
    furthest, judged = float("-inf"), 0
    for row in (one for one in rows if one["state"] == "synchronized_motion"):
        m, speed = row["master"], row["master_velocity"]
        held = case == "forwards" and (m < furthest or speed < 0)
        furthest = max(furthest, m)
        want, ratio = exact(furthest if case == "forwards" else m)
        assert abs(row["position"] - want) < 1e-4, (case, row, want)
        assert abs(row["velocity"] - (0 if held else ratio * speed)) < 0.02, (case, row, ratio)
        judged += 1
    assert judged > 100, (case, judged)
    return judged


def master_at(before, now, t):
    """The cubic through both ticks, which is exact for a constant acceleration."""
    dt = now["time"] - before["time"]
    s = (t - before["time"]) / dt
    way = now["master"] - before["master"]
    a, b = before["master_velocity"] * dt - way, way - now["master_velocity"] * dt
    return before["master"] + s * way + s * (1 - s) * ((1 - s) * a + s * b)


def check_events(case, rows):
    seen = []
    for before, now in zip(rows, rows[1:]):
        for word in now["profile"].split():
            what, age, master = re.fullmatch(r"(\w+)@(.+)=(.+)", word).groups()
            age, master = float(age), float(master)
            assert 0 <= age <= now["time"] - before["time"] + 1e-12, (case, now["tick"], word)
            found = master_at(before, now, now["time"] - age)
            assert abs(found - master) < 1e-3, (case, now["tick"], word, found)
            seen.append((what, master, now["tick"]))
    first, later = CASES[case][1], CASES[case][2]
    want = list(first)
    want += [(f"pass{k}", later(k)) for k in range(1, len(seen) - len(first) + 1)]
    assert [what for what, _, _ in seen] == [what for what, _ in want], (case, seen)
    for (_, master, _), (_, place) in zip(seen, want):
        assert abs(master - place) < 1e-6 * max(1, abs(place)), (case, seen)
    furthest = max(row["master"] for row in rows if row["state"] == "synchronized_motion")
    passed = len(want) - len(first)
    assert passed == int((furthest - later(0)) // 60000) and passed > 0, (case, passed, furthest)
    return seen


def check_messages(path, seen, case):
    """The messages have the same events, numbered without a gap."""
    with open(path) as file:
        events = [json.loads(line) for line in file if '"event"' in line]
    assert [one["event"] for one in events] == list(range(1, len(events) + 1)), (case, events)
    names = {"table_begin": "table", "end_of_profile": "pass"}
    listed = [(names[one["kind"]] + str(one["number"]), one["position"], one["tick"]) for one in events]
    assert listed == seen[:len(listed)] and len(listed) >= len(CASES[case][1]), (case, listed, seen)
    return len(listed)


def main():
    case, log = sys.argv[1], read(sys.argv[2])
    ticks = check_motion(case, log)
    seen = check_events(case, log)
    sent = check_messages(sys.argv[3], seen, case) if len(sys.argv) > 3 else 0
    print(f"{case}: {ticks} ticks, {len(seen)} events and {sent} messages agree")


main()
