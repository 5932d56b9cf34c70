# SPDX-License-Identifier: Apache-2.0
"""The editor in a headless Chromium, for the tests of its page: CHROMIUM FOLDER JOUNCE are the first arguments."""
import json
import signal
import subprocess
import sys

from browser import Browser

program, folder, jounce = sys.argv[1:4]
KEY_CODES = {"Enter": 13, "Tab": 9, "Escape": 27, "ArrowDown": 40, "ArrowUp": 38, "z": 90, "s": 83}
PLOT = "document.querySelector('#figure .plot')"
TEXT = "document.getElementById('text').value"


class Editor:
    """The program, and the address that it prints."""

    def __init__(self, spec):
        self.process = subprocess.Popen([jounce, "edit", str(spec)], stderr=subprocess.PIPE, text=True)
        line = self.process.stderr.readline()
        assert " at http://127.0.0.1:" in line, line
        self.address = line.split(" at ")[1].strip()

    def end(self, how=signal.SIGTERM):
        self.process.send_signal(how)
        status = self.process.wait(20)
        rest = self.process.stderr.read()
        assert status == (0 if how == signal.SIGTERM else -how), (status, rest)
        return rest


browser = Browser(program, folder, width=1400, height=900)
browser.call("Page.addScriptToEvaluateOnNewDocument", source="window.errors = [];"
             "addEventListener('error', (e) => errors.push(e.message));"
             "addEventListener('unhandledrejection', (e) => errors.push(String(e.reason)));"
             "addEventListener('securitypolicyviolation', (e) => errors.push(e.violatedDirective + ' ' + e.blockedURI));")


def settle():
    """Waits until the page has drawn, and no change is on its way."""
    browser.wait_for("busy === 0 && !asked")
    twice = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
    browser.call("Runtime.evaluate", expression=twice, awaitPromise=True)


def open_page(editor):
    browser.open(editor.address)
    browser.wait_for("typeof state !== 'undefined' && state !== null && document.querySelector('figure.live') !== null")
    settle()


def text():
    return browser.run(TEXT)


def click(element):
    browser.run(f"document.getElementById('{element}').click()")


def key(name, code=None, modifiers=0, text=None):
    """Presses a key as a keyboard does: 1 Alt, 2 Ctrl, 8 Shift."""
    more = {"text": text} if text else {}
    for kind in ("keyDown", "keyUp"):
        browser.call("Input.dispatchKeyEvent", type=kind, key=name, code=code or name, modifiers=modifiers,
                     windowsVirtualKeyCode=KEY_CODES.get(name, 0),
                     **(more if kind == "keyDown" else {}))


def write(words):
    browser.call("Input.insertText", text=words)


def grip(knot, order):
    """The middle of a handle, px."""
    place = (f"(() => {{ const box = document.querySelector('.grip[data-knot=\"{knot}\"][data-order=\"{order}\"]')"
             ".getBoundingClientRect();"
              " return JSON.stringify([box.x + box.width / 2, box.y + box.height / 2]); })()")
    return json.loads(browser.run(place))


def mouse(kind, x, y, **more):
    browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)


def drag(knot, order, dx, dy, modifiers=0, drop=True):
    x, y = grip(knot, order)
    mouse("mouseMoved", x, y)
    mouse("mousePressed", x, y, button="left", buttons=1, clickCount=1)
    for step in range(1, 6):
        mouse("mouseMoved", x + dx * step / 5, y + dy * step / 5, button="left", buttons=1, modifiers=modifiers)
    browser.wait_for("!asked")
    if drop:
        mouse("mouseReleased", x + dx, y + dy, button="left", clickCount=1)
    settle()


def only_line_differs(before, now, begin):
    """The new line that begins with these words; all other lines are the same."""
    a, b = before.split("\n"), now.split("\n")
    assert len(a) == len(b), (before, now)
    lines = [(old, new) for old, new in zip(a, b) if old != new]
    assert len(lines) == 1 and lines[0][1].startswith(begin), lines
    return lines[0][1]


def place(query):
    """The middle of the element that a query finds, px; the page scrolls there."""
    return json.loads(browser.run(f"(() => {{ const e = document.querySelector('{query}'); e.scrollIntoView({{block: 'nearest'}});"
                                  " const box = e.getBoundingClientRect();"
                                  " return JSON.stringify([box.x + box.width / 2, box.y + box.height / 2]); })()"))


def drag_grip(query, dx, dy):
    """Drags the handle that a query finds."""
    x, y = place(query)
    mouse("mouseMoved", x, y)
    mouse("mousePressed", x, y, button="left", buttons=1, clickCount=1)
    for step in range(1, 6):
        mouse("mouseMoved", x + dx * step / 5, y + dy * step / 5, button="left", buttons=1)
    browser.wait_for("!asked")
    mouse("mouseReleased", x + dx, y + dy, button="left", clickCount=1)
    settle()


def field(section, label, value):
    """Types a number into a table of points or switches."""
    browser.run(f"(() => {{ const i = document.querySelector('#{section} input[aria-label=\"{label}\"]'); i.value = '{value}'; "
                "i.dispatchEvent(new Event('change')); })()")
    settle()
