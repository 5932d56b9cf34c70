#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The planned path of a group on the live page: group_in_browser.py CHROMIUM FOLDER ADDRESS GROUP [PICTURE]

GROUP is the robot of examples/scara, the plotter of examples/plotter or the head of examples/welding-head, whose program
is started by the test. With a
picture: draws PICTURE.png, PICTURE-dark.png and PICTURE-narrow.png.
"""
import json
import math
import sys
import time
import urllib.request

from browser import Browser

program, folder, address, group = sys.argv[1:5]
picture = sys.argv[5] if len(sys.argv) > 5 else None
browser = Browser(program, folder, height=1400)
browser.call("Page.addScriptToEvaluateOnNewDocument", source="window.errors = [];"
             "addEventListener('error', (e) => errors.push(e.message));"
             "addEventListener('unhandledrejection', (e) => errors.push(String(e.reason)));"
             "addEventListener('securitypolicyviolation', (e) => errors.push(e.violatedDirective + ' ' + e.blockedURI));")
FACTS = "document.querySelector('[data-path=facts]').textContent"
ARMS = 300, 250  # mm: examples/scara/kinematics.toml


def read(path):
    with urllib.request.urlopen(address.split("#")[0] + path, timeout=60) as answer:
        return json.load(answer)


def order(what):
    """Sends a command until the group has accepted it: it rests only after it is enabled."""
    for _ in range(100):
        if browser.run(f"post('/command', {{axis: '{group}', what: '{what}', value: '', options: {{}}, flags: []}})", True):
            return
        time.sleep(0.2)
    raise AssertionError(what + ": " + browser.run("document.body.innerText"))


def traced(axis, span=10):
    """The set positions of an axis by the tick, from the executor."""
    data = read(f"trace?axis={axis}&span={span}&buckets=0")
    return dict(zip(data["ticks"], data["low"]["position"]))


def distance_to(line, point):
    """Distance of a point from a polygon."""
    best = math.inf
    for (x0, y0), (x1, y1) in zip(line, line[1:]):
        dx, dy = x1 - x0, y1 - y0
        square = dx * dx + dy * dy
        share = 0 if square == 0 else min(max(((point[0] - x0) * dx + (point[1] - y0) * dy) / square, 0), 1)
        best = min(best, math.hypot(x0 + share * dx - point[0], y0 + share * dy - point[1]))
    return best


def robot():
    """The tool of the picture is where the forward kinematics of the joints puts it, in each cycle."""
    assert browser.run("[...document.querySelector('[data-path=x]').options].map((o) => o.value).join()") == "x,y,z"
    browser.wait_for("path.seen.get('robot')?.places.size > 1000")
    first, second = traced("a0"), traced("a1")
    tool = {int(tick): place for tick, place in browser.run("[...path.seen.get('robot').places]")}
    compared = most = 0
    for tick, (x, y, _) in tool.items():
        if tick not in first or tick not in second:
            continue
        a, b = math.radians(first[tick]), math.radians(first[tick] + second[tick])
        most = max(most, math.hypot(ARMS[0] * math.cos(a) + ARMS[1] * math.cos(b) - x, ARMS[0] * math.sin(a) + ARMS[1] * math.sin(b) - y))
        compared += 1
    assert compared > 1000, compared
    chord = 0.01  # mm: of the corners with a deviation of 5 mm, in 64 chords
    print(f"robot: {compared} cycles, greatest distance {most:.2e} mm")
    assert most < chord, most
    # Up and down at the two places: in the plane of x and z.
    browser.run("(() => { const s = document.querySelector('[data-path=y]'); s.value = 'z'; s.dispatchEvent(new Event('change')); })()")
    heights = browser.run("path.planned().map(([, z]) => z)")
    assert min(heights) == 0 and abs(max(heights) - 60) < 1e-9, (min(heights), max(heights))
    browser.run("(() => { const s = document.querySelector('[data-path=y]'); s.value = 'y'; s.dispatchEvent(new Event('change')); })()")


def plotter():
    """The set positions of the axes are on the planned path; their place is in the text."""
    assert browser.run("[...document.querySelector('[data-path=x]').options].map((o) => o.value).join()") == "x,y"
    browser.wait_for("path.trail().places.length > 500 && path.trail().places.some(([x, y], i, [[left, lower]]) =>"
                     " Math.hypot(x - left, y - lower) > 10)")
    line, places = browser.run("path.planned()"), browser.run("path.trail().places")
    moved = max(math.hypot(x - places[0][0], y - places[0][1]) for x, y in places)
    most = max(distance_to(line, place) for place in places[::10])
    print(f"plotter: {len(places)} cycles over {moved:.1f} mm, greatest distance {most:.2e} mm")
    assert moved > 10 and most < 0.01, (moved, most)


def shown_units(command, **options):
    """The units in the fields of a command of the head, after these options are typed."""
    typed = json.dumps(options)
    return browser.run(f"""(async () => {{
        const {{orders}} = axes.get('head');
        await orders.fill();
        orders.select.value = '{command}';
        orders.show();
        for (const [name, text] of Object.entries({typed})) {{
          const input = orders.fields.querySelector(`[data-option="${{name}}"]`);
          input.value = text;
          input.dispatchEvent(new Event('input', {{bubbles: true}}));
        }}
        return Object.fromEntries([...orders.fields.querySelectorAll('[data-option]')].map((i) => [i.dataset.option, i.placeholder]));
    }})()""", True)


def head():
    """A move of the follower alone has the unit of the follower, as the executor reads it."""
    assert browser.run("[...document.querySelector('[data-path=x]').options].map((o) => o.value).join()") == "x,y,c"
    assert shown_units("move-linear")["to"] == "mm, mm, deg"
    for to, unit in (("", "mm"), ("x=10", "mm"), ("c=90deg", "deg"), (",,90", "deg"), ("x=10,c=90", "mm"), ("10,,90", "mm")):
        units = shown_units("move-linear", to=to)
        assert units["velocity"] == unit + "/s" and units["jerk"] == unit + "/s^3", (to, units)
    assert shown_units("set-limits", axis="3")["velocity"] == "deg/s"
    assert shown_units("set-limits", axis="y")["velocity"] == "mm/s"
    assert shown_units("set-limits")["velocity"] == "mm/s"
    print("head: the units of its moves")


def draw():
    browser.picture(picture + ".png")
    browser.picture(picture + "-dark.png", dark=True)
    browser.call("Emulation.setDeviceMetricsOverride", width=390, height=800, deviceScaleFactor=1, mobile=True)
    browser.picture(picture + "-narrow.png")


try:
    browser.open(address)
    browser.wait_for("typeof path !== 'undefined' && path.groups?.length > 0")
    order("enable")
    order("start")
    browser.run("document.getElementById('path').scrollIntoView()")
    browser.wait_for(f"{FACTS}.startsWith('planned path (dashed); set position (')")
    {"robot": robot, "plotter": plotter, "head": head}[group]()
    assert browser.run("document.querySelector('#path canvas').getAttribute('aria-label')").startswith("x and y: planned path")
    if picture:
        draw()
    assert browser.run("errors.join('; ')") == "", browser.run("errors.join('; ')")
finally:
    browser.end()
