# SPDX-License-Identifier: Apache-2.0
"""Runs programs of path_programs.py through the command line and gives what it makes to path_judge.py.

usage: path_runs.py JOUNCE [--random N SEED] [PROGRAM]...   exit status 1 if anything differs

For every program `jounce check` must accept it, and its curves (`jounce design --curve`) must keep the limits, the
deviation and the end of the job; its tables must keep positions within their tolerance, velocities and accelerations
within the limits. A program that must be refused must give an error with its line. A program that only writes another
one differently must take the same time. Without PROGRAM all are run.
"""
import csv
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
TABLE_TOLERANCE = 1e-3
ROUNDING = 1e-9  # share of a limit, by the digits of a table
EPS = 2.0**-52


def run(*command):
    return subprocess.run([str(c) for c in command], capture_output=True, text=True, timeout=120, check=False)


def rounding_of(table, found):
    """The greatest error of a derivative between two knots of a table by the last digits of their positions."""
    rows = [row for row in csv.reader(table.read_text(encoding="utf-8").splitlines()) if row and row[0][0] != "#"]
    knots = [(float(row[0]), abs(float(row[1]))) for row in rows[1:]]
    for (t0, p0), (t1, p1) in zip(knots, knots[1:]):
        if t0 <= found["time"] <= t1:
            order = 1 if found["what"].startswith("velocity") else 2
            return (4, 12)[order - 1] * EPS * max(p0, p1) / (t1 - t0) ** order
    return 0.0


def symmetric(axis):
    """Limits for both signs of the acceleration, as those of a spec."""
    limits = {key: limit for key, limit in axis.items() if key != "deceleration"}
    limits["acceleration"] = min(axis["acceleration"], axis.get("deceleration", math.inf))
    return limits


def machine_of(job):
    """A spec of the machine, which begins at the start of the program."""
    text = 'jounce = 1\nkind = "path"\nname = "machine"\nunits = { position = "mm", time = "s" }\n'
    text += f"[path]\nstart = {job['start']}\n"
    if job.get("path"):
        text += "[path.limits]\n" + "".join(f"{key} = {value!r}\n" for key, value in job["path"].items())
    text += '[gcode]\nrapid = "6 m/min"\n'
    for axis in job["axes"]:
        limits = {key: axis[key] for key in ("velocity", "acceleration", "jerk") if key in axis}
        listed = ", ".join(f"{key} = {value!r}" for key, value in limits.items())
        text += f'[[axis]]\nname = "{axis["name"].lower()}"\nlimits = {{ {listed} }}\n'
        text += f"table = {{ tolerance = {TABLE_TOLERANCE!r} }}\n"
    return text


class Runner:
    def __init__(self, jounce, folder):
        self.jounce, self.folder, self.failures = jounce, folder, 0

    def fail(self, program, what):
        self.failures += 1
        print(f"{program}: {what}")

    def judge(self, program, job, curves, tolerance):
        document = dict(job, tolerance=tolerance, curves={axis: {"file": str(f)} for axis, f in curves.items()})
        path = self.folder / "judged.json"
        path.write_text(json.dumps(document), encoding="utf-8")
        result = run(sys.executable, HERE / "path_judge.py", path, "--json")
        if result.returncode == 2:
            return [{"kind": "judge", "text": result.stderr.strip()}]
        return json.loads(result.stdout)["violations"]

    def program(self, name, job, outcome, line=None, exact=True):
        """`exact`: the job has the geometry."""
        job = dict(job, axes=[symmetric(axis) for axis in job["axes"]])
        source, machine = self.folder / name, self.folder / "machine.toml"
        machine.write_text(machine_of(job), encoding="utf-8")
        given = (source, "--machine", machine)
        checked = run(self.jounce, "check", *given)
        if outcome == "error" or (outcome == "plan or error" and checked.returncode != 0):
            at = re.search(re.escape(name) + r":(\d+)", checked.stderr)
            if checked.returncode == 0 or not at or (line and int(at[1]) != line):
                self.fail(name, f"an error at line {line} is missing: {checked.stderr.strip()[:200]}")
            return None
        if checked.returncode != 0:
            self.fail(name, f"check: {(checked.stdout + checked.stderr).strip()[:600]}")
            return None
        curves, tables = {}, {}
        designed = run(self.jounce, "design", *given, "-o", self.folder / "table.csv")
        if designed.returncode != 0:
            self.fail(name, f"design: {designed.stderr.strip()[:300]}")
            return None
        for axis in job["axes"]:
            lower = axis["name"].lower()
            curve = self.folder / f"curve-{lower}.json"
            made = run(self.jounce, "design", *given, "--axis", lower, "-o", self.folder / "one.csv", "--curve", curve)
            if made.returncode != 0:
                self.fail(name, f"design --curve: {made.stderr.strip()[:300]}")
                return None
            curves[axis["name"]] = curve
            tables[axis["name"]] = self.folder / f"table-{lower}.csv"
        if exact:
            greatest = max([1.0] + [abs(x) for p in job["pieces"] for x in p["to"] + p.get("center", [])])
            certificate = len(curves) * max(1e-9, 4e-14 * greatest)
            for found in self.judge(name, job, curves, certificate):
                self.fail(name, f"curve: {found}")
            # A table is cubic between its knots: it keeps no jerk. Without it the judge's time with stops is too short.
            cubic = {key: value for key, value in job.items() if key != "path"}
            cubic["axes"] = [{key: x for key, x in axis.items() if key != "jerk"} for axis in job["axes"]]
            for found in self.judge(name, cubic, tables, 2 * len(curves) * TABLE_TOLERANCE):
                rounded = found["kind"] == "limit" and abs(found["value"]) <= (
                    found["limit"] * (1 + ROUNDING) + rounding_of(tables[found["what"].split()[-1]], found))
                # Between its knots a table is within its tolerance of the curve: the feed is that of the curve alone.
                promised = found["kind"] != "feed" and not found["kind"].startswith("slower")
                if promised and not rounded:
                    self.fail(name, f"table: {found}")
        one = json.loads(curves[job["axes"][0]["name"]].read_text(encoding="utf-8"))
        return math.fsum(segment["length"] for segment in one["segments"])


def main(arguments):
    if not arguments:
        sys.exit(__doc__)
    jounce, *wanted = arguments
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        runner = Runner(jounce, folder)
        if wanted[:1] == ["--random"]:
            run(sys.executable, HERE / "path_programs.py", folder, *wanted[1:3])
            for source in sorted(folder.glob("*.ngc")):
                job = json.loads(source.with_suffix(".job.json").read_text(encoding="utf-8"))
                moves = any(piece["to"] != job["start"] or piece["type"] == "arc" for piece in job["pieces"])
                runner.program(source.name, job, "plan" if moves else "plan or error")
            sys.exit(1 if runner.failures else 0)
        run(sys.executable, HERE / "path_programs.py", folder)
        times = {}
        usual = json.loads((folder / "plain_corner.job.json").read_text(encoding="utf-8"))
        for entry in json.loads((folder / "manifest.json").read_text(encoding="utf-8")):
            if wanted and Path(entry["program"]).stem not in wanted:
                continue
            job = usual
            if "job" in entry:
                job = json.loads((folder / entry["job"]).read_text(encoding="utf-8"))
            time = runner.program(entry["program"], job, entry["outcome"], entry.get("line"), "job" in entry)
            times[entry["program"]] = time
            like = times.get(entry.get("like"))
            if like and time and abs(time - like) > 1e-9 * like:
                runner.fail(entry["program"], f"takes {time} s, {entry['like']} takes {like} s")
    sys.exit(1 if runner.failures else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
