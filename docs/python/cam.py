# SPDX-License-Identifier: Apache-2.0
# Designs a cam in code with two motion laws, and compares their peaks at 60 cycles per minute.
import jounce
import matplotlib.pyplot as plt

for law in ("modified_sine", "345"):
    cam = jounce.design_cam(
        [
            jounce.CamSegment(law, 120, 50, name="rise"),  # to 120 deg, 50 mm
            jounce.CamSegment("dwell", 180, 50),
            jounce.CamSegment(law, 300, 0, name="return"),
            jounce.CamSegment("dwell", 360, 0),
        ],
        periodic=True,
    )
    values = jounce.characteristics(law)
    peak = cam.extrema(2).peak
    print(f"{law}: Cv {values.cv:.4f}, Ca {values.ca:.4f}")
    print(f"  {abs(peak.value) * 360**2 / 1000:.2f} m/s^2 at {peak.where:.1f} deg")
    x, motion = cam.sample(0.5)
    plt.plot(x, motion.geo_acceleration, label=law)
plt.xlabel("master [deg]")
plt.ylabel("geo_acceleration [mm/deg^2]")
plt.legend()
plt.savefig("cam.png")

# Output:
#   modified_sine: Cv 1.7596, Ca 5.5280
#     2.49 m/s^2 at 15.0 deg
#   345: Cv 1.8750, Ca 5.7735
#     2.60 m/s^2 at 25.4 deg
