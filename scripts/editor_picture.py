#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws docs/pictures/editor.png and editor-dark.png: the editor with a cam whose return breaks a limit.

usage: editor_picture.py [JOUNCE [CHROMIUM]]
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "web"))
from browser import Browser  # noqa: E402


HEIGHT = 1380  # px, to the end of the table of segments


def main():
    jounce = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build" / "release" / "cli" / "jounce")
    chromium = sys.argv[2] if len(sys.argv) > 2 else "chromium"
    with tempfile.TemporaryDirectory() as folder:
        spec = pathlib.Path(folder) / "cam.toml"
        shutil.copy(ROOT / "examples" / "pmc600-cam" / "cam.toml", spec)
        editor = subprocess.Popen([jounce, "edit", str(spec)], stderr=subprocess.PIPE, text=True)
        browser = None
        try:
            address = editor.stderr.readline().split(" at ")[1].strip()
            browser = Browser(chromium, folder, width=1380, height=HEIGHT)
            browser.open(address)
            browser.wait_for("document.querySelector('figure.live') !== null && document.querySelector('#knots tbody tr') !== null")
            browser.run("picture.moveTo(250); pane.goTo(19, false)")
            for name, dark in (("editor", False), ("editor-dark", True)):
                browser.picture(str(ROOT / "docs" / "pictures" / f"{name}.png"), dark, HEIGHT)
        finally:
            if browser:
                browser.end()
            editor.terminate()
            editor.wait()


if __name__ == "__main__":
    main()
