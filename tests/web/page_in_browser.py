#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The live page in a browser: page_in_browser.py CHROMIUM FOLDER ADDRESS_WITH_TOKEN [PICTURE]

With a picture: draws PICTURE.png, PICTURE-dark.png and PICTURE-narrow.png of an axis in motion.
"""
import math
import re
import sys

from browser import Browser

program, folder, address = sys.argv[1:4]
picture = sys.argv[4] if len(sys.argv) > 4 else None
PART = "document.querySelector('[data-is={}]').textContent"


def shows(part, text):
    browser.wait_for(f"document.querySelector('[data-is={part}]') && {PART.format(part)} === '{text}'")


def press(what, yes=True):
    browser.run(f"document.querySelector('button[data-what={what}]').click()")
    browser.wait_for("document.getElementById('ask').open")
    browser.run(f"document.querySelector('#ask button[value={'yes' if yes else 'no'}]').click()")
    browser.wait_for("!document.getElementById('ask').open")


def move_to(position):
    browser.run(f"document.querySelector('form input[type=number]').value = {position}")
    press("move")


def override(percent):
    slider = "document.querySelector('[data-is=slider]')"
    browser.run(f"{slider}.value = {percent}; {slider}.dispatchEvent(new Event('input')); "
                f"{slider}.dispatchEvent(new Event('change'))")
    browser.wait_for("document.getElementById('said').textContent.endsWith('override accepted')")
    shows("override", f"{percent} %")


def cycle_bounds(data, name):
    """The ends of the bins, in us, that the title of a histogram of the cycle names. Over the last bin: infinity."""
    title = browser.run(f"document.querySelector('[data-cycle={data}]').textContent")
    words = re.fullmatch(rf"{name}: half within (over )?(\d+) µs, 99\.9 % within (over )?(\d+) µs", title)
    assert words, title
    for end in int(words[2]), int(words[4]):
        assert end & (end - 1) == 0, f"{title}: each bin ends at a power of two"
    return [math.inf if words[k] else int(words[k + 1]) for k in (1, 3)]


def jog(until, least=1.5, attempts=20):
    """Holds the button of the jog for `least` mm, then releases it with the event `until`.

    A jog of 2 mm/s without a new request ends after 300 ms, which is 0.6 mm. The server also ends a jog if the load of
    the machine delays the requests of the page. The button must then be pressed again.
    """
    button = "document.querySelector('button[data-jog=\"1\"]')"
    state, position = PART.format("state"), f"parseFloat({PART.format('position')})"
    for _ in range(attempts):
        browser.run(f"window.began = {position}; {button}.dispatchEvent(new PointerEvent('pointerdown', {{button: 0}}))")
        browser.wait_for(f"{position} - window.began >= {least} || !{button}.classList.contains('held')")
        held = browser.run(f"{state} === 'continuous motion' && {PART.format('velocity')} === '2 mm/s'")
        browser.run(f"{button}.dispatchEvent(new Event('{until}'))")
        shows("state", "standstill")
        if held:
            return
    raise AssertionError(f"the jog ended before {least} mm in {attempts} attempts")


def inked(canvas="canvas"):
    """True if a plot, that of the position, has pixels in the line's color."""
    return f"(() => {{ const c = document.querySelector('{canvas}');" + """
      const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
      let n = 0;
      for (let i = 0; i < d.length; i += 4) n += d[i + 3] > 128 && d[i + 2] - d[i] > 80;
      return n > 20; })()"""


def test():
    browser.open(address)
    shows("state", "standstill")
    browser.wait_for("document.getElementById('link').textContent === 'live'")
    assert browser.run("!document.querySelector('button[data-what=stop]').disabled")
    move_to(200)
    shows("position", "200 mm")
    assert not browser.run("document.querySelector('[data-is=fault]').checkVisibility()")
    shows("motions", "1 done, 0 stopped")
    browser.wait_for(inked())
    browser.wait_for(inked("canvas[data-bins=computing]"))
    for data, name in ("lateness", "wake-up delay"), ("computing", "computing time"):
        half, nearly_all = cycle_bounds(data, name)
        assert half <= nearly_all, (name, half, nearly_all)
    press("disable", yes=False)
    shows("state", "standstill")
    override(5)
    move_to(0)  # takes 8 s, so that the hold comes before its end on a machine under load as well
    shows("state", "discrete motion")
    press("hold")
    browser.wait_for(f"{PART.format('velocity')} === '0 mm/s' && {PART.format('position')} !== '0 mm'")
    press("stop")
    shows("state", "standstill")
    shows("motions", "1 done, 1 stopped")
    shows("homed", "no")
    override(100)
    browser.run("document.querySelector('[data-is=jog]').value = 2")
    for release in "pointerup", "pointerleave", "blur":
        jog(until=release)
    move_to(1e9)
    browser.wait_for("document.getElementById('said').textContent.includes('was rejected')")
    browser.open(address.split("#")[0])
    shows("state", "standstill")
    assert browser.run("[...document.querySelectorAll('button[data-what],.controls input')].every(b => b.disabled)")
    assert browser.run("!document.getElementById('look').hidden")


def draw():
    browser.open(address)
    browser.wait_for("document.querySelectorAll('section').length > 0")
    import time
    time.sleep(9)
    browser.picture(picture + ".png")
    browser.picture(picture + "-dark.png", dark=True)
    browser.call("Emulation.setDeviceMetricsOverride", width=390, height=800, deviceScaleFactor=1, mobile=True)
    browser.picture(picture + "-narrow.png")


browser = Browser(program, folder)
try:
    draw() if picture else test()
finally:
    browser.end()
