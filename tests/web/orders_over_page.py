#!/usr/bin/env python3
"""Orders to an executor over its live page: orders_over_page.py ADDRESS_WITH_TOKEN"""
import json
import sys
import urllib.error
import urllib.request

address, token = sys.argv[1].split("#")


def order(body, **headers):
    request = urllib.request.Request(address + "order", json.dumps(body).encode(), headers)
    try:
        with urllib.request.urlopen(request, timeout=20) as answer:
            return answer.status, json.load(answer)
    except urllib.error.HTTPError as error:
        return error.code, error.read().decode()


def ask(what, expected=200, **value):
    status, said = order({"axis": name, "what": what, **value}, **{"X-Jounce-Token": token})
    assert status == expected, (what, value, status, said)


def axes():
    """The axes, event by event."""
    with urllib.request.urlopen(address + "events", timeout=20) as stream:
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
ask("disable")
wait_for("disabled", lambda a: a["state"] == "disabled")
ask("enable")
wait_for("enabled again", lambda a: a["state"] == "standstill")
