# SPDX-License-Identifier: Apache-2.0
# Plans, checks and plots a move.
import jounce
import matplotlib.pyplot as plt

axis = jounce.Bounds(velocity=2, acceleration=10, jerk=100)  # m/s, m/s^2, m/s^3
move = jounce.move_to(0, 1, axis)
print(move)
print(move.check(axis.limits))
t, motion = move.sample(0.001)
for row, (name, values) in enumerate(motion._asdict().items()):
    plt.subplot(4, 1, row + 1, ylabel=name).plot(t, values)
plt.savefig("move.png")
