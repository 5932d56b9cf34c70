#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""edit_in_browser.py CHROMIUM FOLDER JOUNCE [PICTURE]: what a designer does with a cam in the editor, in a browser.

With a picture: draws PICTURE.png, PICTURE-dark.png and PICTURE-narrow.png of the first page.
"""
import json
import math
import pathlib
import signal
import subprocess
import sys
import time

import editor_page
from editor_page import (TEXT, browser, click, drag, drag_grip, field, folder, jounce, key, mouse, only_line_differs,
                         open_page, settle, text, write)

picture = sys.argv[4] if len(sys.argv) > 4 else None
SPEC = pathlib.Path(folder) / "feeder.toml"
SIDE = pathlib.Path(folder) / "feeder.toml.autosave"
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
MANY_CASES = """
[drive.tolerances]
method = "monte_carlo"
cases = 200000
[[drive.tolerances.number]]
key = "mass[1].inertia"
share = "20 %"
"""
FEEDER = """\
# A feeder.
jounce = 1
kind = "cam"
name = "feeder"
periodic = true            # repeats
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }

# Out.
[[segment]]
name = "rise"
law = "modified_sine"
end = { master = 120, slave = 50 }   # the top

[[segment]]
name = "dwell"
law = "dwell"
end = { master = 200, slave = 50 }

[[segment]]
name = "return"
law = "quintic"
end = { master = 300, slave = 10, geo_velocity = -0.6, geo_acceleration = 0 }
free = { slave = [5, 25], geo_velocity = [-1, 0], geo_acceleration = [-0.02, 0.02] }

[[segment]]
law = "quintic"
end = { master = 360, slave = 0 }

[limits]
geo_velocity = 1
geo_acceleration = 0.025

[optimize]
minimize = ["peak geo_acceleration"]

[master]
velocity = 180             # deg/s
"""
def Editor(spec=SPEC):
    return editor_page.Editor(spec)


def open_feeder(editor):
    """A page with the first text, saved."""
    open_page(editor)
    browser.run("(async () => { await act('/conflict', {use: 'mine'}); await act('/document', {text: " + json.dumps(FEEDER) +
                "}); await act('/save', {}); })()")
    browser.wait_for(f"{TEXT} === {json.dumps(FEEDER)} && state.saved")
    settle()


def peak(order):
    """The greatest value of a panel, as the picture marks it."""
    return browser.run(f"Math.max(...picture.views[0].panels[{order}].marks.map(([, y]) => Math.abs(y)))")


def expected_peak(order):
    """The same from `jounce check` of the text of the page."""
    file = pathlib.Path(folder) / "checked.toml"
    file.write_text(text())
    out = subprocess.run([jounce, "check", str(file), "--json"], capture_output=True, text=True)
    document = json.loads(out.stdout)
    name = ["position", "geo_velocity", "geo_acceleration", "geo_jerk"][order]
    return max(max(abs(segment[name]["min"]["value"]), abs(segment[name]["max"]["value"])) for segment in document["segments"])


def knots_are_dragged(editor):
    open_page(editor)
    before = text()
    assert before == FEEDER
    drag(1, 0, 30, 0)
    line = only_line_differs(before, text(), "end = { master = 1")
    assert line.endswith("slave = 50 }   # the top"), line
    assert abs(peak(1) - expected_peak(1)) < 1e-12 * peak(1), (peak(1), expected_peak(1))
    shown = browser.run("[...document.querySelectorAll('#figure .halo')].map((t) => t.textContent).join(' ')")
    assert browser.run(f"number({peak(1)!r})") in shown, (peak(1), shown)
    assert browser.run("document.querySelector('#knots tbody').rows[1].querySelector('[aria-label=\"master of segment 1\"]').value") in line

    # A dwell moves with its knot; the position snaps to steps of the axis.
    before = text()
    drag(1, 0, 0, -25)
    changed = [new for old, new in zip(before.split("\n"), text().split("\n")) if old != new]
    slaves = {line.split("slave = ")[1].split(" }")[0] for line in changed}
    assert len(changed) == 2 and len(slaves) == 1 and float(slaves.pop()) > 50, changed

    # The velocity and the acceleration of a knot between two quintics.
    before = text()
    drag(3, 1, 0, 20)
    line = only_line_differs(before, text(), "end = { master = 300, slave = 10, geo_velocity = ")
    assert float(line.split("geo_velocity = ")[1].split(",")[0]) < -0.6, line
    drag(3, 2, 0, -10)
    assert "geo_acceleration = 0 }" not in text().split("name = \"return\"")[1].split("free")[0], text()
    assert browser.run("document.querySelector('.grip[data-knot=\"1\"][data-order=\"1\"]')") is None, "a dwell gives the velocity"

    # Escape leaves everything as it is; the preview showed another curve.
    curve = "JSON.stringify(picture.views[0].curves[0].pieces)"
    before, was = text(), browser.run(curve)
    drag(1, 0, -40, 0, drop=False)
    assert browser.run(curve) != was
    key("Escape")
    mouse("mouseReleased", 10, 10, button="left", clickCount=1)
    settle()
    assert text() == before and browser.run(curve) == was

    # A preview names limits: the velocity breaks its limit while the knot is held.
    drag(1, 0, -250, 0, drop=False)
    browser.wait_for("document.querySelector('#verdict').classList.contains('no')")
    assert browser.run("document.querySelectorAll('#figure .badmark').length") > 0
    key("Escape")
    mouse("mouseReleased", 10, 10, button="left", clickCount=1)
    settle()

    for _ in range(4):  # faster than the answers
        click("undo")
    settle()
    assert text() == FEEDER
    assert browser.run("document.getElementById('undo').disabled")
    for _ in range(4):
        click("redo")
        settle()
    assert text() == before
    assert SPEC.read_text() == FEEDER, "only Save writes the file"
    click("save")
    browser.wait_for("document.getElementById('saved').textContent === 'saved'")
    assert SPEC.read_text() == before
    assert not SIDE.exists()


def keyboard_alone(editor):
    """Changes a number, a law and the text, undoes and saves, without a pointer."""
    open_feeder(editor)
    for _ in range(200):  # by Tab to the slave position of segment 1
        key("Tab")
        if browser.run("document.activeElement.getAttribute('aria-label')") == "slave of segment 1":
            break
    else:
        raise AssertionError("Tab never reaches the table")
    browser.run("document.activeElement.select()")
    write("55.5")
    key("Enter", text="\r")
    browser.wait_for(f"{TEXT}.includes('slave = 55.5')")
    settle()
    assert text().count("slave = 55.5") == 2, "the dwell moves with its knot"
    assert browser.run("document.activeElement.getAttribute('aria-label')") == "slave of segment 1"
    key("ArrowDown")
    assert browser.run("document.activeElement.getAttribute('aria-label')") == "slave of segment 2"
    write("5x")
    key("Enter", text="\r")
    assert browser.run("document.activeElement.getAttribute('aria-invalid')") == "true"
    assert "not a number" in browser.run("document.getElementById('notices').textContent")
    key("Escape")
    key("z", "KeyZ", modifiers=2)
    browser.wait_for(f"{TEXT} === {json.dumps(FEEDER)}")
    settle()
    browser.run("document.querySelector('[aria-label=\"law of segment 1\"]').focus()")
    for letter in "3-4":
        key(letter, text=letter)
    browser.wait_for(f"{TEXT}.includes('law = \"345\"')")
    settle()
    assert abs(peak(1) - 15 / 8 * 50 / 120) < 1e-12 or peak(1) > 15 / 8 * 50 / 120
    browser.run("document.getElementById('text').focus(); document.getElementById('text').setSelectionRange(0, 0)")
    write("# typed\n")
    browser.wait_for("state.text.startsWith('# typed')")
    assert not browser.run("pane.isTyped")
    key("s", "KeyS", modifiers=2)
    browser.wait_for("document.getElementById('saved').textContent === 'saved'")
    assert SPEC.read_text().startswith("# typed\n# A feeder.")


def segments(editor):
    open_feeder(editor)
    rows = "document.querySelectorAll('#knots tbody tr').length"
    assert browser.run(rows) == 5
    browser.run("picture.moveTo(60)")
    click("split")
    browser.wait_for(f"{rows} === 6")
    settle()
    assert "# Out.\n[[segment]]\nname = \"rise\"" in text() and "   # the top" in text(), text()
    browser.run("document.querySelector('[aria-label=\"Merge with the next segment: segment 1\"]').click()")
    browser.wait_for(f"{rows} === 5")
    browser.run("document.querySelector('[aria-label=\"Delete: segment 2\"]').click()")
    browser.wait_for(f"{rows} === 4")
    settle()
    while not browser.run("document.getElementById('undo').disabled"):
        click("undo")
        settle()
        if text() == FEEDER:
            break
    browser.run("document.getElementById('whole-what').value = 'scale slave'; document.getElementById('whole-by').value = '2';"
                "document.querySelector('#whole button').click()")
    browser.wait_for(f"{TEXT}.includes('slave = 100')")
    click("undo")
    settle()
    # All laws with their values, and the peaks with each.
    browser.run("document.querySelector('[aria-label=\"compare laws: segment 1\"]').click()")
    laws = json.loads(subprocess.run([jounce, "laws", "--json"], capture_output=True, text=True).stdout)
    browser.wait_for(f"document.querySelectorAll('#window tbody tr').length === {len(laws)}")
    cell = "[...document.querySelectorAll('#window tbody tr')].find((row) => row.children[0].textContent === '3-4-5 polynomial').children"
    assert browser.run(f"{cell}[1].textContent") == "1.875"
    browser.wait_for("![...document.querySelectorAll('#window td')].some((cell) => cell.textContent === '…')")
    browser.run(f"{cell}[8].querySelector('button').click()")
    browser.wait_for(f"{TEXT}.includes('law = \"345\"')")
    settle()


def errors_in_the_text(editor):
    open_page(editor)
    good = text()
    bad = good.replace("slave = 50 }   # the top", "slave = }   # the top")
    browser.run(f"{TEXT.split('.value')[0]}.value = {json.dumps(bad)}; {TEXT.split('.value')[0]}.dispatchEvent(new Event('input'))")
    browser.wait_for("document.querySelector('.left').classList.contains('stale-curves')")
    line = bad.split("\n").index(next(each for each in bad.split("\n") if "slave = }" in each)) + 1
    assert browser.run(f"document.getElementById('gutter').children[{line - 1}].className") == "error"
    browser.run("document.querySelector('#findings button').click()")
    area = TEXT.split(".value")[0]
    selected = browser.run(f"{area}.value.slice({area}.selectionStart, {area}.selectionEnd)")
    assert "slave = }" in selected, selected
    click("undo")
    browser.wait_for("!document.querySelector('.left').classList.contains('stale-curves')")
    assert text() == good


def disk_and_conflict(editor):
    open_feeder(editor)
    other = FEEDER.replace("# A feeder.", "# Another program.")
    SPEC.write_text(other)
    browser.wait_for(f"{TEXT} === {json.dumps(other)}")
    settle()
    drag(1, 0, 30, 0)
    mine = text()
    SPEC.write_text(FEEDER)
    browser.wait_for("document.querySelector('.notice[data-key=conflict]') !== null")
    assert text() == mine and SPEC.read_text() == FEEDER
    click("save")
    settle()
    assert SPEC.read_text() == FEEDER, "Save does not replace the change of another program"
    browser.run("[...document.querySelectorAll('.notice[data-key=conflict] button')].find((b) => b.textContent === 'Compare').click()")
    browser.wait_for("document.querySelectorAll('#window pre .add').length > 0 && document.querySelector('#window figure.live') !== null")
    browser.run("document.querySelector('#window form button').click()")
    browser.run("[...document.querySelectorAll('.notice[data-key=conflict] button')].find((b) => b.textContent.startsWith('Use')).click()")
    browser.wait_for(f"{TEXT} === {json.dumps(FEEDER)}")
    assert browser.run("document.querySelector('.notice[data-key=conflict]')") is None
    settle()
    click("undo")
    browser.wait_for(f"{TEXT} === {json.dumps(mine)}")


def killed_and_reloaded(editor):
    """A reload shows the same; so does the next editor after kill -9."""
    open_page(editor)
    drag(1, 0, -20, 0)
    mine = text()
    open_page(editor)
    assert text() == mine
    disk = SPEC.read_text()
    editor.end(signal.SIGKILL)
    browser.wait_for("document.querySelector('.notice[data-key=lost]') !== null")
    assert SPEC.read_text() == disk and SIDE.exists()
    again = Editor()
    open_page(again)
    assert text() == mine
    assert browser.run("document.querySelector('.notice[data-key=recovered]') !== null")
    click("undo")
    browser.wait_for(f"{TEXT} === {json.dumps(disk)}")
    click("redo")
    settle()
    return again


def two_pages(editor):
    """A second page on the same file shows the change of the first, and cannot overwrite it."""
    open_page(editor)
    first = browser.session
    browser.session = None
    target = browser.call("Target.createTarget", url=editor.address)["targetId"]
    second = browser.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
    try:
        browser.session = second
        browser.wait_for("typeof state !== 'undefined' && state !== null")
        browser.session = first
        browser.run("change({do: 'set', knot: 1, key: 'slave', value: 42.5})")
        browser.wait_for(f"{TEXT}.includes('slave = 42.5')")
        browser.session = second
        browser.wait_for(f"{TEXT}.includes('slave = 42.5')")
        # Both type at the same time: the second page asks, and both texts stay.
        area = TEXT.split('.value')[0]
        browser.run(f"load = async () => {{}}; {area}.value += '# second\\n';"
                    f"{area}.dispatchEvent(new Event('input')); clearTimeout(typing)")
        browser.session = first
        browser.run(f"{area}.value += '# first\\n'; {area}.dispatchEvent(new Event('input'))")
        browser.wait_for("state.text.endsWith('# first\\n')")
        browser.session = second
        browser.run("sendTyped()")
        browser.wait_for("document.querySelector('.notice[data-key=other]') !== null")
        assert text().endswith("# second\n")
        browser.run("[...document.querySelectorAll('.notice[data-key=other] button')][0].click()")
        browser.wait_for("state.text.endsWith('# second\\n')")
    finally:
        browser.session = None
        browser.call("Target.closeTarget", targetId=target)
        browser.session = first
    browser.wait_for(f"{TEXT}.endsWith('# second\\n')")
    click("undo")
    browser.wait_for(f"{TEXT}.endsWith('# first\\n')")


def optimizer():
    editor = Editor()
    try:
        open_feeder(editor)
        was = peak(2)
        click("optimize")
        browser.wait_for("!document.getElementById('take').hidden")
        browser.wait_for("document.querySelector('#outcome .plot') !== null")
        click("take")
        browser.wait_for("document.getElementById('job').hidden")
        settle()
        assert peak(2) < was, (peak(2), was)
        assert "# Out." in text() and "   # the top" in text()
        click("undo")
        browser.wait_for(f"{TEXT} === {json.dumps(FEEDER)}")
        click("optimize")
        browser.wait_for("!document.getElementById('discard').hidden")
        click("discard")
        browser.wait_for("document.getElementById('job').hidden")
        assert text() == FEEDER
    finally:
        editor.end()


def arrives(name):
    """Waits for a downloaded file."""
    file = pathlib.Path(folder) / name
    for _ in range(200):
        if file.exists() and file.stat().st_size > 0:
            return
        time.sleep(0.05)
    raise AssertionError(name)


def exports(editor):
    """The report and the tables are downloaded; the dialog shows the output of `jounce convert`."""
    open_feeder(editor)
    browser.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=folder)
    click("report")
    arrives("feeder.html")
    assert (pathlib.Path(folder) / "feeder.html").read_text().startswith("<!doctype html>")
    click("table")

    def choose(**members):
        for key, value in members.items():
            browser.run(f"(() => {{ const e = document.getElementById('export-{key}'); e.value = '{value}'; e.onchange(); }})()")
        browser.wait_for("!document.getElementById('export-download').disabled")
        shown = browser.run("document.getElementById('export-text').textContent")
        click("export-download")
        return shown

    shown = choose(form="csv")
    arrives("feeder.csv")
    converted = subprocess.run([jounce, "convert", str(SPEC), str(pathlib.Path(folder) / "converted.csv")], capture_output=True, text=True)
    assert browser.run(f"raisedUnit({json.dumps(converted.stdout.strip())})") == shown, (shown, converted.stdout)
    assert (pathlib.Path(folder) / "feeder.csv").read_text() == (pathlib.Path(folder) / "converted.csv").read_text()
    choose(form="npy")  # binary: the bytes stay
    arrives("feeder.npy")
    assert (pathlib.Path(folder) / "feeder.npy").read_bytes()[:8] == b"\x93NUMPY\x01\x00"
    browser.run("document.getElementById('export-form').value = 'xps'; document.getElementById('export-form').onchange()")
    browser.wait_for("document.getElementById('export-text').textContent.includes('is for motions over time')")
    assert browser.run("document.getElementById('export-download').disabled")
    choose(over="time")
    arrives("feeder.trj")
    choose(form="csv", over="master")
    browser.run("document.getElementById('window').close()")


def validation(editor):
    """The numbers of *Validate* are those of `jounce validate`; a long one is canceled; the result belongs to its text."""
    open_feeder(editor)
    click("validate")
    browser.wait_for("!document.getElementById('proof-verdict').hidden")
    proven = "document.getElementById('proof-text').textContent"
    expected = subprocess.run([jounce, "validate", str(SPEC)], capture_output=True, text=True).stdout.strip()
    assert browser.run(f"raisedUnit({json.dumps(expected)})") == browser.run(proven), (expected, browser.run(proven))
    assert browser.run("document.getElementById('proof-stale').hidden")
    browser.run("change({do: 'append'})")
    browser.wait_for("!document.getElementById('proof-stale').hidden")
    click("proof-close")
    browser.wait_for("document.getElementById('proof').hidden")
    long = (EXAMPLES / "fastest-for-motor" / "move.toml").read_text() + MANY_CASES
    browser.run("act('/document', {text: " + json.dumps(long) + "})")
    browser.wait_for(f"{TEXT} === {json.dumps(long)}")
    settle()
    click("validate")
    browser.wait_for("document.getElementById('proof-step').textContent.includes('tolerances')")
    click("proof-stop")
    browser.wait_for("document.getElementById('proof-step').textContent === 'stopped: nothing is proven'")
    click("proof-close")
    browser.wait_for("document.getElementById('proof').hidden")
    open_feeder(editor)


def compared_with_the_commit():
    """The difference to the newest commit: its lines, both curves, and the output of `jounce diff`."""
    here = pathlib.Path(folder) / "repository"
    here.mkdir()
    spec = here / "feeder.toml"
    spec.write_text(FEEDER)
    git = ["git", "-C", str(here), "-c", "user.name=x", "-c", "user.email=x@example.com"]
    for words in ["init", "-q"], ["add", "."], ["commit", "-q", "-m", "feeder"]:
        subprocess.run([*git, *words], check=True)
    spec.write_text(FEEDER.replace("slave = 10,", "slave = 12,"))
    editor = Editor(spec)
    try:
        open_page(editor)
        click("difference")
        browser.wait_for("document.getElementById('window').open")
        assert "The text is that of the file." in browser.run("document.getElementById('window').textContent")
        browser.run("document.querySelector('#window-body button').click()")
        browser.wait_for("document.getElementById('window-title').textContent === 'Comparison with the newest commit'")
        browser.wait_for("document.querySelector('#window figure.live') !== null")
        lines = browser.run("[...document.querySelectorAll('#window pre .add')].map((line) => line.textContent.trim()).join()")
        assert lines == "+ end = { master = 300, slave = 12, geo_velocity = -0.6, geo_acceleration = 0 }", lines
        before = here / "before.toml"
        before.write_text(FEEDER)
        expected = subprocess.run([jounce, "diff", str(before), str(spec)], capture_output=True, text=True).stdout
        peak_line = next(line for line in expected.split("\n") if "differs by" in line).strip()
        assert peak_line.split("differs by")[1] in browser.run("document.getElementById('window').textContent"), (peak_line, expected)
    finally:
        editor.end()


def layout(editor):
    """Nothing is wider than its window, in both schemes; all controls have names."""
    open_page(editor)
    for width in (1400, 1000, 390):
        browser.call("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=width < 600)
        settle()
        assert browser.run("document.documentElement.scrollWidth") <= width, width
    browser.call("Emulation.setDeviceMetricsOverride", width=1400, height=900, deviceScaleFactor=1, mobile=False)
    unnamed = browser.run("[...document.querySelectorAll('button,input,select,textarea')].filter((e) => e.checkVisibility() &&"
                          " !(e.getAttribute('aria-label') || e.textContent.trim() || e.labels?.length)).map((e) => e.outerHTML).join()")
    assert unnamed == "", unnamed


def contrast():
    """Texts have a contrast of 4.5 to the page in both schemes (WCAG 2.1, AA)."""
    script = """(() => {
      const channel = (c) => c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
      const light = (rgb) => {
        const [r, g, b] = rgb.map((c) => channel(c / 255));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      const parse = (text) => {
        const c = document.createElement('canvas').getContext('2d');
        c.fillStyle = text;
        c.fillRect(0, 0, 1, 1);
        return [...c.getImageData(0, 0, 1, 1).data];
      };
      const behind = (e) => {
        for (; e; e = e.parentElement) {
          const c = parse(getComputedStyle(e).backgroundColor);
          if (c[3] === 255) return c;
        }
        return [255, 255, 255, 255];
      };
      const bad = [];
      for (const e of document.querySelectorAll('h1,h2,p,button,input,select,textarea,th,td,li b,small,summary,#gutter div,.notice span')) {
        if (!e.checkVisibility() || e.disabled) continue;
        const [a, b] = [light(parse(getComputedStyle(e).color)), light(behind(e))];
        const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        if (ratio < 4.5) bad.push(`${e.tagName} ${e.id} ${e.textContent.slice(0, 20)} ${ratio.toFixed(2)}`);
      }
      return bad.join('; ');
    })()"""
    for scheme in ("light", "dark"):
        browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        settle()
        bad = browser.run(script)
        assert bad == "", (scheme, bad)
    browser.call("Emulation.setEmulatedMedia", features=[])


SPLINE = """\
jounce = 1
kind = "cam"
name = "spline"
periodic = true
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }

[[segment]]
law = "quintic_spline"
points = [ { master = 90, slave = 20 }, { master = 180, slave = 30 } ]   # measured
end = { master = 360, slave = 0 }

[switches]
of = "master"

[[switch]]
track = 2
first_on_position = 100   # glue
last_on_position = 140
"""


def points_and_switches():
    """A new file begins with a template; points and switches move by mouse and keyboard; measured points are fitted."""
    file = pathlib.Path(folder) / "new.toml"
    editor = Editor(file)
    try:
        browser.open(editor.address)
        browser.wait_for("document.querySelectorAll('#gallery .card img').length >= 8")
        assert browser.run("[...document.querySelectorAll('#gallery img')].every((i) => i.complete && i.naturalWidth > 0)")
        browser.run("[...document.querySelectorAll('#gallery .card')].find((c) => c.textContent.startsWith('cam')).click()")
        browser.wait_for("document.querySelector('figure.live') !== null && document.getElementById('gallery').hidden")
        assert "kind = \"cam\"" in text() and not file.exists()
        browser.run("act('/document', {text: " + json.dumps(SPLINE) + "})")
        browser.wait_for(f"{TEXT} === {json.dumps(SPLINE)} && document.querySelector('.grip[data-point=\"2\"]') !== null")
        settle()
        before = text()
        drag_grip('.grip[data-point="2"]', 30, -20)
        line = only_line_differs(before, text(), "points = [ { master = 90, slave = 20 }, ")
        assert line.endswith("]   # measured") and "master = 180, slave = 30" not in line, line
        before = text()
        drag_grip('.grip[data-switch="1"][data-x="first"]', -25, 0)
        line = only_line_differs(before, text(), "first_on_position = ")
        assert float(line.split()[2]) < 100 and line.endswith("# glue"), line
        before = text()
        field("points", "slave [mm]: 1 of segment 1", 21.5)
        only_line_differs(before, text(), "points = [ { master = 90, slave = 21.5 }, ")
        before = text()
        field("switches", "to [deg]: switch 1, track 2", 150)
        assert only_line_differs(before, text(), "last_on_position") == "last_on_position = 150"
        # Measured points: the greatest distance is that of the curve of the library.
        csv = "master [deg],slave [mm]\\n" + "\\n".join(f"{x},{20 - 20 * math.cos(math.radians(x)):.4f}" for x in range(0, 361, 10))
        browser.run(f"takePoints(new File(['{csv}'], 'measured.csv'))")
        browser.wait_for("document.querySelectorAll('.measured circle').length > 30")
        said = browser.run("document.getElementById('fit-facts').textContent")
        assert said.startswith("measured.csv: 37 points; greatest distance "), said
        browser.run("document.getElementById('fit-tolerance').value = '0.05'; document.getElementById('fit-period').value = '360'; "
                    "document.getElementById('fit-form').requestSubmit()")
        browser.wait_for("document.getElementById('window').open && document.querySelector('#window figure.live') !== null")
        browser.run("document.querySelector('#window-body button').click()")
        browser.wait_for(f"{TEXT}.includes('Fitted by')")
        settle()
        shown = browser.run("document.getElementById('fit-facts').textContent").split("greatest distance ")[1].split(" ")[0]
        distance = float(shown.replace("×10", "e").translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")))
        assert distance <= 0.05, distance
        browser.run("act('/undo')")
        browser.wait_for(f"!{TEXT}.includes('Fitted by')")
        assert browser.run("errors.join('; ')") == "", browser.run("errors.join('; ')")
    finally:
        editor.end()


def draw(editor):
    open_page(editor)
    browser.picture(picture + ".png")
    browser.picture(picture + "-dark.png", dark=True)
    browser.call("Emulation.setDeviceMetricsOverride", width=390, height=800, deviceScaleFactor=1, mobile=True)
    browser.picture(picture + "-narrow.png")


def test():
    editor = Editor()
    try:
        knots_are_dragged(editor)
        keyboard_alone(editor)
        segments(editor)
        errors_in_the_text(editor)
        disk_and_conflict(editor)
        exports(editor)
        validation(editor)
        layout(editor)
        contrast()
        editor = killed_and_reloaded(editor)
        two_pages(editor)
        assert browser.run("errors.join('; ')") == "", browser.run("errors.join('; ')")
        browser.open(editor.address.split("#")[0])
        browser.wait_for("document.querySelector('.notice[data-key=token]') !== null")
        assert browser.run("document.getElementById('text').value") == ""
    finally:
        said = editor.end()
    assert "the unsaved text is in" in said, said
    points_and_switches()
    compared_with_the_commit()
    optimizer()
    print("edited")


SPEC.write_text(FEEDER)
try:
    if picture:
        shown = Editor()
        draw(shown)
        shown.end()
    else:
        test()
finally:
    browser.end()
