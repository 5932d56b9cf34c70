#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the pictures of the editor in docs/pictures: editor.png and editor-dark.png (a cam whose return breaks a limit),
editor-path.png (a path in its plane) and editor-send.png (the confirmation before a table is sent to a simulated axis).

usage: editor_picture.py [JOUNCE [CHROMIUM]]
"""
import contextlib
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "web"))
from browser import Browser  # noqa: E402


PICTURES = ROOT / "docs" / "pictures"
HEIGHT = 1440  # px, to the end of the table of segments
PATH_HEIGHT = 760


@contextlib.contextmanager
def page(jounce, browser, spec, ready):
    """The editor of a spec in the browser, until `ready` is true."""
    editor = subprocess.Popen([jounce, "edit", str(spec)], stderr=subprocess.PIPE, text=True)
    try:
        browser.open(editor.stderr.readline().split(" at ")[1].strip())
        browser.wait_for(f"document.querySelector('figure.live') !== null && {ready}")
        yield
    finally:
        editor.terminate()
        editor.wait()


def new(jounce, kind, folder):
    file = folder / f"{kind}.toml"
    subprocess.run([jounce, "new", kind, "-o", str(file)], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return file


def send(jounce, browser, folder):
    """The dialog with the offer of a move, for an axis that runs on a bus of Unix sockets."""
    bus = folder / "bus"
    bus.mkdir()
    axis = new(jounce, "axis", folder)
    executor = subprocess.Popen([jounce, "run", str(axis), "--enable", "--url", f"unix://{bus}"], stdout=subprocess.DEVNULL,
                                stderr=subprocess.DEVNULL)
    try:
        with page(jounce, browser, new(jounce, "move", folder), "state !== null"):
            browser.run("document.getElementById('stream').click()")
            browser.wait_for("document.getElementById('stream-to') !== null")
            browser.run(f"document.getElementById('stream-to').value = 'feeder'; document.getElementById('stream-url').value = 'unix://{bus}'")
            for _ in range(20):  # until the axis answers
                browser.run("stream.facts.replaceChildren(); document.getElementById('stream-offer').click()")
                browser.wait_for("document.getElementById('stream-confirm') !== null")
                if "standstill" in browser.run("stream.facts.textContent"):
                    break
            shown = "unix:///run/jounce"  # instead of the temporary folder
            browser.run(f"document.getElementById('stream-url').value = '{shown}'; stream.facts.querySelectorAll('td')[1].textContent = '{shown}'")
            browser.picture(str(PICTURES / "editor-send.png"), height=PATH_HEIGHT)
    finally:
        executor.terminate()
        executor.wait()


def main():
    jounce = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "build" / "release" / "cli" / "jounce")
    chromium = sys.argv[2] if len(sys.argv) > 2 else "chromium"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        browser = Browser(chromium, name, width=1380, height=HEIGHT)
        try:
            spec = folder / "cam.toml"
            shutil.copy(ROOT / "examples" / "pmc600-cam" / "cam.toml", spec)
            with page(jounce, browser, spec, "document.querySelector('#knots tbody tr') !== null"):
                browser.run("picture.moveTo(250); pane.goTo(19, false)")
                for picture, dark in (("editor", False), ("editor-dark", True)):
                    browser.picture(str(PICTURES / f"{picture}.png"), dark, HEIGHT)
            browser.call("Emulation.setDeviceMetricsOverride", width=1380, height=PATH_HEIGHT, deviceScaleFactor=1, mobile=False)
            with page(jounce, browser, new(jounce, "path", folder), "document.querySelector('#plane .grip') !== null"):
                browser.run("picture.moveTo(1.6)")
                browser.picture(str(PICTURES / "editor-path.png"), height=PATH_HEIGHT)
            send(jounce, browser, folder)
        finally:
            browser.end()


if __name__ == "__main__":
    main()
