# SPDX-License-Identifier: Apache-2.0
"""Sobol's sequence as SciPy has it (S. Joe and F. Y. Kuo's direction numbers of 2008, unscrambled): sobol.json.

Each entry is the point times 2^32, for some of the first points and 21 dimensions.
Run: python3 sobol.py > sobol.json        (python3-scipy 1.10)
"""

import json

from scipy.stats import qmc

NUMBERS = [0, 1, 2, 3, 4, 5, 6, 7, 8, 15, 16, 31, 63, 64, 127, 255, 500, 1000, 1023, 4095]
points = qmc.Sobol(d=21, scramble=False, bits=32).random(4096)
# SciPy goes in Gray code's order: its point i is the sequence's point i ^ (i >> 1).
rows = {}
for i in range(4096):
    rows[i ^ (i >> 1)] = [int(x * 2**32) for x in points[i]]
print(json.dumps({"points": [{"number": n, "x": rows[n]} for n in NUMBERS]}))
