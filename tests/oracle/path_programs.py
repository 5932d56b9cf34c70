#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Programs for planners of paths: benchmark paths by formula, and adversarial ones with the expected outcome.

usage: path_programs.py FOLDER           writes NAME.ngc, NAME.csv (points), NAME.job.json and manifest.json
       path_programs.py FOLDER N SEED    writes N random programs, N.ngc with N.job.json (its limits differ an axis)
       path_programs.py --hashes         prints the SHA-256 of each file
       path_programs.py --check          exit status 1 if the files are not those of path_programs.sha256

Coordinates are rounded to 1e-6 mm, and 1e-12 mm in the adversarial programs, so that the files are the same on every
machine. Feeds are in mm/min (6000 = 100 mm/s). NAME.job.json is the geometry for path_judge.py; the limits are those
of the closed forms: 100 mm/s along the path, 1000 mm/s² and 10000 mm/s³ on every axis.
"""
import hashlib
import json
import sys
from pathlib import Path

from paths import formulas
from paths.adversaries import adversaries
from paths.gcode import FEED, arc, gcode, job, line, text_of
from paths.random_programs import random_program


def stadium(length=100.0, radius=50.0):
    """Line, half circle, line, half circle: HIMC 8.1.6, example 2, with feeds 150, 100 and 50 mm/s."""
    d = 2 * radius
    return [line([length, 0], feed=150), arc([length, d], [length, radius], feed=100),
            line([0, d], feed=50), arc([0, 0], [0, radius], feed=100)]


WIDE = {"square": 1, "stadium": 1}  # deviations of the benchmark paths; the others have 0.05 mm


def benchmark_programs():
    """name -> (text, points or None, job)."""
    out = {}
    for name, points in {**formulas.benchmarks(), "stadium": None}.items():
        start, pieces = ([0.0, 0.0], stadium()) if points is None else (points[0], [line(p) for p in points[1:]])
        deviation = WIDE.get(name, 0.05)
        text, numbered = gcode(start, pieces, deviation)
        out[name] = (text, points, job(start, numbered, deviation, max(p.get("feed", FEED / 60) for p in pieces)))
    return out


def files():
    """Name of each file -> its text."""
    out, manifest = {}, []
    for name, (text, points, geometry) in benchmark_programs().items():
        out[f"{name}.ngc"] = text
        if points is not None:
            out[f"{name}.csv"] = ",".join("xyz"[:len(points[0])]) + "\n" + "".join(
                ",".join(text_of(c) for c in p) + "\n" for p in points)
        out[f"{name}.job.json"] = json.dumps(geometry) + "\n"
        manifest.append({"program": f"{name}.ngc", "outcome": "plan", "kind": "benchmark", "job": f"{name}.job.json"})
    for name, text, entry, geometry in adversaries():
        out[f"{name}.ngc"] = text
        entry = {"program": f"{name}.ngc", "kind": "adversary", **entry}
        if "like" in entry:
            entry["like"] += ".ngc"
        if geometry is not None:
            out[f"{name}.job.json"] = json.dumps(geometry) + "\n"
            entry["job"] = f"{name}.job.json"
        manifest.append(entry)
    out["manifest.json"] = "[\n" + ",\n".join(json.dumps(e) for e in manifest) + "\n]\n"
    return out


def hashes():
    texts = {**files(), **random_files(20, 23)}
    return "".join(f"{hashlib.sha256(text.encode()).hexdigest()}  {name}\n" for name, text in sorted(texts.items()))


def write(folder, texts):
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8", newline="")
    print(f"{len(texts)} files in {folder}")


def random_files(count, seed):
    out = {}
    for i in range(count):
        text, geometry = random_program(1000003 * seed + i)
        out |= {f"{i}.ngc": text, f"{i}.job.json": json.dumps(geometry) + "\n"}
    return out


def main():
    arguments = sys.argv[1:]
    committed = Path(__file__).with_suffix(".sha256")
    if arguments == ["--hashes"]:
        sys.stdout.write(hashes())
    elif arguments == ["--check"]:
        sys.exit(0 if committed.read_text(encoding="ascii") == hashes() else 1)
    elif len(arguments) == 1 and not arguments[0].startswith("-"):
        write(arguments[0], files())
    elif len(arguments) == 3:
        write(arguments[0], random_files(int(arguments[1]), int(arguments[2])))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
