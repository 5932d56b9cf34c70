#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""report_in_browser.py CHROMIUM FOLDER JOUNCE CHART_VALUES: what a reader does with a report, in a browser.

The values that the page shows at its cursor are compared with those of the library, to the last digit.
"""
import json
import math
import os
import pathlib
import subprocess
import sys

from browser import Browser

program, folder, jounce, chart_values = sys.argv[1:5]
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
PUSHER = EXAMPLES / "packaging-pusher" / "cam.toml"
PLOT = "document.querySelector('.plot')"
browser = Browser(program, folder)


def report(spec, *options):
    page = pathlib.Path(folder) / "page.html"
    subprocess.run([jounce, "report", str(spec), "-o", str(page), *map(str, options)], stdout=subprocess.DEVNULL,
                   env=dict(os.environ, SOURCE_DATE_EPOCH="86400"))
    browser.open(page.as_uri())
    browser.wait_for("document.querySelector('figure.live') !== null")
    settle()


def settle():
    """Waits until the page has drawn."""
    twice = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
    browser.call("Runtime.evaluate", expression=twice, awaitPromise=True)


def press(key, times=1, shift=False):
    for _ in range(times):
        options = f"{{key: '{key}', shiftKey: {str(shift).lower()}, cancelable: true}}"
        browser.run(f"{PLOT}.dispatchEvent(new KeyboardEvent('keydown', {options}))")
    settle()


def click(text):
    browser.run(f"[...document.querySelectorAll('.tools button')].find((b) => b.textContent === '{text}').click()")
    settle()


def mouse(kind, x, y, **more):
    browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)
    settle()


def box():
    return json.loads(browser.run(f"JSON.stringify({PLOT}.getBoundingClientRect())"))


def shown():
    """The place of the cursor, as its full number, and the texts of the column "value"."""
    place = browser.run(f"{PLOT}.getAttribute('aria-valuenow')")
    return place, browser.run("[...document.querySelectorAll('.at tbody tr')].map((row) => row.children[1].textContent)")


def ticks():
    """The texts of the x axis, which show the window."""
    return browser.run("[...document.querySelectorAll('.plot svg > text.soft.mid')].map((t) => t.textContent).join(' ')")


def expect_values(spec, view, seen):
    places = "\n".join(place for place, _ in seen)
    computed = subprocess.run([chart_values, str(spec), str(view)], input=places, capture_output=True, text=True, check=True)
    expected = json.loads(computed.stdout)
    for (place, texts), want in zip(seen, expected):
        assert texts == want["texts"], (spec, view, place, texts, want["texts"])


def cursor_values(spec):
    """By pointer, by keys and at the joints, over the master and over time."""
    report(spec)
    views = browser.run("[...document.querySelectorAll('.tools button')].filter((b) => b.textContent.startsWith('over ')).length") or 1
    for view in range(views):
        if view > 0:
            click("over time")
        seen = []
        at = box()
        for share in (0.11, 0.37, 0.5, 0.83):
            mouse("mouseMoved", at["x"] + share * at["width"], at["y"] + 90)
            seen.append(shown())
        for key in ("ArrowRight", "ArrowUp", "PageUp", "PageUp", "PageDown", "Home", "End", "ArrowLeft"):
            press(key)
            seen.append(shown())
        assert len({place for place, _ in seen}) >= 8, seen
        expect_values(spec, view, seen)


def zoom_and_pan():
    report(PUSHER)
    whole = ticks()
    assert whole.startswith("1 push 2 back 3 wait for the carton") and whole.endswith("330 360"), whole
    press("+", 3)
    near = ticks()
    assert near != whole
    press("ArrowRight", shift=True)
    assert ticks() != near
    press("0")
    assert ticks() == whole
    at = box()
    point = (at["x"] + at["width"] / 2, at["y"] + 100)
    mouse("mouseWheel", *point, deltaX=0, deltaY=-100)
    assert ticks() == whole, "the wheel scrolls the page until the picture has the focus"
    mouse("mousePressed", *point, button="left", clickCount=1)
    mouse("mouseReleased", *point, button="left", clickCount=1)
    browser.run(f"{PLOT}.focus()")
    at = box()
    point = (at["x"] + at["width"] / 2, at["y"] + 100)
    for _ in range(4):
        mouse("mouseWheel", *point, deltaX=0, deltaY=-120)
    browser.wait_for(f"document.querySelector('.plot svg > text.soft.mid') && {json.dumps(whole)} !== "
                     "[...document.querySelectorAll('.plot svg > text.soft.mid')].map((t) => t.textContent).join(' ')")
    zoomed = ticks()
    mouse("mousePressed", *point, button="left", clickCount=1)
    for step in range(1, 5):
        mouse("mouseMoved", point[0] - 30 * step, point[1], button="left", buttons=1)
    mouse("mouseReleased", point[0] - 120, point[1], button="left", clickCount=1)
    assert ticks() != zoomed, "dragging pans"
    click("whole")
    assert ticks() == whole
    browser.call("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=2)

    def touch(kind, *xs):
        browser.call("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": point[1], "id": i} for i, x in enumerate(xs)])
        settle()

    middle = point[0]
    touch("touchStart", middle - 40, middle + 40)
    for step in range(1, 6):
        touch("touchMove", middle - 40 - 30 * step, middle + 40 + 30 * step)
    touch("touchEnd")
    assert ticks() != whole, "two fingers zoom"
    browser.call("Emulation.setTouchEmulationEnabled", enabled=False)


def rows_and_findings():
    report(EXAMPLES / "pmc600-cam" / "cam.toml")
    name = "[...document.querySelectorAll('th')].find((head) => head.textContent === 'segment')"
    assert browser.run(f"getComputedStyle({name}).textAlign") == "left", "names are text, although they begin with a number"
    browser.run("document.querySelectorAll('tr[data-from]')[1].dispatchEvent(new PointerEvent('pointerenter'))")
    settle()
    assert browser.run("document.querySelectorAll('.plot .piece').length") == 4, "one in each panel"
    browser.run("document.querySelectorAll('tr[data-from]')[1].dispatchEvent(new PointerEvent('pointerleave'))")
    settle()
    assert browser.run("document.querySelectorAll('.plot .piece').length") == 0
    whole = ticks()
    click("over time")
    browser.run("document.querySelector('tr.broken .go').click()")
    settle()
    assert ticks() != whole
    place, texts = shown()
    where = browser.run("document.querySelector('tr.broken').dataset.from")
    assert place == where, (place, where)
    assert browser.run(f"document.activeElement === {PLOT}")
    assert texts[1].startswith("−3.39227"), texts


def before_and_difference():
    better = pathlib.Path(folder) / "better.toml"
    better.write_text(PUSHER.read_text().replace("slave = 180", "slave = 170"))
    report(better, "--before", PUSHER)
    press("PageDown", 2)
    heads = browser.run("[...document.querySelectorAll('.at thead th')].map((h) => h.textContent)")
    assert heads == ["quantity", "value", "before", "difference", "unit", "limit", "used"], heads
    cells = browser.run("[...document.querySelector('.at tbody tr').children].slice(1, 4).map((cell) => cell.textContent)")
    value, before, difference = (float(cell.replace("−", "-")) for cell in cells)
    assert abs(value - before - difference) < 1e-6 and before != value, cells
    press("d")
    assert browser.run("document.querySelector('.plot .label').textContent") == "difference of position [mm]"


def several_axes():
    """One cursor for the charts of all axes; the rows of a table lead to the chart of their axis."""
    report(EXAMPLES / "scara" / "pick-and-place.toml")
    charts = browser.run("document.querySelectorAll('figure.live').length")
    headings = browser.run("[...document.querySelectorAll('h2')].map((h) => h.textContent).join()")
    assert charts == 6 and "Path" in headings and "a1: Curve" in headings and headings.endswith("Spec"), (charts, headings)
    press("ArrowUp", 13)
    cursors = browser.run("[...document.querySelectorAll('.plot')].map((plot) => plot.getAttribute('aria-valuenow'))")
    assert len(cursors) == 6 and len(set(cursors)) == 1 and float(cursors[0]) > 0, cursors
    second = "document.querySelectorAll('figure.live')[1]"
    browser.run(f"[...document.querySelectorAll('tr[data-from] .go')].find((go) => {second}.compareDocumentPosition(go) & 4).click()")
    settle()
    assert browser.run(f"{second}.contains(document.activeElement)")


def large_table():
    """A table that is too large for the page: the picture is a band, and the cursor shows the range of its block."""
    folder_path = pathlib.Path(folder)
    rows = [f"{i / 1000},{math.sin(i / 50):.9f},{20 * math.cos(i / 50):.9f}" for i in range(20_000)]
    (folder_path / "large.csv").write_text("time,position,velocity\n" + "\n".join(rows) + "\n")
    spec = folder_path / "large.toml"
    spec.write_text('jounce = 1\nkind = "pvt"\nname = "large"\nunits = { position = "mm", time = "s" }\npoints = "large.csv"\n')
    report(spec)
    assert (folder_path / "page.html").stat().st_size < 1_000_000
    assert "19999 segments" in browser.run("document.querySelector('.live').innerText")
    assert browser.run("document.querySelectorAll('.plot .band').length") == 4
    press("ArrowUp", 5)
    place, texts = shown()
    low, high = (float(text.replace("−", "-")) for text in texts[0].split(" … "))
    assert low - 1e-9 <= math.sin(20 * float(place)) <= high + 1e-9 and high - low < 0.5, (place, texts)


TEXTS_THAT_COLLIDE = """(() => {
  const out = [], frame = document.querySelector('.plot svg').getBoundingClientRect();
  const texts = [...document.querySelectorAll('.plot svg text')].map((t) => [t.textContent, t.getBoundingClientRect()]);
  texts.forEach(([words, a], i) => {
    if (a.left < frame.left - 1 || a.right > frame.right + 1 || a.bottom > frame.bottom + 1) out.push('outside: ' + words);
    for (const [other, b] of texts.slice(i + 1))
      if (Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 4)
        out.push(words + ' covers ' + other);
  });
  if (document.documentElement.scrollWidth > innerWidth) out.push('the page scrolls sideways');
  return out; })()"""
HOSTILE = "</script><img src=x onerror=alert(1)> \"quoted\" & others, a name that is longer than any picture is wide"


def screen(width):
    browser.call("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=width < 600)
    settle()


def layout():
    """No text is outside the picture or covers another, for long numbers and names, wide and narrow, at each zoom."""
    hostile = pathlib.Path(folder) / "hostile.toml"
    hostile.write_text(PUSHER.read_text().replace('"packaging pusher"', f"'{HOSTILE}'").replace('"push"', f"'{HOSTILE}'"))
    gear = EXAMPLES / "pmc600-gear-in-pos" / "gear.toml"
    for spec, *options in (PUSHER,), (gear,), (hostile, "--before", PUSHER):
        for width in 1120, 390:
            screen(width)
            report(spec, *options)
            for view in "over master", "over time":
                if browser.run(f"[...document.querySelectorAll('.tools button')].some((b) => b.textContent === '{view}')"):
                    click(view)
                press("ArrowUp", 13)
                for zoom in range(0, 30, 2):
                    found = browser.run(TEXTS_THAT_COLLIDE)
                    assert not found, (spec, width, view, zoom, found)
                    press("+", 2)
    screen(1120)


def print_on_paper():
    """All columns are on the page; the colors are those of paper, also for a reader with a dark screen."""
    width_of_a4 = 688  # px, without the margins
    screen(width_of_a4)
    report(EXAMPLES / "pmc600-cam" / "cam.toml")
    dark = [{"name": "prefers-color-scheme", "value": "dark"}]
    browser.call("Emulation.setEmulatedMedia", media="print", features=dark)
    wide = browser.run("[...document.querySelectorAll('.scroll')].filter((s) => s.scrollWidth > s.clientWidth + 1).map((s) => s.innerText)")
    assert not wide, wide
    assert browser.run("getComputedStyle(document.querySelector('.tools')).display") == "none"
    assert browser.run("getComputedStyle(document.documentElement).getPropertyValue('--paper')").strip() in ("#fff", "#ffffff")
    browser.call("Emulation.setEmulatedMedia", media="", features=[])
    screen(1120)


def right_button():
    """The menu of the right button may take its release: the picture does not pan afterwards."""
    report(PUSHER)
    press("+", 3)
    near = ticks()
    at = box()
    mouse("mousePressed", at["x"] + 400, at["y"] + 100, button="right", buttons=2, clickCount=1)
    for step in range(1, 5):
        mouse("mouseMoved", at["x"] + 400 - 30 * step, at["y"] + 100)
    assert ticks() == near
    mouse("mouseReleased", at["x"] + 280, at["y"] + 100, button="right", clickCount=1)


def errors():
    """The console stays empty; the policy blocks a script that is not the page's own, and every request."""
    browser.call("Page.addScriptToEvaluateOnNewDocument", source="window.errors = [];"
                 "addEventListener('error', (e) => errors.push(e.message));"
                 "addEventListener('securitypolicyviolation', (e) => errors.push(e.violatedDirective));")
    report(PUSHER)
    assert browser.run("errors.length") == 0, browser.run("errors")
    assert browser.run("document.querySelector('footer').textContent").endswith(" on 1970-01-02")
    browser.run("(() => { const s = document.createElement('script'); s.textContent = 'window.injected = 1'; document.body.append(s); })()")
    browser.run("new Image().src = 'http://localhost:9/x.png'")
    browser.wait_for("errors.length === 2")
    assert browser.run("window.injected === undefined")


def without_script():
    """The still page is complete: the figures are visible, and nothing of the script is."""
    browser.call("Emulation.setScriptExecutionDisabled", value=True)
    browser.open((pathlib.Path(folder) / "page.html").as_uri())
    browser.wait_for("document.querySelector('footer') !== null")
    assert browser.run("document.querySelectorAll('.live').length") == 0
    assert browser.run("getComputedStyle(document.querySelector('.jf.wide')).display") == "block"
    browser.call("Emulation.setScriptExecutionDisabled", value=False)


try:
    errors()
    without_script()
    cursor_values(PUSHER)
    cursor_values(EXAMPLES / "residual-17hz" / "cam.toml")
    zoom_and_pan()
    rows_and_findings()
    before_and_difference()
    several_axes()
    large_table()
    layout()
    print_on_paper()
    right_button()
finally:
    browser.end()
