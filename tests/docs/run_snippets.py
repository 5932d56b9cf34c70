#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the commands that the documentation shows.

usage: run_snippets.py JOUNCE PAGE.md...

A fence tagged `sh run` is executed with the jounce given, in one scratch folder per page in which `examples` and
`docs` are the repository's, as for a reader in its root; `exit N` as a second tag (`sh run exit=1`) is the status
expected. A fence `output` right after it must be found in the output, line by line. A fence `toml examples/NAME.toml`
must be in that file unchanged. Prints file and line of each failure.
"""
import os
import re
import subprocess
import sys
import tempfile

FENCE = re.compile(r"^```([^\n]*)\n(.*?)^```$", re.M | re.S)


ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))


def source(name):
    with open(os.path.join(ROOT, name), encoding="utf-8") as file:
        return file.read()


def run_page(path, env):
    text = open(path, encoding="utf-8").read()
    failures = 0
    # A program that the page has ended may still be writing there.
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        for name in ("examples", "docs"):
            os.symlink(os.path.join(ROOT, name), os.path.join(folder, name))
        printed = None
        for fence in FENCE.finditer(text):
            line = text.count("\n", 0, fence.start()) + 1
            tags, body = fence.group(1).split(), fence.group(2)
            if tags[:2] == ["sh", "run"]:
                expected = next((int(t[5:]) for t in tags if t.startswith("exit=")), 0)
                done = subprocess.run(["sh", "-e", "-c", body], cwd=folder, env=env, timeout=60,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
                printed = done.stdout
                if done.returncode != expected:
                    print(f"{path}:{line}: exit status {done.returncode}, expected {expected}\n{printed}")
                    failures += 1
            elif tags == ["output"] and printed is not None:
                for wanted in body.splitlines():
                    if wanted.strip() not in ("", "...") and wanted.rstrip() not in printed:
                        print(f"{path}:{line}: not printed: {wanted}\n{printed}")
                        failures += 1
                printed = None
            elif tags[:1] == ["toml"] and len(tags) > 1 and body not in source(tags[1]):
                print(f"{path}:{line}: does not stand in {tags[1]}")
                failures += 1
    return failures


def main():
    jounce, pages = os.path.abspath(sys.argv[1]), sys.argv[2:]
    env = dict(os.environ, PATH=os.path.dirname(jounce) + ":" + os.environ["PATH"])
    sys.exit(1 if sum(run_page(page, env) for page in pages) else 0)


main()
