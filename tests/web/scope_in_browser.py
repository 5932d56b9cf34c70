#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The traces of the live page: scope_in_browser.py CHROMIUM FOLDER ADDRESS_WITH_TOKEN [PICTURE]

The axis feeder plays a cam with 120 periods in a minute: modified sine, 40 mm in 0.25 s and back. The peaks of its
motion are those of VDI 2143: the velocity is Cv 40 mm / 0.25 s, the acceleration Ca 40 mm / (0.25 s)^2.
"""
import math
import sys
import time

from browser import Browser

program, folder, address = sys.argv[1:4]
picture = sys.argv[4] if len(sys.argv) > 4 else None
browser = Browser(program, folder, height=1400)
SCOPE = "axes.get('feeder').scope"
# The script of a page that was just opened may not have run.
HAS_DATA = "typeof axes !== 'undefined' && axes instanceof Map && axes.get('feeder')?.scope?.data?.ticks.length > 500"
# Characteristic values of the modified sine: Cv = 4 pi / (pi + 4), Ca = 4 pi^2 / (pi + 4).
CV, CA = 4 * math.pi / (math.pi + 4), 4 * math.pi**2 / (math.pi + 4)
VELOCITY, ACCELERATION = CV * 40 / 0.25, CA * 40 / 0.25**2


def caption(plot):
    return browser.run(f"document.querySelector('figure[data-plot=\"{plot}\"] figcaption').textContent")


def set_part(part, value):
    browser.run(f"(() => {{ const e = document.querySelector('[data-scope={part}]'); e.value = '{value}'; "
                "e.dispatchEvent(new Event('change')); })()")


def facts(words):
    browser.wait_for(f"document.querySelector('[data-scope=facts]').textContent.includes('{words}')")


def range_of(plot):
    """The least and the greatest value in the title of a plot."""
    low, high = caption(plot).split(": ")[1].split(" to ")
    return [float(text.replace("−", "-")) for text in (low, high)]


def peaks_are_exact():
    """The window has 120 periods. The peak of the velocity is in a tick, that of the acceleration between two ticks."""
    assert range_of("position") == [0, 40], caption("position")
    for plot, peak in ("velocity", VELOCITY), ("acceleration", ACCELERATION):
        low, high = range_of(plot)
        error = 1e-6 if plot == "velocity" else (4 * math.pi / 250) ** 2 / 8
        for value in -low, high:
            assert peak * (1 - error) <= value <= peak * (1 + 1e-6), (plot, value, peak)


def modified_sine(t):
    """The position at the time t of a period of 0.5 s, mm: VDI 2143."""
    rise, z = t < 0.25, t % 0.25 / 0.25
    flip, z = z > 0.5, min(z, 1 - z)
    c = math.pi / (math.pi + 4)
    s = c * (z - math.sin(4 * math.pi * z) / (4 * math.pi)) if z < 0.125 else (
        c * (z + 2 / math.pi - 9 / (4 * math.pi) * math.sin((math.pi + 4 * math.pi * z) / 3)))
    s = 1 - s if flip else s
    return 40 * (s if rise else 1 - s)


def is_the_cam(ticks, positions):
    """Each position is that of the law; the tick of the start is not known."""
    def error(start):
        return max(abs(p - modified_sine((k - start) % 500 / 1000)) for k, p in zip(ticks, positions))
    few = list(zip(ticks, positions))[::50]
    best = min(range(500), key=lambda start: max(abs(p - modified_sine((k - start) % 500 / 1000)) for k, p in few))
    assert error(best) < 1e-6, error(best)


def test():
    browser.open(address)
    browser.wait_for("document.querySelectorAll('figure[data-plot=\"velocity\"] canvas').length === 2")
    browser.wait_for(HAS_DATA)
    # A window of 60 s has many ticks in a bucket; no extreme value is lost.
    set_part("span", 60)
    facts("extreme values of every 86 cycles")
    browser.wait_for(f"{SCOPE}.data.each === 86")
    peaks_are_exact()
    # A trigger at half of the lift, rising: the picture stands still.
    set_part("span", 1)
    set_part("signal", "position")
    set_part("level", 20)
    set_part("mode", "normal")
    facts("triggered")
    browser.wait_for(f"{SCOPE}.data.span !== 60 && {SCOPE}.data.trigger !== null")
    places = [browser.run(f"(() => {{ const d = {SCOPE}.data; const i = d.ticks.findIndex((t) => t >= d.trigger);"
                          "return [d.low.position[i - 1], d.high ? d.high.position[i] : d.low.position[i]]; })()")
              for _ in range(3)]
    for before, after in places:
        assert before < 20 <= after, places
    # Single: the first trigger after the choice freezes the picture, with every tick.
    set_part("mode", "single")
    browser.wait_for(f"{SCOPE}.frozen && {SCOPE}.data.each === 1")
    facts("frozen")
    first = browser.run(f"{SCOPE}.data.trigger")
    time.sleep(1)
    assert browser.run(f"{SCOPE}.data.trigger") == first, "a frozen picture has changed"
    count, missing = browser.run(f"[{SCOPE}.data.ticks.length, {SCOPE}.data.missing]")
    assert 1001 - missing - 50 < count <= 1001 - missing, (count, missing)
    # Zoom and cursor by keys.
    canvas = "document.querySelector('figure[data-plot=\"velocity\"] canvas')"
    browser.run(f"{canvas}.focus(); {canvas}.dispatchEvent(new KeyboardEvent('keydown', {{key: '+', bubbles: true}}))")
    assert browser.run(f"{SCOPE}.range[1] - {SCOPE}.range[0]") == 500
    browser.run(f"{canvas}.dispatchEvent(new KeyboardEvent('keydown', {{key: 'ArrowRight', bubbles: true}}))")
    browser.wait_for("!document.querySelector('figure[data-plot=\"velocity\"] figcaption').textContent.includes(' to ')")
    # The file has every tick of the window.
    browser.run("save = (name, text) => { window.saved = [name, text]; }; document.querySelector('[data-scope=csv]').click()")
    browser.wait_for("window.saved")
    name, text = browser.run("window.saved")
    lines = text.strip().split("\n")
    heads = lines[0].split(",")
    assert name.startswith("feeder-") and name.endswith(".csv"), name
    assert heads[:3] == ["time_s", "tick", "position_mm"] and "velocity_mm/s" in heads, heads
    assert len(lines) == 1 + count, (len(lines), count)
    rows = [[float(cell) for cell in line.split(",")[:3]] for line in lines[1:]]
    assert all(abs(time_s - tick / 1000) < 1e-9 for time_s, tick, _ in rows)
    is_the_cam([int(row[1]) for row in rows], [row[2] for row in rows])
    browser.run("document.querySelector('[data-scope=freeze]').click()")
    browser.wait_for(f"!{SCOPE}.frozen")
    set_part("mode", "off")
    # The table is in the library, in use.
    browser.wait_for("document.querySelector('#tables figure.active') !== null")
    table = browser.run("document.querySelector('#tables figure.active figcaption').textContent")
    assert "361 knots over the master 0 to 360 deg, position 0 to " in table, table
    # All commands: the fields come from the table of commands; a rejected one is in the list of events with its remedy.
    browser.run("document.querySelectorAll('.orders')[1].open = true")
    order = "document.querySelectorAll('.orders')[1]"
    browser.wait_for(f"{order}.querySelector('select').length > 20")
    send(order, "move", {"to": "12mm", "velocity": "50"})
    assert browser.run(f"{order}.querySelector('code').textContent") == "jounce order knife move --to 12mm --velocity 50"
    browser.wait_for("document.getElementById('said').textContent === 'knife: move accepted'")
    browser.wait_for("document.querySelectorAll('[data-is=position]')[1].textContent === '12 mm'")
    send(order, "move", {"to": "9 m"})
    browser.wait_for("document.getElementById('said').textContent.includes('knife: move was rejected')")
    browser.wait_for("document.querySelector('#log li.kind-rejected')?.textContent.includes('knife')")
    assert browser.run("document.querySelector('#log li.kind-rejected p').textContent") != ""
    group = "document.querySelectorAll('.orders optgroup')[1]"
    browser.run("document.querySelectorAll('.orders')[0].open = true")
    browser.wait_for(f"[...{group}.children].some((option) => option.value === 'move-linear')")
    # The path of the two axes.
    browser.run("document.getElementById('path').scrollIntoView()")
    browser.wait_for("document.querySelector('[data-path=facts]').textContent.startsWith('set position (')")
    # A page without the token shows the traces, too, and sends nothing.
    browser.open(address.split("#")[0])
    browser.wait_for(HAS_DATA)
    assert browser.run("document.querySelector('.orders button').disabled")


def send(order, what, options):
    browser.run(f"(() => {{ const s = {order}.querySelector('select'); s.value = '{what}'; s.dispatchEvent(new Event('change')); }})()")
    for option, text in options.items():
        browser.run(f"(() => {{ const i = {order}.querySelector('[data-option={option}]'); i.value = '{text}'; "
                    "i.dispatchEvent(new Event('input', {bubbles: true})); })()")
    browser.run(f"{order}.querySelector('form button').click()")
    browser.wait_for("document.getElementById('ask').open")
    browser.run("document.querySelector('#ask button[value=yes]').click()")


def draw():
    browser.open(address)
    browser.wait_for(HAS_DATA)
    set_part("span", 1)
    set_part("level", 20)
    set_part("mode", "normal")
    browser.run("document.querySelectorAll('.orders')[0].open = true")
    time.sleep(3)
    browser.picture(picture + ".png")
    browser.picture(picture + "-dark.png", dark=True)
    browser.call("Emulation.setDeviceMetricsOverride", width=390, height=800, deviceScaleFactor=1, mobile=True)
    browser.picture(picture + "-narrow.png")


try:
    draw() if picture else test()
finally:
    browser.end()
