# SPDX-License-Identifier: Apache-2.0
# Makes the smallest table that keeps a tolerance, and writes it for a controller.
import jounce
import matplotlib.pyplot as plt
import numpy as np

cam = jounce.design_cam([jounce.CamSegment("modified_sine", 180, 50), jounce.CamSegment("345", 360, 0)], periodic=True)
for tolerance in (1, 0.1, 0.01):  # mm
    table = cam.reduced_table("cubic_hermite", tolerance=tolerance, x_unit="deg", position_unit="mm")
    assert table.error is not None
    print(f"{tolerance} mm: {len(table)} knots, error {table.error.position:.4f} mm at {table.error.where:.1f} deg")

x = np.linspace(0, 360, 2001)
plt.plot(x, table(x) - cam(x))
plt.plot(table.x, np.zeros(len(table)), "|")
plt.xlabel("master [deg]")
plt.ylabel("table - cam [mm]")
plt.savefig("table.png")

conversion = jounce.convert(cam.table(x_unit="deg", position_unit="mm"), "cam.st")  # CODESYS, Structured Text
print(conversion)

# Output:
#   1 mm: 6 knots, error 0.3894 mm at 121.2 deg
#   0.1 mm: 9 knots, error 0.0725 mm at 116.7 deg
#   0.01 mm: 15 knots, error 0.0058 mm at 330.0 deg
#   table -> codesys: 6 knots, quintic_hermite
#   the numbers are unchanged
#
