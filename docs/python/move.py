# SPDX-License-Identifier: Apache-2.0
# Plans, checks and plots a move.
import jounce
import matplotlib.pyplot as plt

axis = jounce.Bounds(velocity=2, acceleration=10, jerk=100)  # m/s, m/s^2, m/s^3
move = jounce.move_to(0, 1, axis)
print(move)
print(move.check(axis.limits))
t, motion = move.sample(0.001)
figure, plots = plt.subplots(4, sharex=True, layout="constrained")
for plot, name, unit in zip(plots, motion._fields, ("m", "m/s", "m/s²", "m/s³")):
    plot.plot(t, getattr(motion, name))
    plot.set_ylabel(f"{name}\n[{unit}]")
plots[-1].set_xlabel("time [s]")
plt.savefig("move.png")

# Output:
#   Move(duration=0.8, start=0, end=1, phases=7)
#     ok     limit/velocity             velocity 2 at 0.3 (segment 3) just meets the limit 2
#     ok     limit/acceleration         acceleration 10 at 0.1 (segment 1) just meets the limit 10
#     ok     limit/jerk                 jerk 100 at 0 (segment 1) just meets the limit 100
#
