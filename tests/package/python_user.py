# SPDX-License-Identifier: Apache-2.0
"""Plans and checks a move with the installed package, without any other file of the sources."""
import jounce

axis = jounce.Bounds(velocity=500, acceleration=5000, jerk=1e5)  # mm/s, mm/s^2, mm/s^3
move = jounce.move_to(0, 100, axis)
assert move.duration > 100 / 500, move
assert move.check(axis.limits).ok, move
print(f"python: {move.duration:.4f} s for 100 mm")
