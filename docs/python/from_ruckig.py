# SPDX-License-Identifier: Apache-2.0
# The first program of a Ruckig user, ported: three axes that arrive together, one setpoint in each control cycle.
import jounce
import matplotlib.pyplot as plt

cycle = 0.01  # s
generator = jounce.OnlineGenerator(3, sync="time")  # Ruckig(3, cycle)
generator.set_state(jounce.State([0.0, 0.0, 0.5], [0.0, -2.2, -0.5], [0.0, 2.5, -0.5]))  # current_...
generator.set_bounds(jounce.Bounds([3.0, 1.0, 3.0], [3.0, 2.0, 1.0], [4.0, 3.0, 2.0]))  # max_...
generator.set_target(jounce.State([5.0, -2.0, -3.5], [0.0, -0.5, -2.0], [0.0, 0.0, 0.5]))  # target_...

rows = []
arrived = False
while not arrived:  # result == Result.Working
    arrived = generator.step(cycle).arrived  # update(), pass_to_input()
    rows.append([float(p) for p in generator.motion.position])
    if len(rows) == 1:
        print(f"duration {generator.remaining + cycle:.4f} s")
    if len(rows) % 100 == 0:
        print(f"{len(rows) * cycle:.3f}", *(f"{p:.3f}" for p in rows[-1]), sep="\t")
print(f"{len(rows)} cycles")

plt.plot([(i + 1) * cycle for i in range(len(rows))], rows)
plt.xlabel("time [s]")
plt.legend(["axis 0", "axis 1", "axis 2"])
plt.savefig("from_ruckig.png")

# Output:
#   duration 3.4387 s
#   1.000	0.656	-1.194	-0.097
#   2.000	3.301	-1.510	-0.943
#   3.000	4.944	-1.817	-2.602
#   344 cycles
