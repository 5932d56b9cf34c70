#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""keys_test.py SOURCE_DIR: scripts/keys reports each change that is made to a copy of the readers or of the page."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

source = pathlib.Path(sys.argv[1])
CHANGES = [  # file, text, its replacement, what the script must report
    ("spec/src/cams/polydyne.cpp", '"frequency", "Hz")', '"frequency", "Hz") + table->number("extra", "1")',
     "lacks the key extra"),
    ("spec/src/machines/homing.cpp", 'read("timeout", "s"', 'read("deadline", "s"', "lacks the key deadline"),
    ("spec/src/parts/load.cpp", '{"damping", ', '{"drag", ', "lacks the key drag"),
    ("validate/src/drive/drive_numbers.cpp", '"backlash"', '"play"', "lacks the key play"),
    ("spec/src/motions/queue.cpp", '"halt", "dwell"', '"halt", "wait"', "lacks the choice wait of type"),
    ("spec/src/motions/then.cpp", 'OperatorReader{"notch"', 'OperatorReader{"dent"', "lacks the choice dent"),
    ("spec/src/motions/move.cpp", 'ProfileReader{"s_curve"', 'ProfileReader{"scurve"', "lacks the choice scurve"),
    ("spec/src/cams/disc.cpp", 'number("base_radius"', "number(key_of(disc)", "cannot resolve the key key_of(disc)"),
    ("spec/src/cams/knife.cpp", 'optional_number("speed_ratio"', 'optional_number("diameter"', "reads speed_ratio"),
    ("docs/reference/keys.md", "| `blades` |", "| `blade` |", "lacks the key blades"),
]


def copy_to(folder):
    for name in ("spec", "docs/reference", "scripts", "study/src/sweep", "validate/src/drive", "controllers/src",
                 "profiles/include", "cam/src/coupling", "optimize/src/knots"):
        shutil.copytree(source / name, folder / name)


def reported(folder):
    done = subprocess.run([sys.executable, folder / "scripts/keys"], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


with tempfile.TemporaryDirectory() as name:
    root = pathlib.Path(name)
    copy_to(root)
    failures = [f"the unchanged copy: {reported(root)[1]}"] if reported(root)[0] else []
    for path, old, new, wanted in CHANGES:
        file = root / path
        text = file.read_text()
        if old not in text:
            failures.append(f"{path} has no {old}")
            continue
        file.write_text(text.replace(old, new, 1))
        status, output = reported(root)
        if status != 1 or wanted not in output:
            failures.append(f"{path}: {old} became {new}: expected '{wanted}', got status {status}:\n{output}")
        file.write_text(text)
print("\n".join(failures) or f"{len(CHANGES)} changes are found")
sys.exit(1 if failures else 0)
