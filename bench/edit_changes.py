#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures a change of a cam of 100 segments in `jounce edit`: a preview, as while a knot is dragged.

usage: edit_changes.py JOUNCE

The CPU time is that of the server, so it does not depend on other programs. The wall time is that of the request.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import urllib.request

SEGMENTS, CHANGES = 100, 200


def cam():
    lines = ['jounce = 1', 'kind = "cam"', 'name = "hundred"', 'units = { master = "deg", position = "mm" }',
             'start = { master = 0, slave = 0, geo_velocity = 0.1, geo_acceleration = 0 }']
    for i in range(1, SEGMENTS + 1):
        lines += ["[[segment]]", 'law = "quintic"', f"end = {{ master = {3.6 * i:.6g}, slave = {10 * (i % 2) + 0.01 * i:.6g}, "
                  f"geo_velocity = {0.1 * (-1) ** i}, geo_acceleration = 0 }}"]
    return "\n".join([*lines, "[limits]", "geo_velocity = 20", "[master]", "velocity = 360", ""])


def main():
    with tempfile.TemporaryDirectory() as folder:
        spec = pathlib.Path(folder) / "hundred.toml"
        spec.write_text(cam())
        editor = subprocess.Popen([sys.argv[1], "edit", str(spec)], stderr=subprocess.PIPE, text=True)
        try:
            address, token = editor.stderr.readline().split(" at ")[1].strip().split("#")

            def preview(slave):
                body = {"change": {"do": "move", "knot": SEGMENTS // 2, "master": 180, "slave": slave}}
                request = urllib.request.Request(address + "preview", json.dumps(body).encode(), {"X-Jounce-Token": token})
                with urllib.request.urlopen(request, timeout=60) as answer:
                    return answer.read()

            def cpu():
                fields = pathlib.Path(f"/proc/{editor.pid}/stat").read_text().rsplit(")", 1)[1].split()
                return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

            answer, begun, walls = preview(1.0), cpu(), []
            for i in range(CHANGES):
                now = time.perf_counter()
                preview(1 + 0.01 * i)
                walls.append(time.perf_counter() - now)
            print(f"{SEGMENTS} segments: {1e3 * (cpu() - begun) / CHANGES:.1f} ms CPU, median {1e3 * sorted(walls)[CHANGES // 2]:.1f} ms "
                  f"of a request, answer {len(answer) / 1e3:.0f} kB; load {os.getloadavg()[0]:.1f}")
        finally:
            editor.terminate()
            editor.wait()


main()
