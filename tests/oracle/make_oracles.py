#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes oracles.json: numbers that the tests compare the library against, computed without any of its code.

    laws             classical rest-to-rest laws: coefficients and samples       laws.py         VDI 2143 and handbooks
    pmc600_fig_6_14  four quintic cam segments with their printed extrema         controllers.py  PMC600 manual 6.2
    chain_rule       that cam behind a trapezoidal master, to the jerk            controllers.py  PMC600 manual 6.2
    googol_7_1       trapezoid, plain and smoothed                                controllers.py  Googol iDEABOX ex. 7-1
    hmpl_5_2_8       PVT table as cubic Hermite, its overshoot                    controllers.py  HIMC HMPL manual 5.2.8
    s_curves         60 seven-segment moves                                       moves.py        bisection
    trapezoids       30 asymmetric trapezoids                                     moves.py        bisection
    hermite_error    true interpolation error of a sampled cycloid                tables.py       critical points
    gear             floor(p n / q) for huge n                                    tables.py       integers
    bounds           what no law can beat; least effort between end states        bounds.py       optimal control

Everything is computed with 60 digits (mpmath) and written with 17, keys sorted, so that the file is the same on
every machine. Inputs are doubles in shortest form and every result belongs to exactly those doubles. At a knot a
value is the right limit, at the end of the domain the left limit. null stands for infinite or for "no such value".

Numbers printed in the sources are checked digit by digit; a disagreement stops the script before it writes.
With --check nothing is written: the exit status is 0 if oracles.json is up to date.
"""
import sys
import time
from pathlib import Path

import bounds
import controllers
import exact
import laws
import moves
import tables

MAKERS = {
    "laws": laws.make,
    "pmc600_fig_6_14": controllers.make_cam,
    "chain_rule": controllers.make_chain_rule,
    "googol_7_1": controllers.make_googol,
    "hmpl_5_2_8": controllers.make_pvt,
    "s_curves": moves.make_s_curves,
    "trapezoids": moves.make_trapezoids,
    "hermite_error": tables.make_hermite_error,
    "gear": tables.make_gear,
    "bounds": bounds.make,
}


def main():
    target = Path(__file__).with_name("oracles.json")
    result = {}
    for name, make in MAKERS.items():
        start = time.monotonic()
        result[name] = make()
        print(f"{name:16} {time.monotonic() - start:6.1f} s", flush=True)
    return exact.finish(target, result)


if __name__ == "__main__":
    sys.exit(main())
