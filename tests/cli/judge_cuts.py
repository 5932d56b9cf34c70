#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Judges the log of a cutter, without any code of Jounce.

usage: judge_cuts.py LOG --slope S --turn T --sync M --velocity V --acceleration A --home H
                     --first M --lengths M,... [--demand M] [--soonest M]

A cut is where the slave is in step with the web: at S times its velocity, over the travel --sync. The position
of a cut follows from the setpoint: for a knife (--turn > 0), the slave is then at a multiple of --turn; for a shear,
at its position at the first cut. Every distance of two cuts must be one of --lengths, unless the second cut is at
--demand, or (once) as soon as possible: at least --soonest after the first. Velocity and acceleration stay within
their limits, the setpoint makes no step, and the slave ends at rest at --home (modulo --turn). The log may miss the
ticks of a few late cycles. A distance over such a gap, as long as a cut, may be the sum of two lengths.
Prints the positions of the cuts; exit status 1 with a message for the first violation.
"""
import argparse
import csv

DT = 1e-3
NEAR = 1e-9  # share of the velocity that counts as in step


def rows(path):
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            row = {key.split(" [")[0]: value for key, value in row.items()}
            numbers = ("master", "master_velocity", "position", "velocity", "acceleration")
            yield row["state"], *(float(row[key]) for key in numbers), row["fault"], int(row["tick"])


def runs_in_step(log, slope):
    """Maximal runs of rows in which the slave moves at the speed of the web."""
    run = []
    for row in log:
        state, _, web_v, _, v = row[:5]
        in_step = state == "synchronized_motion" and web_v > 1 and abs(v - slope * web_v) <= NEAR * slope * web_v
        if in_step:
            run.append(row)
        elif run:
            if len(run) > 1:
                yield run
            run = []


def main():
    args = argparse.ArgumentParser()
    args.add_argument("log")
    for name in ("slope", "turn", "sync", "velocity", "acceleration", "home", "first", "demand", "soonest"):
        args.add_argument("--" + name, type=float)
    args.add_argument("--lengths", type=lambda text: [float(one) for one in text.split(",")])
    a = args.parse_args()
    log = list(rows(a.log))
    for before, now in zip(log, log[1:]):
        assert now[6] == "none", ("fault", now)
        assert abs(now[4]) <= a.velocity * (1 + 1e-9), ("velocity", now)
        assert abs(now[5]) <= a.acceleration * (1 + 1e-9), ("acceleration", now)
        if before[0] != "disabled":
            dt = DT * (now[7] - before[7])  # a late cycle skips ticks
            assert abs(now[4] - before[4]) <= a.acceleration * dt * (1 + 1e-9), ("step of the velocity", before, now)
            way = dt / 2 * (now[4] + before[4])
            assert abs(now[3] - before[3] - way) <= a.acceleration * dt * dt, ("step of the position", before, now)
    cuts = []
    place = None
    for run in runs_in_step(log, a.slope):
        if a.turn > 0:
            middle = run[len(run) // 2]
            down = round(middle[3] / a.turn) * a.turn
            cut = middle[1] - (middle[3] - down) / a.slope
        else:
            place = place if place is not None else run[0][3] - a.slope * (run[0][1] - a.first)
            cut = run[0][1] - (run[0][3] - place) / a.slope
        # The whole sync zone is in step, not only this run of rows.
        begin, end = (cut - a.sync / 2, cut + a.sync / 2) if a.turn > 0 else (cut, cut + a.sync)
        offset = run[0][3] - a.slope * run[0][1]
        for row in log:
            if begin + 1e-3 < row[1] < end - 1e-3 and row[0] == "synchronized_motion":
                assert abs(row[4] - a.slope * row[2]) <= NEAR * a.slope * row[2], ("not at the speed of the web", row)
                assert abs(row[3] - a.slope * row[1] - offset) <= 1e-6 * a.slope, ("slips in step", row)
        cuts.append(cut)
    print("cuts at", ", ".join(f"{cut:.4f}" for cut in cuts))
    assert len(cuts) >= 4, "too few cuts"
    assert abs(cuts[0] - a.first) <= 1e-3, ("first cut", cuts[0])
    soonest = 0
    # Gaps in which a whole sync zone may lie, as positions of the web.
    gaps = [(one[1], two[1]) for one, two in zip(log, log[1:]) if two[1] - one[1] > a.sync / 2]
    for before, now in zip(cuts, cuts[1:]):
        piece = now - before
        pieces = list(a.lengths)
        if any(before < begin and end < now for begin, end in gaps):
            pieces += [one + two for one in a.lengths for two in a.lengths]
        if any(abs(piece - length) <= 1e-3 for length in pieces):
            continue
        if a.demand is not None and abs(now - a.demand) <= 1e-3:
            continue
        possible = a.soonest is not None and a.soonest - 1e-2 <= piece <= max(a.lengths)
        assert possible, ("piece", before, now, piece)
        soonest += 1
    assert soonest <= 1, "more than one cut was as soon as possible"
    if a.demand is not None:
        assert any(abs(cut - a.demand) <= 1e-3 for cut in cuts), ("no cut at", a.demand)
    end = log[-1]
    away = end[3] - a.home
    if a.turn > 0:
        away -= round(away / a.turn) * a.turn
    assert abs(away) <= 1e-9 * max(1, abs(end[3])) and end[4] == 0, ("the end is not home", end)
    assert end[0] == "standstill", end


main()
