# SPDX-License-Identifier: Apache-2.0
# Checks the cam of a spec, optimizes it, and draws it before and after. Ctrl-C ends the optimization.
import pathlib
import sys

import jounce
import matplotlib.pyplot as plt

spec = pathlib.Path(__file__).parents[2] / "examples/pmc600-cam/cam.toml"
given = jounce.load(spec)
for finding in given.check().broken:
    print(finding)


def progress(done: float, step: str) -> None:
    print(f"\r{done:4.0%} {step}", end="\r", file=sys.stderr)


best = jounce.optimize(given, progress=progress)
for objective in best.data["objectives"]:
    print(f"{objective['objective']}: {objective['given']:.4f}, now {objective['reached']:.4f}, bound {objective['bound']:.4f}")
print("all limits hold" if best.ok and best.design.check() else best)
best.write("better.toml")

for design, label in ((given, "given"), (best.design, "optimized")):
    x, motion = design.curve.sample(0.5)
    plt.plot(x, motion.geo_acceleration, label=label)
limit = given.limits.acceleration
assert limit is not None
plt.axhspan(-limit, limit, alpha=0.1)
plt.xlabel(f"master [{given.x_unit}]")
plt.ylabel(f"geo_acceleration [{given.unit_of('geo_acceleration')}]")
plt.legend()
plt.savefig("optimize.png")

# Output:
#   geo_velocity -3.39227 pulse/pulse at 241.898 pulse (segment 3 return) exceeds the limit -3 pulse/pulse by 13.1 %
#   geo_acceleration -0.161923 pulse/pulse^2 at 217.53 pulse (segment 3 return) exceeds the limit -0.15 pulse/pulse^2 by 7.95 %
#   peak geo_acceleration: 0.1619, now 0.0708, bound 0.0490
#   peak geo_jerk: 0.0203, now 0.0058, bound 0.0025
#   rms geo_acceleration: 0.0634, now 0.0357, bound 0.0335
#   all limits hold
