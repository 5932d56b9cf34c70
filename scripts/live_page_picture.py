#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws docs/pictures/live-page.png and live-page-dark.png (a label behind an external master, on the live page), and
live-path.png (a plotter on its planned path).

usage: live_page_picture.py [JOUNCE [CHROMIUM]]

Runs examples/external-master and examples/plotter in real time, for 15 s; looks best on a machine with nothing else to do.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "web"))
from browser import Browser  # noqa: E402

if os.environ.get("JOUNCE_INSIDE") != "1":  # in a network of its own
    os.environ["JOUNCE_INSIDE"] = "1"
    os.execv(str(ROOT / "scripts" / "own_network"), ["own_network", sys.executable, *sys.argv])

BUS = ["--url", os.environ["JOUNCE_BUS"]]
PATH_HEIGHT = 700  # px, with the group below its path
EXAMPLE = ROOT / "examples" / "external-master"


def plotter(jounce, browser):
    """The top of the live page while a plotter draws."""
    executor = subprocess.Popen([jounce, "run", str(ROOT / "examples" / "plotter" / "machine.toml"), "--enable", "--realtime", "80",
                                 "--web", "0", *BUS], stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
    try:
        browser.open(next(m[1] for m in (re.search(r"live page at (\S+)", line) for line in executor.stderr) if m))
        browser.wait_for("typeof path !== 'undefined' && path.group?.name === 'plotter'")
        for what in ("enable", "start"):
            order = f"post('/command', {{axis: 'plotter', what: '{what}', value: '', options: {{}}, flags: []}})"
            while not browser.run(order, True):
                time.sleep(0.1)
        browser.wait_for("path.trail().places.at(-1)?.[1] > 40")
        browser.picture(str(ROOT / "docs" / "pictures" / "live-path.png"), height=PATH_HEIGHT)
    finally:
        executor.terminate()
        executor.wait()


def main():
    jounce = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build" / "release" / "cli" / "jounce")
    chromium = sys.argv[2] if len(sys.argv) > 2 else "chromium"
    started, browser = [], None

    def start(*arguments, **more):
        started.append(subprocess.Popen([jounce, *map(str, arguments)], text=True, **more))
        return started[-1]

    with tempfile.TemporaryDirectory() as folder:
        try:
            executor = start("run", EXAMPLE / "machine.toml", "--enable", "--realtime", 80, "--web", 0, *BUS, stderr=subprocess.PIPE,
                             stdout=subprocess.DEVNULL)
            address = next(m[1] for m in (re.search(r"live page at (\S+)", line) for line in executor.stderr) if m)
            browser = Browser(chromium, folder, height=560)
            browser.open(address)
            browser.wait_for("document.querySelector('[data-is=state]') !== null")
            start("master", EXAMPLE / "line.toml", "--as", "line", "--before", 2, "--noise", "10um", *BUS,
                  stdout=subprocess.DEVNULL)
            time.sleep(1)
            start("stream", EXAMPLE / "cam.toml", "--to", "label", "--live", "--start-at", "250mm", *BUS,
                  stdout=subprocess.DEVNULL)
            browser.wait_for("parseFloat(document.querySelector('[data-is=position]').textContent) > 550")
            for name, dark in (("live-page", False), ("live-page-dark", True)):
                browser.picture(str(ROOT / "docs" / "pictures" / f"{name}.png"), dark)
            browser.call("Emulation.setEmulatedMedia", features=[])
            plotter(jounce, browser)
        finally:
            if browser:
                browser.end()
            for process in started:
                process.terminate()
            for process in started:
                process.wait()


if __name__ == "__main__":
    main()
