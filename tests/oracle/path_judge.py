#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Judges a plan of several axes by its limits and its geometry, without any knowledge of planning.

usage: path_judge.py JOB.json [--curve AXIS=FILE]... [--json]   exit status 1 if there is a violation, 2 for bad input
       path_judge.py --self-test                                accepts exact plans, finds planted violations of 1e-6

paths/job.py describes the format of a job. Checked, in plain Python:
  - limits of each axis, by exact extrema of the polynomials (relative 1e-12, plus the rounding of the coefficients);
  - continuity of position and velocity, and of the acceleration where the jerk is limited; rest at both ends. At a
    tangent joint with deviation 0 and no stop, the acceleration may jump by the step of the curvature times v²;
  - limits of the motion in space: speed, acceleration along and across, by polynomial inequalities; limits of the law;
  - both directions of the distance, in the order of the program: the curve stays within the deviation of the piece it
    is on, and passes each corner within the deviation. A curve that does both also passes every point between
    (its foot moves continuously along the piece). On arcs that climb (helices) this is sampled, which the report notes;
  - start and end, stops, feeds (a blend may have the greater feed of its neighbours, the middle of a piece its own);
  - the time is at most that with a stop at every corner, and at least that of the curve without limits of jerk.
"""
import json
import math
import sys
from pathlib import Path

from paths.bounds import second_order_bound, stop_time
from paths.job import Arc, BadJob, Job
from paths.limits import Report, check_joints, check_limits, check_space
from paths.walk import Walk, check_feeds, steps_of

def judge(document, folder="."):
    job, report = Job(document, folder), Report()
    steps = []
    if job.shapes:
        walk = Walk(report, job)
        places = walk.run()
        if places is not None:
            check_feeds(report, job, places)
            steps = steps_of(walk, places)
            report.notes["greatest distance of a corner"] = f"{walk.corner_distance:.12g}"
        if any(isinstance(s, Arc) and not s.flat for s in job.shapes):
            report.notes["helices"] = "distances sampled"
    for k, (axis, curve) in enumerate(zip(job.axes, job.curves)):
        check_limits(report, axis["name"], curve, axis)
        check_joints(report, axis["name"], curve, axis, [(t, width, jump[k]) for t, width, jump in steps])
    if job.law is not None:
        check_limits(report, "law", job.law, job.law_limits)
        check_joints(report, "law", job.law, job.law_limits)
    check_space(report, job)
    first, last = job.cells[0], job.cells[-1]
    ends = [(first[0], [c[0] for c in first[2]], job.start, "start")]
    if not job.partial:
        ends.append((last[0] + last[1], [sum(c) for c in last[2]], job.goal, "end"))
    for t, point, wanted, what in ends:
        if math.dist(point, wanted) > job.tolerance:
            report.violation("end", f"distance from the {what} of the program", math.dist(point, wanted), job.tolerance, t)
    report.notes["time"] = f"{job.time:.12g}"
    if not job.partial:
        check_time(report, job)
    return report


def check_time(report, job):
    stop, bound = stop_time(job), second_order_bound(job)
    report.notes["time with a stop at each corner"] = f"{stop:.12g}"
    report.notes["time of this curve without limits of jerk"] = f"{bound:.12g}, rounded down"
    if job.time > stop * (1 + 1e-9):
        arcs = any(isinstance(shape, Arc) for shape in job.shapes)
        report.violation("slower than stopping" + (", with arcs" if arcs else ""), "time", job.time, stop, job.time)
    if job.time < bound:
        report.violation("faster than possible", "-time", -job.time, -bound, job.time)


def main():
    arguments = sys.argv[1:]
    if arguments == ["--self-test"]:
        from paths.planted import self_test
        sys.exit(self_test(judge))
    names = [a for i, a in enumerate(arguments) if not a.startswith("--") and (i == 0 or arguments[i - 1] != "--curve")]
    if len(names) != 1:
        sys.exit(__doc__)
    try:
        document = json.loads(Path(names[0]).read_text(encoding="utf-8"))
        curves = document.setdefault("curves", {})
        for flag, text in zip(arguments, arguments[1:]):
            if flag == "--curve":
                axis, _, file = text.partition("=")
                curves[axis] = {"file": str(Path(file).resolve())}
        report = judge(document, Path(names[0]).parent)
    except (BadJob, OSError, KeyError, TypeError, ValueError) as problem:
        print(f"path_judge.py: {names[0]}: {type(problem).__name__}: {problem}", file=sys.stderr)
        sys.exit(2)
    if "--json" in arguments:
        print(json.dumps({"violations": report.violations, "notes": report.notes}, indent=1))
    else:
        print(*report.text(), sep="\n")
    sys.exit(1 if report.violations else 0)


if __name__ == "__main__":
    main()
