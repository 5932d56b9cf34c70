# SPDX-License-Identifier: Apache-2.0
# Plans a square with rounded corners, and plots the velocities of its axes.
import jounce
import matplotlib.pyplot as plt

path = jounce.parse_path("""jounce = 1
kind = "path"
units = { position = "mm" }
path = { velocity = 200, corner = { deviation = 0.5 } }
axis = [{ name = "x", limits = { acceleration = 2000, jerk = 50000 } },
        { name = "y", limits = { acceleration = 2000, jerk = 50000 } }]
command = [{ type = "line", to = [100, 0] }, { type = "line", to = [100, 100] },
           { type = "line", to = [0, 100] }, { type = "line", to = [0, 0] }]
""")
t, motion = path.sample(0.001)
print(f"axes {path.axes}, {path.duration:.4f} s, positions {motion.position.shape}")
print(f"greatest acceleration {abs(motion.acceleration).max():.0f} mm/s^2; all limits hold: {path.ok}")
plt.plot(t, motion.velocity, label=path.axes)
plt.xlabel("t [s]")
plt.ylabel("velocity [mm/s]")
plt.legend()
plt.savefig("path.png")

# Output:
#   axes ['x', 'y'], 2.5144 s, positions (2516, 2)
#   greatest acceleration 2000 mm/s^2; all limits hold: True
