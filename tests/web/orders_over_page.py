#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Orders to an executor over its live page: orders_over_page.py ADDRESS_WITH_TOKEN"""
import json
import sys
import time
import urllib.error
import urllib.request

address, token = sys.argv[1].split("#")


def order(body, **headers):
    request = urllib.request.Request(address + "order", json.dumps(body).encode(), headers)
    try:
        with urllib.request.urlopen(request, timeout=120) as answer:
            return answer.status, json.load(answer)
    except urllib.error.HTTPError as error:
        return error.code, error.read().decode()


def ask(what, expected=200, **value):
    status, said = order({"axis": name, "what": what, **value}, **{"X-Jounce-Token": token})
    assert status == expected, (what, value, status, said)


def axes():
    """The axes, event by event."""
    with urllib.request.urlopen(address + "events", timeout=120) as stream:
        for line in stream:
            if line.startswith(b"data: "):
                yield json.loads(line[6:])["axes"][0]


def wait_for(what, holds):
    for turn, axis in enumerate(axes()):
        if axis["heard"] is not None and holds(axis):
            return axis
        assert turn < 400, (what, axis)


name = next(axes())["name"]
begin = wait_for("enabled", lambda a: a["state"] == "standstill")["position"]
ask("override", value=0.25)
wait_for("override", lambda a: a["override"] == 0.25)
assert order({"axis": name, "what": "move", "value": begin + 1})[0] == 403  # without the token
ask("move", value=begin + 100)
wait_for("moving", lambda a: a["state"] == "discrete_motion" and a["position"] > begin)
ask("stop")
wait_for("stopped", lambda a: a["state"] == "standstill" and a["stopped"] == 1 and a["velocity"] == 0)
ask("override", value=1)
ask("move", value=begin)
wait_for("back", lambda a: a["state"] == "standstill" and abs(a["position"] - begin) < 1e-9)
ask("move", expected=409, value=1e9)  # beyond the axis's range: its own answer comes back

# A hold-to-run jog runs while it is asked for, stops by its release or by silence, and does not begin again by its number.
def hold(number, seconds, velocity):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        ask("jog", value=velocity, hold=number)
        time.sleep(0.1)


def rests(what, reason):
    """At rest within half a second."""
    end = time.monotonic() + 0.5 + 0.5  # and what the machine under test may be late
    axis = wait_for(what, lambda a: a["state"] == "standstill" or time.monotonic() > end)
    assert axis["state"] == "standstill" and axis["velocity"] == 0, (what, axis)
    assert axis["reason"] and axis["reason"]["name"] == reason, (what, axis)
    return axis["position"]


hold(1001, 1, 2)
axis = wait_for("jogging", lambda a: True)
assert axis["state"] == "continuous_motion" and axis["velocity"] == 2, axis
ask("release", hold=1001)
there = rests("released", "released")
assert begin + 0.5 < there < begin + 5, there
ask("jog", expected=409, value=2, hold=1001)  # a request that comes late
assert rests("a late jog", "released") == there
hold(1002, 0.5, -2)
assert rests("silent", "released") < there
ask("jog", expected=409, value=-2, hold=1002)
hold(1003, 0.3, 1)
ask("stop")
rests("stopped in a jog", "stopped")
ask("jog", expected=409, value=1, hold=1003)
hold(1005, 0.2, 1)
hold(1006, 0.3, -1)  # another button: the jog before it has ended
ask("jog", expected=409, value=1, hold=1005)
axis = wait_for("the other jog", lambda a: True)
assert axis["velocity"] == -1, axis
ask("release", hold=1006)
rests("both released", "released")
ask("jog", expected=409, value=1e9, hold=1004)  # faster than the axis
ask("jog", expected=400, value=1)
ask("disable")
wait_for("disabled", lambda a: a["state"] == "disabled")
ask("enable")
wait_for("enabled again", lambda a: a["state"] == "standstill")
