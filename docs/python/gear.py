# SPDX-License-Identifier: Apache-2.0
# Engages a gear over 90 deg of its master, and shifts its phase by 5 mm later.
import jounce
import matplotlib.pyplot as plt

ratio = 1 / 3  # mm/deg
cam = jounce.gear(
    [jounce.GearChange(90, ratio, 90, law="345")],  # from rest: 90 to 180 deg
    master_end=720,
    shifts=[jounce.GearShift(360, 5, 180)],  # 360 to 540 deg
)
print(f"after the clutch {cam(180):.4f} mm, at the end {cam(720):.4f} mm")
peak = cam.extrema(1).max
print(f"greatest ratio {peak.value:.4f} mm/deg at {peak.where:.0f} deg")
over_time = cam.over_time(jounce.trapezoid(0, 720, velocity=360, acceleration=1440).curve)
print("keeps 150 mm/s:", bool(over_time.check(jounce.Limits(velocity=150))))
x, slave = cam.sample(1)
plt.plot(x, slave.geo_velocity)
plt.xlabel("master [deg]")
plt.ylabel("ratio [mm/deg]")
plt.savefig("gear.png")

# Output:
#   after the clutch 15.0000 mm, at the end 200.0000 mm
#   greatest ratio 0.3854 mm/deg at 450 deg
#   keeps 150 mm/s: True
