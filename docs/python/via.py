# SPDX-License-Identifier: Apache-2.0
# Moves two axes through points without a stop, within the bounds of each axis.
import jounce
import matplotlib.pyplot as plt
import numpy as np

points = np.array([[0, 0], [1, 0.5], [2, 0.2], [2.5, 1.5]])  # m
bounds = jounce.Bounds([2, 1], [10, 5], [100, 50])
motion = jounce.via(points, bounds)
print(f"{motion.duration:.3f} s; with a stop at each point {motion.stopping_duration:.3f} s")
for axis, velocity, acceleration, jerk in zip(motion.axes, (2, 1), (10, 5), (100, 50)):
    report = axis.check(jounce.Limits(velocity=velocity, acceleration=acceleration, jerk=jerk))
    print("all limits hold" if report else report)

t = np.linspace(0, motion.duration, 500)
plt.plot(motion.axes[0](t), motion.axes[1](t))
plt.plot(*points.T, "o")
plt.xlabel("x [m]")
plt.ylabel("y [m]")
plt.savefig("via.png")

# Output:
#   2.808 s; with a stop at each point 3.200 s
#   all limits hold
#   all limits hold
