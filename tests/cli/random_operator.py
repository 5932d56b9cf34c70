#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""random_operator.py JOUNCE [ORDERS [SEED]]: three operators send random orders, right and wrong, to a machine of seven axes
and a group, in the present folder; the tick logs are judged. With TRACE=1, each order is printed with its answer.

The orders and their options come from `jounce order --help`, so a new order or option is drawn without a change here. The
operators also stream tables, stop axes, and kill their own programs. The judge has only the limits of the axes:

- each program ends with exit status 0 to 3, and explains every status but 0;
- the position of each axis is within its range, its velocity, its acceleration and the step of its acceleration
  within the limits, at every tick, over all orders;
- a replay of the record gives the same run."""
import itertools
import math
import os
import random
import re
import signal
import subprocess
import sys
import threading
import time

from tick_log import rows

# name: (units, velocity, acceleration, jerk, least and greatest position, further lines)
AXES = {
    "feeder": ("mm", 500, 5000, 1e5, -10, 300, ""),
    "turret": ("deg", 360, 3600, 72000, -math.inf, math.inf, "modulo = 360\n"),
    "free": ("mm", 300, 3000, 6e4, -math.inf, math.inf, ""),
    "label": ("mm", 400, 8000, 4e5, -200, 900, ""),
    "slide": ("mm", 200, 2000, 5e4, -5, 280, "require_home = true\n"),
    "x": ("mm", 200, 2000, 5e4, -1, 300, ""),
    "y": ("mm", 200, 2000, 5e4, -1, 300, ""),
}
SLIDE = """
[homing]
method = 13
search_velocity = 100
index_velocity = 10
offset = 5
timeout = "20 s"
[drive]
type = "null"
[drive.machine]
encoder_offset = 140
home_switch = { position = 20, width = 15 }
negative_switch = { position = 0 }
positive_switch = { position = 320 }
index = { period = 10, offset = 4 }
"""
CYCLE = 1e-3
STOP = 1.1  # a stop may use this factor of the limits, the least that a spec permits
GROUP = "plotter"


def write_machine():
    with open("machine.toml", "w", encoding="utf-8") as file:
        file.write('jounce = 1\nkind = "machine"\n')
        for name in AXES:
            follow = '\nfollow = { axis = "free" }' if name == "label" else ""
            file.write(f'[[axis]]\nspec = "{name}.toml"{follow}\n')
        file.write(f'[[group]]\nname = "{GROUP}"\naxes = ["x", "y"]\n')
    for name, (unit, velocity, acceleration, jerk, least, greatest, more) in AXES.items():
        master = ', master = "mm"' if name == "label" else ""
        least = f"position_min = {least}\nposition_max = {greatest}\n" if least > -math.inf else ""
        with open(f"{name}.toml", "w", encoding="utf-8") as file:
            file.write(f'jounce = 1\nkind = "axis"\nname = "{name}"\nunits = {{ position = "{unit}"{master} }}\n'
                       f'[axis]\ncycle = "1 ms"\nlongest_gap = "30 s"\nsession_timeout = "10 s"\n'
                       f'stop_acceleration = {STOP * acceleration}\nstop_jerk = {STOP * jerk}\n{more}'
                       f'[limits]\nvelocity = {velocity}\nacceleration = {acceleration}\njerk = {jerk}\n{least}'
                       + (SLIDE if name == "slide" else ""))


class Grammar:
    """The orders of `jounce order`, and for each its options and whether it takes a value."""

    def __init__(self, jounce):
        self.jounce = jounce
        text = self.call("--help")
        what = re.search(r"\n  WHAT\s+(.*?)\n  VALUE", text, re.S)[1].split(". start ")[0]
        options = re.findall(r"\n  (--[a-z0-9-]+)( \.\.\.)?", text)
        self.flags = {name for name, value in options if not value}
        self.orders = {order: self.options(order) for order in re.findall(r"[a-z][a-z-]+", what)}

    def call(self, *words):
        done = subprocess.run([self.jounce, "order", *words], capture_output=True, text=True, check=False)
        return done.stdout + done.stderr

    def options(self, order):
        """From the rejections of options that belong to other orders."""
        printed = self.call("absent", order, "--hold-to-run") + self.call("absent", order, "--relative")
        return set(re.findall(r"VALUE|--[a-z0-9-]+", " ".join(re.findall(r"which (.*)", printed))))


def number(draw, unit=""):
    value = draw.choice([0, 1, -1, 2.5, 10, 20, 50, 80, 120, 200, 300, -30, 1000, 1e-9, 1e6, draw.uniform(-20, 320), draw.uniform(0, 100)])
    return f"{value:.9g}{unit}"


ODD = ["nan", "-inf", "1e400", "", "abc", "3:2", "1:0", "0:1", "1,0", "0,0", "10,20", "shortest", "next", "falling", "50%", "-5%", "0",
       "1e-300", "12mmm", "x=10", "x=1 m", "30,0,0", "low", "5s", "7mm", "90deg", "2mm/s", "-1", "1e9",
       "4294967296", "99999999999999999999"]
CHOICES = {"--blend": ["low", "previous", "next", "high", "look-ahead"], "--direction": ["shortest", "positive", "negative"],
           "--edge": ["rising", "falling", "both"], "--along": ["1,0", "0,1", "-1,1", "3,-2", "0,0"], "--second": ["1:2", "-1:3"],
           "--zyz": ["30,0,0", "0,0,90"], "--method": ["13", "37", "24", "1"], "--axis": ["1", "2", "3"], "--strokes": ["1", "3"],
           "--count": ["0", "1", "3"], "--at": ["1", "5000", "100000"], "--m-word": ["6"], "--turns": ["0", "1", "2"],
           "--wait": ["0", "0.1"], "--seconds": ["0.2"], "--timeout": ["1", "20s"], "--radius": ["40", "-60", "300"]}
VALUES = {"gear-in": ["1:1", "3:2", "-1:2", "5:1", "1:7"], "override": ["0%", "30%", "100%", "150%", "200%"],
          "touch-probe": ["1", "home", "index"], "abort-trigger": ["1", "home", "index"], "wait": ["0", "0.1", "0.5s"], "m-word": ["6", "8"]}
VALUES["gear-in-pos"] = VALUES["combine"] = VALUES["gear-in"]


def argument(draw, name, what, unit):
    """A value of an option, or of the order itself."""
    if draw.random() < 0.08:
        return draw.choice(ODD)
    fitting = VALUES.get(what) if name == "VALUE" else CHOICES.get(name)
    if fitting:
        return draw.choice(fitting)
    if name in ("--via", "--center") or (name in ("--to", "--by") and what.startswith("move-")):
        return f"{draw.uniform(0, 300):.4g},{draw.uniform(0, 300):.4g}"
    if name.endswith("-factor"):
        return draw.choice(["30%", "100%", "150%", "60%"])
    if name.endswith("velocity") or what in ("jog", "change-velocity"):
        return number(draw, draw.choice(["", unit + "/s"]))
    if name in ("--acceleration", "--deceleration", "--jerk"):
        return f"{draw.choice([1, 100, 1000, 1e4, 1e5, 1e7])}"
    return number(draw, draw.choice(["", "", unit]))


def order(draw, grammar):
    """A random order; most are correct in themselves."""
    name = draw.choice([*AXES, *AXES, GROUP, GROUP, GROUP, "absent" if draw.random() < 0.1 else GROUP])
    unit = AXES.get(name, ("mm",))[0]
    frequent = ["move-linear", "move-linear", "move-circular", "move-direct", "start"] if name == GROUP else ["move", "move", "jog", "inch"]
    if name == "label":
        frequent += ["gear-in", "gear-in", "gear-in-pos", "gear-out", "phasing", "combine"]
    if name == "slide":
        frequent += ["home"]
    what = draw.choice([*frequent, "halt", "hold", "resume", "override"] if draw.random() < 0.6 else list(grammar.orders))
    has = grammar.orders[what]
    words = [name, what]
    coordinates = name == GROUP and what.startswith("move-")
    if coordinates and draw.random() < 0.8:
        has = has - {"--to", "--by"}
        words += [f"x={draw.uniform(-5, 310):.4g}", f"y={draw.uniform(0, 300):.4g}"][:draw.choice([1, 2, 2])]
    elif "VALUE" in has:
        words.append(argument(draw, "VALUE", what, unit))
    one = [option for option in ("--to", "--by", "--add", "--on-top") if option in has]
    if one and "VALUE" not in has:
        option = draw.choice(one)
        words += [option, argument(draw, option, what, unit)]
    others = sorted(has - {"VALUE", *one, "--at" if draw.random() < 0.9 else ""})
    if draw.random() < 0.05:  # an option of another order
        others = sorted(set().union(*grammar.orders.values()) - {"VALUE"})
    if others and draw.random() < 0.7:
        for option in draw.sample(others, min(len(others), draw.choice([1, 1, 2, 3]))):
            words += [option] if option in grammar.flags else [option, argument(draw, option, what, unit)]
    return ["order", *words]


TABLES = {  # a file, and the axis that it fits
    "turn.toml": ("turret", 'kind = "move"\nunits = { position = "deg" }\n[move]\nprofile = "s_curve"\nfrom = 0\nto = 360\nvelocity = 200\n'
                            'acceleration = 2000\njerk = 40000\n'),
    "go.toml": ("feeder", 'kind = "move"\nunits = { position = "mm" }\n[move]\nprofile = "s_curve"\nfrom = 0\nto = 100\n'
                          'velocity = 400\nacceleration = 4000\njerk = 90000\n'),
    "cam.toml": ("label", 'kind = "cam"\nperiodic = true\nunits = { position = "mm", master = "mm" }\nstart = { master = 0, slave = 0 }\n'
                          '[[segment]]\nlaw = "modified_sine"\nend = { master = 60, slave = 20 }\n'
                          '[[segment]]\nlaw = "quintic"\nend = { master = 120, slave = 0 }\n'),
}


def stream(draw):
    file = draw.choice(list(TABLES))
    name = TABLES[file][0] if draw.random() < 0.8 else draw.choice([*AXES, GROUP])
    return ["stream", file, "--to", name, *(["--live"] if file == "cam.toml" else []),
            *draw.choice([[], [], ["--relative"], ["--rolling"], ["--no-wait"], ["--start-at", "20"], ["--swap", file],
                          ["--until", "arm"]])]


class Operator(threading.Thread):
    def __init__(self, jounce, seed, orders):
        super().__init__()
        self.jounce, self.draw, self.count, self.grammar = jounce, random.Random(seed), orders, Grammar(jounce)
        self.statuses, self.failures = {}, []

    def call(self, words):
        kill = self.draw.random() < 0.05
        process = subprocess.Popen([self.jounce, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                   errors="backslashreplace")
        wait = self.draw.uniform(0.02, 1.5) if kill or words[0] == "stream" or "--hold-to-run" in words or "--at" in words else 60
        try:
            printed, _ = process.communicate(timeout=wait)
        except subprocess.TimeoutExpired:
            process.send_signal(self.draw.choice([signal.SIGKILL, signal.SIGINT]))
            process.communicate()
            if wait == 60:
                self.failures.append(f"no end in {wait} s: jounce {' '.join(words)}")
            return
        status = process.returncode
        self.statuses[status] = self.statuses.get(status, 0) + 1
        if os.environ.get("TRACE"):
            print(f"[{status}] {' '.join(words)}\n    {printed.strip()}", flush=True)
        if status not in (0, 1, 2, 3) or (status and len(printed.split()) < 4):
            self.failures.append(f"exit status {status}: jounce {' '.join(words)}\n{printed}")

    def run(self):
        for _ in range(self.count):
            kind = self.draw.random()
            name = self.draw.choice([*AXES, GROUP])
            if kind < 0.04:
                self.call(["stop", name])
            elif kind < 0.10:
                self.call(stream(self.draw))
            elif kind < 0.25:
                self.call(["order", name, self.draw.choice(["reset", "enable"])])
            else:
                self.call(order(self.draw, self.grammar))


def judge(log, limits):
    """The number of judged pairs of ticks."""
    _, velocity, acceleration, jerk, least, greatest, _ = limits
    judged, broken = 0, []
    near = 1 + 1e-9
    previous = None
    for tick, row in rows(log):
        p, v, a = (float(row[key]) for key in ("position", "velocity", "acceleration"))
        if previous and row["state"] != "disabled":  # without power, the drive brakes the axis
            tick0, p0, v0, a0, row0 = previous
            dt = (tick - tick0) * CYCLE
            for what, value, bound in (("velocity", abs(v), velocity), ("acceleration", abs(a), STOP * acceleration),
                                       ("velocity step", abs(v - v0), STOP * acceleration * dt),
                                       ("acceleration step", abs(a - a0), STOP * jerk * dt + 1e-9 * acceleration)):
                if value > bound * near + 1e-12:
                    broken.append(f"{log} tick {tick}: {what} {value:.9g} of {bound:.9g}, {row0['state']} to {row['state']}")
            counts = row["homed"] == "1" or "require_home" not in limits[6]
            if counts and not least - 1e-9 <= p <= greatest + 1e-9:
                broken.append(f"{log} tick {tick}: position {p} of [{least}, {greatest}], {row['state']}")
            step = p - p0
            if "modulo" in limits[6]:
                step -= 360 * round(step / 360)
            if abs(step) > velocity * dt * near + 1e-9 and (v or v0):
                broken.append(f"{log} tick {tick}: position step {step} at {v}, {row0['state']} to {row['state']}")
            judged += 1
        previous = tick, p, v, a, row
    return judged, broken


def main(jounce, orders=300, seed=1):
    write_machine()
    for file, (_, text) in TABLES.items():
        with open(file, "w", encoding="utf-8") as out:
            out.write("jounce = 1\n" + text)
    with open("run.txt", "w", encoding="utf-8") as printed:
        executor = subprocess.Popen([jounce, "run", "machine.toml", "--enable", "--watchdog", "30", "--log", "log.csv",
                                     "--record", "run.lcmlog", "--seconds", "1500"], stderr=printed, stdout=printed)
        time.sleep(1)
        if executor.poll() is not None:
            sys.exit(f"no executor: {open('run.txt', encoding='utf-8').read()}")
        operators = [Operator(jounce, seed * 1000 + i, orders // 3) for i in range(3)]
        for one in operators:
            one.start()
        for one in operators:
            one.join()
        alive = executor.poll() is None
        executor.send_signal(signal.SIGINT)
        status = executor.wait()
    failures = list(itertools.chain.from_iterable(one.failures for one in operators))
    if not alive or status not in (0, 1):
        failures.append(f"the executor ended with status {status}")
    pairs = 0
    for name, limits in AXES.items():
        judged, broken = judge(f"log.{name}.csv", limits)
        pairs += judged
        failures += broken[:3] + [f"and {len(broken) - 3} more"] * (len(broken) > 3)
    replay = subprocess.run([jounce, "replay", "run.lcmlog"], capture_output=True, text=True, check=False)
    if replay.returncode:
        failures.append(f"replay: {replay.stdout[-500:]}{replay.stderr[-500:]}")
    statuses = {}
    for one in operators:
        for key, count in one.statuses.items():
            statuses[key] = statuses.get(key, 0) + count
    print(f"orders by exit status: {dict(sorted(statuses.items()))}; {pairs} pairs of ticks judged")
    if not statuses.get(0) or pairs < 1000:
        failures.append("no order was accepted, or nothing was judged")
    if failures:
        sys.exit(f"FAILED (seed {seed}):\n" + "\n".join(failures))


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:4]))
