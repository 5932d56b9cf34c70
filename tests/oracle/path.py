#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Paths of several axes with 60 digits: closed forms, the manuals' examples, arcs, blends, ramps.

usage: path.py           writes path.json beside it
       path.py --check   exit status 1 if path.json is not what the script makes

Units: mm, s, rad, pulse where the PMC600 manual has pulses. The expected digits in the text below are those of the
study that this module was planned with; each is compared digit by digit with the number computed here.
"""
import random
import sys
from pathlib import Path

import exact
from mpmath import mp
from paths.cases import make_arcs, make_hermite, make_programs, make_ramps, make_t_blends
from paths.closed_forms import make_rows
from paths.manuals import make_himc, make_pmc600
from paths.maps import make_maps
from paths.study import STUDY


def main():
    target = Path(__file__).with_name("path.json")
    rng = random.Random(23)
    result = {"closed_forms": make_rows(), "pmc600": make_pmc600(), "himc": make_himc(), "arcs": make_arcs(rng),
              "t_blend": make_t_blends(rng), "hermite": make_hermite(rng), "ramps": make_ramps(rng), "programs": make_programs(),
              "maps": make_maps(rng)}
    result["study"] = STUDY
    different = [f"{k}: printed {v['printed']}, computed {mp.nstr(v['computed'], 12)}" for k, v in STUDY.items() if not v["agrees"]]
    print(f"{len(STUDY)} digits of the study, {len(different)} differ", *different, sep="\n  ")
    return exact.finish(target, result)


if __name__ == "__main__":
    sys.exit(main())
