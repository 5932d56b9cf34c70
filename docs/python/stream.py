# SPDX-License-Identifier: Apache-2.0
# Starts an executor with a simulated axis, moves the axis, and streams a motion to it.
import pathlib
import subprocess

import jounce
import matplotlib.pyplot as plt

pathlib.Path("axis.toml").write_text("""
jounce = 1
kind = "axis"
name = "feeder"
units = { position = "mm" }
axis = { cycle = "1 ms" }
limits = { velocity = "500 mm/s", acceleration = "5000 mm/s^2", jerk = "100000 mm/s^3" }
""")
url = f"unix://{pathlib.Path('bus').absolute()}"
log = "run.csv"
executor = subprocess.Popen(["jounce", "run", "axis.toml", "--url", url, "--log", log, "--seconds", "60"],
                            stdout=subprocess.DEVNULL)
try:
    with jounce.Client("feeder", url=url, patience=10) as axis:
        axis.status(timeout=10)  # waits until the executor runs
        axis.enable()
        axis.move_absolute(20, velocity=200)
        print(axis.wait_for_rest(), f"{axis.status().position:.3f} mm")
        motion = jounce.move_to(20, 70, jounce.Bounds(200, 2000, 50000))
        axis.stream(motion.curve.table(x_unit="s", position_unit="mm"))
        print(axis.wait_for_rest(), f"{axis.status().position:.3f} mm")
        try:
            axis.move_absolute(20, velocity=900)
        except jounce.AxisError as error:
            print(error.error, error.refusal)
finally:
    executor.terminate()
    executor.wait()

rows = [line.split(",") for line in pathlib.Path(log).read_text().splitlines() if line[0].isdigit()]
plt.plot([float(row[1]) for row in rows], [float(row[5]) for row in rows])
plt.xlabel("time [s]")
plt.ylabel("position [mm]")
plt.savefig("stream.png")

# Output:
#   standstill 20.000 mm
#   standstill 70.000 mm
#   refused velocity_limit
