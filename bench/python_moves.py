#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""python_moves.py [COUNT]: a million moves from arrays in one call, and Ruckig's Python module called once for each.

    PYTHONPATH=build/release/python:PATH_OF_RUCKIG bench/python_moves.py

Both plan the same jerk-limited moves of one axis, between random states. The durations are compared. Ruckig's module is
optional. Best of three runs; that of Ruckig is run once."""
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
start = jounce.State(random.uniform(-1, 1, count), random.uniform(-1, 1, count), random.uniform(-5, 5, count))
target = random.uniform(-5, 5, count)
axis = jounce.Bounds(velocity=2, acceleration=10, jerk=100)


def best(work, times=3):
    """The least duration of a call, s, and its result."""
    seconds = []
    for _ in range(times):
        begin = time.perf_counter()
        result = work()
        seconds.append(time.perf_counter() - begin)
    return min(seconds), result


def in_a_loop():
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


ours, moves = best(lambda: jounce.move_to(start, target, axis))
print(f"jounce.move_to, {count} moves from arrays: {ours:.3f} s ({ours / count * 1e9:.0f} ns each)")
single, _ = best(lambda: [jounce.move_to(0, x, axis) for x in target[:10000].tolist()])
print(f"jounce.move_to, one call for each move: {single / min(count, 10000) * 1e9:.0f} ns each")
seconds, _ = best(lambda: jounce.minimum_durations(target, velocity=2, acceleration=10, jerk=100))
print(f"jounce.minimum_durations, {count} moves at rest: {seconds:.3f} s ({seconds / count * 1e9:.0f} ns each)")
if ruckig is None:
    print("Ruckig's module is not installed")
else:
    theirs, durations = best(in_a_loop, times=1)
    print(f"ruckig.calculate, one call for each move: {theirs:.3f} s ({theirs / count * 1e9:.0f} ns each)")
    print(f"ratio {theirs / ours:.1f}; greatest difference of the durations {np.abs(durations - moves.duration).max():.1e} s")
