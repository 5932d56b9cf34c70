#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws docs/pictures/report.png: the report of an optimized cam, with the cam before, and the cursor at a place.

usage: report_picture.py [JOUNCE [CHROMIUM]]
"""
import base64
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "web"))
from browser import Browser  # noqa: E402

CAM = ROOT / "examples" / "pmc600-cam" / "cam.toml"
PLACE = 245


def main():
    jounce = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build" / "release" / "cli" / "jounce")
    chromium = sys.argv[2] if len(sys.argv) > 2 else "chromium"
    with tempfile.TemporaryDirectory() as folder:
        better, page = pathlib.Path(folder) / "better.toml", pathlib.Path(folder) / "page.html"
        subprocess.run([jounce, "optimize", CAM, "-o", better], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([jounce, "report", better, "--before", CAM, "-o", page], check=True, stdout=subprocess.DEVNULL)
        browser = Browser(chromium, folder, width=920)
        try:
            browser.open(page.as_uri())
            browser.wait_for("document.querySelector('figure.live') !== null")
            plot = browser.run("(() => { const b = document.querySelector('.plot svg').getBoundingClientRect();"
                               "return [b.x, b.y, b.width, b.height]; })()")
            browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=plot[0] + 62 + (plot[2] - 74) * PLACE / 360, y=plot[1] + 150)
            browser.wait_for(f"Math.abs(document.querySelector('.plot').getAttribute('aria-valuenow') - {PLACE}) < 1")
            bottom = browser.run("document.querySelector('.live .keys:last-child').getBoundingClientRect().top")
            top = browser.run("document.querySelector('.tools').getBoundingClientRect().top")
            data = browser.call("Page.captureScreenshot", captureBeyondViewport=True,
                                clip={"x": 0, "y": top - 12, "width": 920, "height": bottom - top + 12, "scale": 1})["data"]
            (ROOT / "docs" / "pictures" / "report.png").write_bytes(base64.b64decode(data))
        finally:
            browser.end()


if __name__ == "__main__":
    main()
