#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""judge_couplings.py LOG.line.csv LOG.corrector.csv LOG.label.csv: checks every tick of examples/printing-line.

Each axis keeps the limits of its spec, repeated here. The label moves by 100 mm in its first clutch of 200 mm, then by
1 for each mm of the line; the phase shift reaches 2.5 mm and returns to 0; at the end, the label follows the line minus
half of the corrector. Shares no code with Jounce."""
import sys

from tick_log import rows

DT = 1e-3
LIMITS = {"line": (800, 4000, 40000), "corrector": (100, 1000, 20000), "label": (1500, 20000, 1e6)}
STOP = 2  # a stop has twice the acceleration and the jerk


def number(row, name):
    return float(row[name])


def within_limits(name, log):
    v_most, a_most, j_most = LIMITS[name]
    near = 1 + 1e-6
    judged = 0
    for tick, now in log.items():
        before = log.get(tick - 1)
        assert now["fault"] == "none", (name, tick, now["fault"])
        if before is None:
            continue
        factor = STOP if "stopping" in (now["state"], before["state"]) else 1
        v0, v1 = number(before, "velocity"), number(now, "velocity")
        a0, a1 = number(before, "acceleration"), number(now, "acceleration")
        moved = number(now, "position") - number(before, "position")
        assert abs(v1) <= v_most * near, (name, tick, "velocity", v1)
        assert abs(a1) <= factor * a_most * near, (name, tick, "acceleration", a1)
        assert abs(a1 - a0) <= factor * j_most * DT * near, (name, tick, "acceleration step", a0, a1)
        assert abs(v1 - v0) <= factor * a_most * DT * near, (name, tick, "velocity step", v0, v1)
        assert abs(moved - (v0 + v1) / 2 * DT) <= factor * j_most * DT ** 3, (name, tick, "position step", moved)
        judged += 1
    return judged


def main(line_log, corrector_log, label_log):
    line, corrector, label = (dict(rows(path)) for path in (line_log, corrector_log, label_log))
    judged = sum(within_limits(*one) for one in (("line", line), ("corrector", corrector), ("label", label)))
    ticks = [t for t in sorted(label) if t in line and t in corrector]
    coupled = [t for t in ticks if label[t]["state"] == "synchronized_motion"]
    start = coupled[0]
    x0, y0 = number(line[start], "position"), number(label[start], "position")
    shift = {t: number(label[t], "master") - number(line[t], "position") for t in coupled}
    first_shift = next(t for t in coupled if shift[t] > 1e-9)
    after_clutch = 0
    for t in coupled:
        if number(line[t], "position") >= x0 + 200 and t < first_shift:
            expected = y0 + 100 + number(line[t], "position") - x0 - 200
            assert abs(number(label[t], "position") - expected) < 1e-6, (t, "after the clutch", expected)
            after_clutch += 1
    assert after_clutch > 100, "the phase shift began too early"
    assert abs(max(shift.values()) - 2.5) < 1e-9, max(shift.values())
    assert abs(shift[coupled[-1]]) < 1e-9, shift[coupled[-1]]
    # The last second of the combination, in which the corrector moves.
    last = coupled[-1000:]
    offsets = [number(label[t], "position") - number(line[t], "position") + number(corrector[t], "position") / 2
               for t in last]
    assert max(offsets) - min(offsets) < 1e-6, (min(offsets), max(offsets))
    moved = [number(corrector[t], "position") for t in last]
    assert max(moved) - min(moved) > 3, "the corrector stood"
    print(f"{judged} ticks within the limits; {after_clutch} after the clutch; {len(last)} combined")


main(*sys.argv[1:])
