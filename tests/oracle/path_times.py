#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints the durations of docs/path/speed.md: of the benchmark paths of path_programs.py, as `jounce check` plans them.

usage: path_times.py JOUNCE [PATH]...

A row contains the duration in s, with `refine`, with an overlap in time of the same deviation, with a stop at each
corner, and the proven lower bound of the first duration. "-" means that the path has no such motion: an overlap needs
lines, and an averaged path has no corners. Without PATH, all rows are printed.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from path_programs import benchmark_programs
from path_runs import machine_of
from paths.gcode import arc, gcode, job

AVERAGED = {"chord_circle", "butterfly"}  # dense lines: one smooth curve instead of corners
HILBERT_LEGS = 64


def programs():
    """name -> (text, job, averaged)."""
    made = benchmark_programs()
    out = {name: (text, geometry, name in AVERAGED) for name, (text, _, geometry) in made.items()}
    _, points, geometry = made["hilbert"]
    first = [dict(piece, deviation=0.5) for piece in geometry["pieces"][:HILBERT_LEGS]]
    text, numbered = gcode(geometry["start"], first, 0.5)
    out[f"hilbert_{HILBERT_LEGS}"] = (text, job(geometry["start"], numbered, 0.5, 100), False)
    circle, numbered = gcode([50.0, 0.0], [arc([50.0, 0.0], [0.0, 0.0])], 0.05)
    out["circle"] = (circle, job([50.0, 0.0], numbered, 0.05, 100), False)
    return out


def checked(jounce, folder, text, machine, keys):
    """The result of `jounce check --json` for the path; None if it rejects the program."""
    program, spec = folder / "program.ngc", folder / "machine.toml"
    program.write_text(text, encoding="utf-8")
    spec.write_text(machine.replace("[path]\n", f"[path]\n{keys}", 1), encoding="utf-8")
    result = subprocess.run([jounce, "check", program, "--machine", spec, "--json"], capture_output=True, text=True,
                            check=False)
    if result.returncode == 2:
        return None
    written = json.loads(result.stdout)
    return written["overlap" if keys.startswith("overlap") else "path"]


def row(jounce, folder, text, geometry, averaged):
    deviation = max(piece["deviation"] for piece in geometry["pieces"])
    machine = machine_of(geometry)
    corner = f"corner = {{ average = {deviation} }}\n" if averaged else ""
    plain = checked(jounce, folder, text, machine, corner)
    refined = checked(jounce, folder, text, machine, corner + "refine = true\n")
    overlap = None if averaged else checked(jounce, folder, text, machine, f"overlap = {{ deviation = {deviation} }}\n")
    return [plain["duration"], refined["duration"], overlap and overlap["duration"], plain["stop_duration"],
            plain["lower_bound"]]


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    jounce, *wanted = sys.argv[1:]
    every = programs()
    print("| path | Jounce, s | refined, s | overlap, s | with stops, s | lower bound, s |\n|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        for path in wanted or every:
            cells = row(jounce, Path(name), *every[path])
            print(f"| {path} | " + " | ".join("-" if x is None else f"{x:.4g}" for x in cells) + " |", flush=True)


if __name__ == "__main__":
    main()
