#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the page of `jounce report` in headless Chromium: its size, and its frames while it zooms.

usage: report_frames.py JOUNCE [CHROMIUM]

Three curves: an example cam, a table of 6 000 knots and one of 200 000 knots. The page zooms in and out for six rounds of
100 frames, one step for each frame. The first round includes the compilation of the script by the browser. The CPU time of
the main thread depends little on other programs, unlike the rate.
"""
import math
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "web"))
from browser import Browser  # noqa: E402

FRAMES, ROUNDS = 100, 6
ZOOM = f"""new Promise((done) => {{
  const report = window.measured, begun = performance.now();
  let n = 0;
  const step = () => {{
    if (n === {FRAMES}) return done((performance.now() - begun) / {FRAMES});
    const middle = report.view.start + 0.37 * (report.view.end - report.view.start);
    report.zoom(Math.floor(n++ / 40) % 2 === 0 ? 0.9 : 1 / 0.9, middle);
    requestAnimationFrame(step);
  }};
  requestAnimationFrame(step);
}})"""


def main_thread(browser):
    """CPU time of the main thread of the page so far, s."""
    metrics = browser.call("Performance.getMetrics")["metrics"]
    return next(each["value"] for each in metrics if each["name"] == "TaskDuration")


def table(path, knots):
    """A PVT table of a sine over 100 s, as a spec with its points in a file."""
    points = path / f"points-{knots}.csv"
    lines = ["time [s],position [mm],velocity [mm/s]"]
    for i in range(knots):
        t = 100 * i / (knots - 1)
        lines.append(f"{t!r},{50 * math.sin(t) + math.sin(17 * t)!r},{50 * math.cos(t) + 17 * math.cos(17 * t)!r}")
    points.write_text("\n".join(lines) + "\n")
    spec = path / f"knots-{knots}.toml"
    spec.write_text(f'jounce = 1\nkind = "pvt"\nname = "{knots} knots"\nunits = {{ position = "mm", time = "s" }}\n'
                    f'points = "{points.name}"\n\n[limits]\nvelocity = 100\n')
    return spec


def zoomed(browser):
    """One round: ms from frame to frame, and CPU time of the main thread for each frame, ms."""
    before = main_thread(browser)
    wall = browser.call("Runtime.evaluate", expression=ZOOM, awaitPromise=True, returnByValue=True)["result"]["value"]
    return wall, (main_thread(browser) - before) / FRAMES * 1000


def main():
    jounce = sys.argv[1]
    chromium = sys.argv[2] if len(sys.argv) > 2 else "chromium"
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder)
        browser = Browser(chromium, folder, width=1280, height=900)
        browser.call("Performance.enable", timeDomain="threadTicks")
        try:
            for spec in (ROOT / "examples" / "packaging-pusher" / "cam.toml", table(path, 6000), table(path, 200_000)):
                page = path / (spec.stem + ".html")
                subprocess.run([jounce, "report", str(spec), "-o", str(page)], check=False)
                browser.open(page.as_uri())
                browser.wait_for("document.querySelector('figure.live') !== null")
                browser.run("document.querySelectorAll('figure.live .live').forEach((e) => e.remove());"
                            "window.measured = start()[0]; 1")
                rounds = [zoomed(browser) for _ in range(ROUNDS)]
                words = [f"{1000 / wall:.0f} frames/s, {cpu:.1f} ms CPU" for wall, cpu in rounds]
                print(f"{spec.stem}: {page.stat().st_size / 1000:.0f} kB; first {words[0]}; then {'; '.join(words[1:])}; "
                      f"load {os.getloadavg()[0]:.1f}")
        finally:
            browser.end()


if __name__ == "__main__":
    main()
