#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The live page in a browser: page_in_browser.py CHROMIUM FOLDER ADDRESS_WITH_TOKEN [PICTURE]

With a picture: draws PICTURE.png, PICTURE-dark.png and PICTURE-narrow.png of an axis in motion.
"""
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


def inked(canvas="canvas"):
    """True if a plot, that of the position, has pixels in the line's colour."""
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
    move_to(40)
    shows("position", "40 mm")
    assert not browser.run("document.querySelector('[data-is=fault]').checkVisibility()")
    shows("motions", "1 done, 0 stopped")
    browser.wait_for(inked())
    browser.wait_for(inked("canvas[data-bins=computing]"))
    told = "document.querySelector('[data-cycle=computing]').textContent"
    assert browser.run(f"/^computed: half within [0-9]+ µs, 99.9 % within .* µs$/.test({told})")
    press("disable", yes=False)
    shows("state", "standstill")
    override(5)
    move_to(0)
    shows("state", "discrete motion")
    press("hold")
    browser.wait_for(f"{PART.format('velocity')} === '0 mm/s' && {PART.format('position')} !== '0 mm'")
    press("stop")
    shows("state", "standstill")
    shows("motions", "1 done, 1 stopped")
    shows("homed", "no")
    override(100)
    jog, button = "document.querySelector('[data-is=jog]')", "document.querySelector('button[data-jog=\"1\"]')"
    browser.run(f"{jog}.value = 2; {button}.dispatchEvent(new PointerEvent('pointerdown', {{button: 0}}))")
    shows("velocity", "2 mm/s")
    browser.run("new Promise((done) => setTimeout(done, 500))")
    shows("state", "continuous motion")
    browser.run(f"{button}.dispatchEvent(new PointerEvent('pointerup'))")
    shows("state", "standstill")
    for leaves in "pointerleave", "blur":
        browser.run(f"{button}.dispatchEvent(new PointerEvent('pointerdown', {{button: 0}}))")
        shows("velocity", "2 mm/s")
        browser.run(f"{button}.dispatchEvent(new Event('{leaves}'))")
        shows("state", "standstill")
    move_to(1e9)
    browser.wait_for("document.getElementById('said').textContent.includes('was rejected')")
    browser.open(address.split("#")[0])
    shows("state", "standstill")
    assert browser.run("[...document.querySelectorAll('button[data-what],section input')].every(b => b.disabled)")
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
