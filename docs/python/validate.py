# SPDX-License-Identifier: Apache-2.0
# Proves a cam by integration, and drives a model of the servo axis along it.
import pathlib

import jounce
import matplotlib.pyplot as plt

spec = pathlib.Path(__file__).parents[2] / "examples/pmc600-cam/cam.toml"
proof = jounce.validate(spec, samples=2001)
print("proven" if proof.ok else proof)
print("witness agrees to 1e-11:", proof.data["witness"]["curve"]["position"] < 1e-11)
signals = proof.signals
print(f"peak torque {abs(signals['torque']).max():.3f} N m")

figure, (torque, error) = plt.subplots(2, sharex=True)
torque.plot(signals["time"], signals["torque"])
torque.set_ylabel("torque [N m]")
error.plot(signals["time"], signals["following_error"])
error.set_ylabel("following error [pulse]")
error.set_xlabel("time [s]")
plt.savefig("validate.png")

# Output:
#   proven
#   witness agrees to 1e-11: True
#   peak torque 0.100 N m
