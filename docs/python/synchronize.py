# SPDX-License-Identifier: Apache-2.0
# Moves two axes on a straight line, and compares it with axes that only arrive together.
import jounce
import matplotlib.pyplot as plt
import numpy as np

bounds = jounce.Bounds([2, 1], [10, 5], [100, 50])  # m/s, m/s^2, m/s^3
for sync in ("phase", "time", "none"):
    moves = jounce.synchronize([0, 0], [1, 0.3], bounds, sync=sync)  # type: ignore[arg-type]
    print(f"{sync:6} x {moves.duration[0]:.4f} s, y {moves.duration[1]:.4f} s")
    x, y = moves.at(np.linspace(0, moves.duration.max(), 200)[:, None]).position.T
    plt.plot(x, y, label=sync)
plt.xlabel("x [m]")
plt.ylabel("y [m]")
plt.legend()
plt.savefig("synchronize.png")

# Output:
#   phase  x 0.8000 s, y 0.8000 s
#   time   x 0.8000 s, y 0.8000 s
#   none   x 0.8000 s, y 0.6000 s
