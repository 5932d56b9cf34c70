#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""kinds_in_browser.py CHROMIUM FOLDER JOUNCE [PICTURES]: specs of other kinds than cams in the editor, in a browser; and
a table that is sent to a running executor.

With a folder for pictures: draws each kind in a wide, a dark and a narrow page.
"""
import json
import pathlib
import shutil
import signal
import subprocess
import sys
import time

from editor_page import (TEXT, Editor, browser, click, drag_grip, folder, jounce, key, mouse, only_line_differs, open_page, place, settle,
                         text, write)

pictures = pathlib.Path(sys.argv[4]) if len(sys.argv) > 4 else None
here = pathlib.Path(folder)
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"

PVT = """\
jounce = 1
kind = "pvt"
name = "three"             # knots
units = { position = "mm", time = "s" }

[[knot]]
time = 0
position = 0
velocity = 0

[[knot]]                   # through
time = "500 ms"
position = 60              # the gate
velocity = 100

[[knot]]
time = 1.2
position = 120
velocity = 0

[limits]
velocity = 250
position_max = 150
"""
VIA = """\
jounce = 1
kind = "axes"
name = "gantry"
units = { position = "mm" }

[[axis]]
name = "x"
velocity = 1000
acceleration = 2000
limits = { velocity = 1000, acceleration = 2000 }

[[axis]]
name = "y"
velocity = 1000
acceleration = 2000
limits = { velocity = 1000, acceleration = 2000 }

[[point]]
position = [0, 0]

[[point]]                  # over the belt
position = [1000, 1000]

[[point]]
position = [3000, 2000]

[[point]]
position = [4000, 0]
"""
PATH = """\
jounce = 1
kind = "path"
name = "plate"
units = { position = "mm", time = "s" }

[path]
velocity = 100
corner = { deviation = 2 }

[[axis]]
name = "x"
limits = { velocity = 200, acceleration = 1000, jerk = 10000 }

[[axis]]
name = "y"
limits = { velocity = 200, acceleration = 1000, jerk = 10000 }

[[command]]
type = "line"
to = [100, 0]              # along the edge

[[command]]
type = "arc"
center = [100, 30]
to = [100, 60]
rotation = "counterclockwise"

[[command]]
type = "line"
to = [0, 60]

[[command]]
type = "line"
to = [0, 0]
"""
MOVE = """\
jounce = 1
kind = "move"
name = "pick"
units = { position = "mm", time = "s" }

[move]
profile = "s_curve"
from = 0
to = 20                    # the station
velocity = 400
acceleration = 4000
jerk = 80000

[limits]
velocity = 500
acceleration = 5000
"""
FOLLOW = """\
jounce = 1
kind = "follow"
name = "cutter"
units = { position = "pulse", master = "pulse", time = "ms" }

[[segment]]
master = 5000
slave = 2500

[[segment]]                # constant ratio
master = 9000
slave = 6500
type = "even"

[[segment]]
master = 12000
slave = 8000
"""
AXIS = """\
jounce = 1
kind = "axis"
name = "pick"
units = { position = "mm", time = "s" }

[axis]
cycle = "1 ms"

[limits]
velocity = 500
acceleration = 5000
position_min = -10
position_max = 100
"""
PT = """\
jounce = 1
kind = "pt"
name = "steps"
units = { position = "pulse", time = "ms" }
point = [
  { time = 100, position = 50 },
  { time = 200, position = 150 },   # the middle
  { time = 300, position = 200 },
]

[pt]
increments = false
"""


class Document:
    """An editor of a text, with its page."""

    def __init__(self, name, words):
        self.file = here / f"{name}.toml"
        self.file.write_text(words)
        self.editor = Editor(self.file)

    def __enter__(self):
        open_page(self.editor)
        assert browser.run("document.querySelectorAll('.grip').length") > 0
        return self

    def __exit__(self, kind, *rest):
        if kind is None:
            assert browser.run("errors.join('; ')") == "", browser.run("errors.join('; ')")
            layout()
        if pictures and kind is None:
            draw(self.file.stem)
        self.editor.end()


def layout():
    """Nothing is wider than its window."""
    for width in (1400, 390):
        browser.call("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=width < 600)
        settle()
        assert browser.run("document.documentElement.scrollWidth") <= width, width
    browser.call("Emulation.setDeviceMetricsOverride", width=1400, height=900, deviceScaleFactor=1, mobile=False)
    settle()


def draw(name):
    browser.picture(str(pictures / f"{name}.png"))
    browser.picture(str(pictures / f"{name}-dark.png"), dark=True)
    browser.call("Emulation.setDeviceMetricsOverride", width=390, height=900, deviceScaleFactor=1, mobile=True)
    browser.picture(str(pictures / f"{name}-narrow.png"))
    browser.call("Emulation.setDeviceMetricsOverride", width=1400, height=900, deviceScaleFactor=1, mobile=False)


def double_click(x, y):
    mouse("mouseMoved", x, y)
    for count in (1, 2):
        mouse("mousePressed", x, y, button="left", buttons=1, clickCount=count)
        mouse("mouseReleased", x, y, button="left", clickCount=count)
    settle()


def undo_all(words):
    while not browser.run("document.getElementById('undo').disabled"):
        click("undo")
        settle()
    assert text() == words


def type_number(label, value):
    """Types a number into a table, by keyboard alone."""
    browser.run(f"document.querySelector('#tables input[aria-label=\"{label}\"]').focus()")
    browser.run("document.activeElement.select()")
    write(str(value))
    key("Enter", text="\r")
    settle()


def peak(order):
    return browser.run(f"Math.max(...picture.views[0].panels[{order}].marks.map(([, y]) => Math.abs(y)))")


def expected_peak(order):
    """The same from `jounce check` of the text of the page."""
    file = here / "checked.toml"
    file.write_text(text())
    out = subprocess.run([jounce, "check", str(file), "--json"], capture_output=True, text=True)
    name = ["position", "velocity", "acceleration", "jerk"][order]
    return max(max(abs(each[name]["min"]["value"]), abs(each[name]["max"]["value"])) for each in json.loads(out.stdout)["segments"])


def pvt_knots():
    with Document("knots", PVT) as document:
        grip = '.grip[data-y="knot[2].position"]'
        drag_grip(grip, 0, -25)
        line = only_line_differs(PVT, text(), "position = ")
        assert line.endswith("              # the gate") and float(line.split()[2]) > 60, line
        assert abs(peak(1) - expected_peak(1)) < 1e-12 * peak(1), (peak(1), expected_peak(1))
        before = text()
        drag_grip(grip, 40, 0)
        assert only_line_differs(before, text(), 'time = "').endswith(' ms"')
        # The tangent turns the velocity.
        before = text()
        drag_grip('.grip[data-y="knot[2].velocity"][data-tangent="1"]', 0, -15)
        assert float(only_line_differs(before, text(), "velocity = ").split()[2]) > 100
        # A dragged velocity breaks the limit, which is shown while the button is held; Escape cancels.
        before = text()
        x, y = place('.grip[data-y="knot[2].velocity"][data-order="1"]')
        mouse("mouseMoved", x, y)
        mouse("mousePressed", x, y, button="left", buttons=1, clickCount=1)
        mouse("mouseMoved", x, y - 40, button="left", buttons=1)
        mouse("mouseMoved", x, y - 90, button="left", buttons=1)
        browser.wait_for("document.querySelector('#verdict').classList.contains('no')")
        assert browser.run("document.querySelectorAll('#figure .badmark').length") > 0
        key("Escape")
        mouse("mouseReleased", 10, 10, button="left", clickCount=1)
        settle()
        assert text() == before
        undo_all(PVT)
        # A double click on the curve adds a knot; one on a knot removes it.
        at = json.loads(browser.run("(() => { const {toX, panels: [{toY, panel}]} = picture.drawing,"
                                    " box = picture.svg.getBoundingClientRect(), k = box.width / picture.scale,"
                                    " y = picture.exact(0.9)[0] / panel.size;"
                                    " return JSON.stringify([box.x + k * toX(0.9), box.y + k * toY(y)]); })()"))
        double_click(*at)
        assert text().count("[[knot]]") == 4 and "time = 0.9" in text(), text()
        double_click(*place('.grip[data-y="knot[3].position"]'))
        assert text() == PVT, text()
        # By keyboard alone.
        type_number("position [mm]: 2", 61.5)
        assert only_line_differs(PVT, text(), "position = ") == "position = 61.5              # the gate"
        key("ArrowDown")
        assert browser.run("document.activeElement.getAttribute('aria-label')") == "position [mm]: 3"
        type_number("value: limits.velocity [mm/s]", 90)
        browser.wait_for("document.querySelector('#verdict').classList.contains('no')")
        browser.run("picture.plot.focus(); picture.moveTo(0.25)")
        key("s", "KeyS", text="s")
        browser.wait_for(f"{TEXT}.includes('time = 0.25')")
        browser.run("document.querySelector('#knot [aria-label=\"Remove 2\"]').click()")
        browser.wait_for(f"!{TEXT}.includes('time = 0.25')")
        settle()
        undo_all(PVT)
        # Another program changes the file; then both change it.
        other = PVT.replace("three", "four")
        document.file.write_text(other)
        browser.wait_for(f"{TEXT} === {json.dumps(other)}")
        settle()


def via_points():
    with Document("via", VIA):
        drag_grip('#plane .grip[data-y="point[2].position[2]"]', 0, 40)
        line = only_line_differs(VIA, text(), "position = [1000, ")
        assert float(line.split()[3].rstrip("]")) < 1000, line
        x, y = place('#plane .grip[data-y="point[2].position[2]"]')
        u, v = place('#plane .grip[data-y="point[3].position[2]"]')
        double_click((x + u) / 2, (y + v) / 2)
        assert text().count("[[point]]") == 5, text()
        double_click(*place('#plane .grip[data-y="point[3].position[2]"]'))
        assert text().count("[[point]]") == 4, text()
        undo_all(VIA)
        # The same points are in the picture of each axis.
        drag_grip('#figure .grip[data-y="point[3].position[1]"]', 0, 10)
        only_line_differs(VIA, text(), "position = [")
        browser.run("document.querySelectorAll('#axes button')[1].click()")
        settle()
        assert browser.run("document.querySelector('#figure .grip[data-y=\"point[2].position[2]\"]') !== null")
        undo_all(VIA)


def path_points():
    with Document("plate", PATH):
        drag_grip('#plane .grip[data-y="command[3].to[2]"]', 20, -10)
        only_line_differs(PATH, text(), "to = [")
        before = text()
        x, y = place('#plane .grip[data-y="command[3].to[2]"]')
        u, v = place('#plane .grip[data-y="command[4].to[2]"]')
        double_click((x + u) / 2, (y + v) / 2)
        assert text().count("[[command]]") == 5 and text().count('type = "line"') == 4, text()
        click("undo")
        settle()
        assert text() == before
        type_number("to x [mm]: 1", 90)
        assert "to = [90, 0]              # along the edge" in text(), text()
        undo_all(PATH)


def follow_and_pt():
    with Document("cutter", FOLLOW):
        drag_grip('.grip[data-y="segment[2].slave"]', 0, -10)
        only_line_differs(FOLLOW, text(), "slave = ")
        undo_all(FOLLOW)
    with Document("steps", PT):
        drag_grip('.grip[data-y="point[2].position"]', 0, -10)
        assert only_line_differs(PT, text(), "  { time = 200, position = ").endswith("   # the middle")
        undo_all(PT)


class Executor:
    """A simulated axis on a bus of Unix sockets."""

    def __init__(self):
        file, self.bus = here / "axis.toml", here / "bus"
        self.bus.mkdir()
        file.write_text(AXIS)
        self.url = f"unix://{self.bus}"
        self.process = subprocess.Popen([jounce, "run", str(file), "--enable", "--url", self.url], stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)

    def position(self):
        """The commanded position in the last status of half a second; None: there is no status."""
        out = subprocess.run([jounce, "monitor", "pick", "--url", self.url, "--seconds", "0.5", "--json"], capture_output=True, text=True)
        lines = out.stdout.strip().split("\n")
        return json.loads(lines[-1])["position"] if lines[-1] else None

    def end(self):
        self.process.send_signal(signal.SIGTERM)
        self.process.wait(20)


def prepare(executor):
    """Opens the dialog and asks for an offer."""
    if not browser.run("document.getElementById('window').open"):
        click("stream")
        browser.wait_for("document.getElementById('stream-to') !== null")
    browser.run("document.getElementById('stream-to').value = 'pick';"
                f"document.getElementById('stream-url').value = {json.dumps(executor.url)};"
                "document.getElementById('stream-offer').click()")
    browser.wait_for("document.getElementById('stream-confirm') !== null")


def moves_and_streams():
    executor = Executor()
    try:
        with Document("pick", MOVE) as document:
            drag_grip('.grip[data-y="move.to"]', 0, -10)
            assert only_line_differs(MOVE, text(), "to = ").endswith("# the station")
            undo_all(MOVE)
            type_number("value: move.to [mm]", 25)
            for _ in range(200):  # the axis is enabled
                if executor.position() is not None:
                    break
                time.sleep(0.1)
            prepare(executor)
            facts = browser.run("document.getElementById('stream-facts').innerText")
            (here / "sent.toml").write_text(text())
            table = subprocess.run([jounce, "design", str(here / "sent.toml"), "-o", "-"], capture_output=True, text=True).stdout
            digest = next(line for line in table.split("\n") if line.startswith("# sha256")).split()[-1]
            assert digest in facts, (digest, facts)
            assert "500" in facts and "standstill" in facts, facts
            if pictures:
                browser.picture(str(pictures / "send.png"))
            assert executor.position() == 0, "nothing moves before the confirmation"
            # A change of the text makes the offer invalid.
            browser.run("act('/document', {text: state.text + '# later\\n'})")
            settle()
            click("stream-confirm")
            browser.wait_for("document.getElementById('stream-facts').innerText.includes('the text has changed since the offer')")
            prepare(executor)
            click("stream-confirm")
            browser.wait_for("document.querySelector('#stream-outcome .good') !== null")
            for _ in range(100):
                if executor.position() == 25:
                    break
                time.sleep(0.1)
            assert executor.position() == 25
            # The executor rejects a target beyond its limit.
            far = MOVE.replace("from = 0", "from = 25").replace("to = 20 ", "to = 180 ")
            browser.run(f"act('/document', {{text: {json.dumps(far)}}})")
            settle()
            prepare(executor)
            click("stream-confirm")
            browser.wait_for("document.querySelector('#stream-outcome .bad') !== null")
            said = browser.run("document.getElementById('stream-outcome').textContent")
            assert "reject" in said or "limit" in said or "position" in said, said
            print("rejected:", said)
            assert executor.position() == 25
            browser.run("document.querySelector('#window form[method=dialog] button').click()")
            assert document.file.read_text() == MOVE, "only Save writes the file"
    finally:
        executor.end()


def follows_a_live_master():
    """The label of examples/external-master follows the line from a position on; then it is stopped while it waits."""
    machine = here / "external-master"
    shutil.copytree(EXAMPLES / "external-master", machine)
    bus = here / "line"
    bus.mkdir()
    url = f"unix://{bus}"
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    run = [subprocess.Popen([jounce, "run", str(machine / "machine.toml"), "--enable", "--url", url], **quiet)]
    try:
        browser_document = Editor(machine / "cam.toml")
        open_page(browser_document)
        choose = "(id, value) => { const e = document.getElementById(id); e.value = value; e.dispatchEvent(new Event('change')); }"

        def prepared():
            browser.run("document.getElementById('window').close()")
            click("stream")
            browser.wait_for("document.getElementById('stream-to') !== null")
            browser.run(f"(() => {{ const choose = {choose}; choose('stream-to', 'label'); choose('stream-url', '{url}');"
                        "choose('stream-master', 'live'); choose('stream-begin', 'position'); choose('stream-position', '250');"
                        "document.getElementById('stream-offer').click(); })()")
            browser.wait_for("document.getElementById('stream-confirm') !== null")
            return browser.run("document.getElementById('stream-facts').innerText")

        for _ in range(100):  # until the axis is enabled
            facts = prepared()
            if "standstill" in facts:
                break
            time.sleep(0.1)
        assert "when the master passes 250 mm" in facts and "the live master of the axis" in facts, facts
        # It waits for the master, which does not move yet: Cancel ends the stream.
        click("stream-confirm")
        browser.wait_for("document.querySelector('#stream-outcome button') !== null")
        browser.run("document.querySelector('#stream-outcome button').click()")
        browser.wait_for("document.querySelector('#stream-outcome .bad') !== null")
        prepared()
        run.append(subprocess.Popen([jounce, "master", str(machine / "line.toml"), "--as", "line", "--before", "3", "--url", url], **quiet))
        click("stream-confirm")
        browser.wait_for("document.querySelector('#stream-outcome .good') !== null")
        said = browser.run("document.getElementById('stream-outcome').textContent")
        for _ in range(100):
            out = subprocess.run([jounce, "monitor", "label", "--url", url, "--seconds", "0.3", "--json"], capture_output=True, text=True)
            positions = [json.loads(line)["position"] for line in out.stdout.strip().split("\n") if '"name":"label"' in line]
            if positions and positions[-1] > 90:
                break
        assert positions[-1] > 90, (said, positions)
        assert browser.run("errors.join('; ')") == "", browser.run("errors.join('; ')")
        browser_document.end()
    finally:
        for process in run:
            process.kill()
            process.wait()


try:
    pvt_knots()
    via_points()
    path_points()
    follow_and_pt()
    moves_and_streams()
    follows_a_live_master()
    print("edited")
finally:
    browser.end()
