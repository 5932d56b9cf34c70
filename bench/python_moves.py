#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""python_moves.py [COUNT]: a million moves from arrays in one call, and Ruckig's Python module called once for each.

    PYTHONPATH=build/release/python:PATH_OF_RUCKIG bench/python_moves.py

Both plan the same jerk-limited moves of one axis: from rest to rest, and from random states. The durations are compared.
Ruckig's module is optional. Wall time and processor time of all cores; best of three runs, one run of Ruckig."""
import sys
import time

import jounce
import numpy as np

try:
    import ruckig
except ImportError:
    ruckig = None

count = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
random = np.random.default_rng(1)
target = random.uniform(-5, 5, count)
axis = jounce.Bounds(velocity=2, acceleration=10, jerk=100)
rest = jounce.State(np.zeros(count), np.zeros(count), np.zeros(count))
moving = jounce.State(random.uniform(-1, 1, count), random.uniform(-1, 1, count), random.uniform(-5, 5, count))


def best(work, times=3):
    """The least wall time and processor time of a call, s, and its result."""
    wall, processor = [], []
    for _ in range(times):
        begin = time.perf_counter(), time.process_time()
        result = work()
        wall.append(time.perf_counter() - begin[0])
        processor.append(time.process_time() - begin[1])
    return min(wall), min(processor), result


def show(what, wall, processor, number):
    print(f"  {what:<44} {wall / number * 1e9:6.0f} ns wall, {processor / number * 1e9:6.0f} ns processor, each")


def in_a_loop(start):
    """Ruckig's module, with what a user sets for each move."""
    otg, given, made = ruckig.Ruckig(1), ruckig.InputParameter(1), ruckig.Trajectory(1)
    given.max_velocity, given.max_acceleration, given.max_jerk = [2.0], [10.0], [100.0]
    positions, velocities, accelerations, targets = (x.tolist() for x in (*start, target))
    durations = []
    for p, v, a, to in zip(positions, velocities, accelerations, targets):
        given.current_position = [p]
        given.current_velocity = [v]
        given.current_acceleration = [a]
        given.target_position = [to]
        otg.calculate(given, made)
        durations.append(made.duration)
    return np.array(durations)


for name, start in (("from rest to rest", rest), ("from random states", moving)):
    print(f"{count} moves {name}")
    wall, processor, moves = best(lambda: jounce.move_to(start, target, axis))
    show("jounce.move_to, one call for all", wall, processor, count)
    if ruckig is None:
        print("  Ruckig's module is not installed")
        continue
    their_wall, their_processor, durations = best(lambda: in_a_loop(start), times=1)
    show("ruckig.calculate, one call for each", their_wall, their_processor, count)
    error = np.abs(durations - moves.duration).max()
    print(f"  ratio {their_wall / wall:.1f} wall, {their_processor / processor:.1f} processor; durations agree to {error:.1e} s")
few = target[:10000].tolist()
show("jounce.move_to, one call for each", *best(lambda: [jounce.move_to(0, x, axis) for x in few])[:2], len(few))
show("jounce.minimum_durations, one call for all",
     *best(lambda: jounce.minimum_durations(target, velocity=2, acceleration=10, jerk=100))[:2], count)
