#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""wrong_orders.py JOUNCE: sends each order of `jounce order --help` with a wrong value, to an axis and a group in each state.

No order is accepted. The message

  - repeats the option or VALUE and the wrong value if `jounce order` rejects it (exit status 2);
  - gives the wrong value with its unit and the limit, or names the state, and in both cases the next step, if the executor
    rejects it (exit status 1). In standstill, the state is not a reason."""
import concurrent.futures
import os
import re
import subprocess
import sys
import tempfile

JOUNCE = os.path.abspath(sys.argv[1])
# An order with a wrong value: what the message repeats.
AXIS = {
    "move --to 40000": "40000 mm",
    "move --by 5kg": "--by = 5kg",
    "move --by 40000": "400\\d\\d(\\.\\d+)? mm",
    "move --to 10 --velocity 9000": "9000 mm/s.*--velocity",
    "move --to 10 --acceleration 90000": "90000 mm/s\\^2.*--acceleration",
    "move --to 10 --deceleration 90000": "90000 mm/s\\^2.*--deceleration",
    "move --to 10 --jerk 1e9": "1e9 mm/s\\^3.*--jerk",
    "move --to 10 --velocity=-5": "--velocity = -5 mm/s",
    "move --to 10 --blend fast": "--blend = fast",
    "move --to 10 --direction up": "--direction = up",
    "inch 1 --velocity 9000": "9000 mm/s.*--velocity",
    "jog 9000": "9000 mm/s",
    "halt --deceleration 90000": "90000 mm/s\\^2.*--deceleration",
    "override 400%": "VALUE = 400%",
    "set-position 3s": "VALUE = 3s",
    "set-position 40000": "40000 mm",
    "home --method 99": "--method = 99",
    "home --search-velocity 9000": "9000 mm/s.*--search-velocity",
    "home --timeout=-1": "--timeout = -1 s",
    "home --distance=-1": "--distance = -1 mm",
    "gear-in 1:0": "VALUE = 1:0",
    "gear-in 2 --clutch=-5": "--clutch = -5 mm",
    "gear-in-pos 1 --master-sync 100 --slave-sync 50 --start-distance=-10": "--start-distance = -10 mm",
    "gear-out --deceleration 9": "--deceleration = 9",
    "cam-out 5": "VALUE = 5",
    "phasing --by 5kg": "--by = 5kg",
    "combine 3 --second 1:0": "--second = 1:0",
    "change-velocity=-5": "=-5",
    "repeat --to 40000": "40000 mm",
    "repeat --to 10 --wait=-1": "--wait = -1 s",
    "repeat --to 10 --strokes=-1": "--strokes = -1",
    "touch-probe 9": "VALUE = 9",
    "touch-probe 1 --edge up": "--edge = up",
    "touch-probe 1 --count=-1": "--count = -1",
    "abort-trigger 5": "VALUE = 5",
    "cut --length 5kg": "--length = 5kg",
    "start 5": "VALUE = 5",
    "enable 3": "VALUE = 3",
    "disable 3": "VALUE = 3",
    "reset 4": "VALUE = 4",
    "hold 3": "VALUE = 3",
    "resume 3": "VALUE = 3",
    "park 3": "VALUE = 3",
    "finish 4": "VALUE = 4",
    "enable-compensation 3": "VALUE = 3",
    "disable-compensation 3": "VALUE = 3",
}
GROUP = {
    "move-linear x=40000": "x = 40000 mm",
    "move-linear z=10": "VALUE = z=10",
    "move-linear x=10 --blend low --deviation=-1": "--deviation = -1 mm",
    "move-direct x=40000": "x = 40000 mm",
    "move-circular x=900 y=900 --radius 1": "--radius = 1 mm",
    "move-circular x=10 y=10 --via 5s,3": "--via: x = 5s",
    "wait=-5": "=-5",
    "wait 1e9": "1e9 s",
    "jog 9 --along 0,0": "jog",
    "set-coordinate-transform x=10kg": "x = 10kg",
    "set-coordinate-transform x=10 --rotation 10mm": "--rotation = 10mm",
    "set-limits --velocity=-1": "--velocity = -1 mm/s",
    "set-limits --axis 9 --velocity 5": "--axis = 9",
    "set-override --velocity-factor 300%": "--velocity-factor = 300%",
    "set-override --acceleration-factor 0%": "--acceleration-factor = 0%",
    "set-override --jerk-factor 200%": "--jerk-factor = 200%",
    "m-word 3 --timeout=-1": "--timeout = -1 s",
    "m-word 1.5": "VALUE = 1.5",
    "acknowledge --m-word 1.5": "--m-word = 1.5",
    "single-step 3": "VALUE = 3",
}
# In motion, an aborting command ends the motion before the plan: these follow it.
NEXT_OF_GROUP = {text + (" --buffered" if re.match("move-|jog", text) and "--blend" not in text else ""): wanted
                 for text, wanted in GROUP.items()}
STATE = re.compile(r"not_enabled|in_motion|no_movement|not_synchronized|in_error|is disabled|live master|one master|"
                   r"follows its master|cutter|no_compensation|stopping")
STEP = re.compile(r"`jounce order|\b[Gg]ive |\b[Aa]dd |[Ss]tart a motion|must be |does not apply|is not |[Rr]aise|[Ww]ait")
LIMIT = re.compile(r"limit \S+ mm|must be |position range|does not apply|is not |has no length")


def spec(name, more="", acceleration=5000):
    with open(name + ".toml", "w", encoding="utf-8") as file:
        file.write(f'jounce = 1\nkind = "axis"\nname = "{name}"\nunits = {{ position = "mm", master = "mm" }}\n[axis]\n'
                   "longest_gap = \"60 s\"\n"
                   f"{more}[limits]\nvelocity = 500\nacceleration = {acceleration}\njerk = 1e5\n"
                   "position_min = -10\nposition_max = 30000\n")


def jounce(*words):
    return subprocess.run([JOUNCE, *words, "--url", "unix://bus"], capture_output=True, text=True, timeout=20, check=False)


def order(name, *words):
    answer = jounce("order", name, *words)
    if answer.returncode != 0:
        sys.exit(f"{name} {' '.join(words)}: {answer.stdout}{answer.stderr}")


def reach(name, state):
    answer = jounce("monitor", name, "--until", state, "--seconds", "10", "--silence", "10")
    if state not in answer.stdout:
        sys.exit(f"{name} is not in {state}: {answer.stdout}{answer.stderr}")


def fault_of(state, answer, wanted):
    message = answer.stderr.strip()
    repeated = re.search(wanted, message) is not None
    if answer.returncode not in (1, 2):
        return f"exit status {answer.returncode}"
    if answer.returncode == 2:
        return "" if repeated else f"does not repeat {wanted}"
    if not STEP.search(message):
        return "no next step"
    if state != "standstill" and STATE.search(message):
        return ""
    if "live master" in message or "cutter" in message or "no_movement" in message:
        return ""
    return "" if repeated and LIMIT.search(message) else "no value, or no limit"


def errors(name, state, orders):
    with concurrent.futures.ThreadPoolExecutor(4) as operators:
        answers = operators.map(lambda text: jounce("order", name, *text.split()), orders)
    for (text, wanted), answer in zip(orders.items(), answers):
        fault = fault_of(state, answer, wanted)
        if fault:
            yield f"{name} ({state}), {text}: {fault}: {answer.stdout}{answer.stderr}".rstrip()
    now = jounce("monitor", name, "--seconds", "0.2", "--json").stdout
    if f'"{state}"' not in now:
        yield f"{name} is no longer in {state}: {now[:200]}"


def all_errors():
    yield from errors("axis", "disabled", AXIS)
    yield from errors("plotter", "disabled", GROUP)
    for name in ("axis", "press", "slave", "slow", "broken", "x", "y", "plotter"):
        order(name, "enable")
    order("slow", "jog", "100")  # it becomes fast during the next states, so that it stops slowly
    yield from errors("axis", "standstill", AXIS)
    yield from errors("plotter", "standstill", GROUP)
    order("slave", "gear-in", "1")
    order("press", "jog", "1")
    reach("slave", "synchronized_motion")
    yield from errors("slave", "synchronized_motion", AXIS)
    order("axis", "move", "--to", "29000", "--velocity", "1")
    yield from errors("axis", "discrete_motion", AXIS)
    order("plotter", "move-linear", "x=29000", "--velocity", "1")
    yield from errors("plotter", "discrete_motion", NEXT_OF_GROUP)
    jounce("order", "broken", "home", "--method", "24", "--timeout", "10ms")
    reach("broken", "error_stop")
    yield from errors("broken", "error_stop", AXIS)
    stop = subprocess.Popen([JOUNCE, "stop", "slow", "--url", "unix://bus"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    reach("slow", "stopping")
    yield from errors("slow", "stopping", AXIS)
    stop.kill()
    stop.wait()


def main():
    os.mkdir("bus")
    spec("axis")
    spec("press")
    spec("slave", '[follow]\naxis = "press"\n')
    spec("slow", "stop_acceleration = 5.5\n", 5)
    spec("broken", '[drive]\ntype = "null"\n[drive.machine]\nhome_switch = { position = 9000, width = 15 }\n')
    spec("x")
    spec("y")
    names = ("axis", "press", "slave", "slow", "broken", "x", "y")
    with open("machine.toml", "w", encoding="utf-8") as file:
        file.write('jounce = 1\nkind = "machine"\n' + "".join(f'[[axis]]\nspec = "{name}.toml"\n' for name in names) +
                   '[[group]]\nname = "plotter"\naxes = ["x", "y"]\n')
    with open("output", "w", encoding="utf-8") as output:
        executor = subprocess.Popen([JOUNCE, "run", "machine.toml", "--url", "unix://bus", "--watchdog", "30", "--seconds", "120"],
                                    stdout=output, stderr=output)
    try:
        reach("plotter", "disabled")
        found = list(all_errors())
    finally:
        executor.kill()
        executor.wait()
    for one in found:
        print(one)
    return 1 if found else 0


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        sys.exit(main())
