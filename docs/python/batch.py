# SPDX-License-Identifier: Apache-2.0
# Compares a million candidates for a pick-and-place axis in one call, and keeps the fastest order of three stops.
import itertools

import jounce
import matplotlib.pyplot as plt
import numpy as np

axis = jounce.Bounds(velocity=2, acceleration=10, jerk=100)  # m/s, m/s^2, m/s^3
places = np.random.default_rng(0).uniform(0, 2, (166_666, 4))  # m: a start and three stops
orders = np.array([(0, *order) for order in itertools.permutations((1, 2, 3))])
routes = places[:, orders]  # shape: trays, orders, stops
duration = jounce.minimum_durations(np.diff(routes), velocity=2, acceleration=10, jerk=100).sum(axis=-1)
best = duration.min(axis=-1)
print(f"{duration.size} routes; the best order saves {1 - best.mean() / duration.mean():.1%} on average")

tray = routes[0, duration[0].argmin()]
moves = jounce.move_to(tray[:-1], tray[1:], axis)  # Moves: all of one tray
print("first tray:", moves, "duration", round(float(moves.duration.sum()), 3), "s")

plt.hist(duration[:, 0], bins=100, label="given order")
plt.hist(best, bins=100, alpha=0.7, label="best order")
plt.xlabel("duration [s]")
plt.legend()
plt.savefig("batch.png")

# Output:
#   999996 routes; the best order saves 18.5% on average
#   first tray: Moves(shape=(3,), exist=3) duration 1.457 s
